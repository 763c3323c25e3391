"""The order of search:
always a centre whose side of the polygon closes two triangles of known centres (Kennedy–Aronhold)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import combinations

from ....errors import NoMethodError
from ....mechanism.asked.centres import Pair, real_links
from ....mechanism.model import Mechanism
from ....plane import Line
from ....words import Words
from ..geometry import SHORT, Centre, Through, meeting, parallel, same, sharpness, through

FAR = 0.1  # what a line is worth that is drawn to a centre off the paper
GOOD = 0.26  # sine (15°) from which a meeting is certain


@dataclass(frozen=True, slots=True, kw_only=True)
class Way:
    """A line on which a centre lies: through its two centres with the link `via`,
    or the common normal of a contact (via "").

    `at`: the two centres are one, and the one sought is there too.
    """

    via: str
    line: Through = None
    at: Centre | None = None
    base: float = 1.0  # how far apart its two centres are, 1 where far enough


@dataclass(frozen=True, slots=True, kw_only=True)
class Search:
    """One centre to be found next, and the way or the two ways that give it."""

    pair: Pair
    ways: tuple[Way, ...]
    quality: float
    endless: bool = False
    trial: tuple[str, tuple[str, str, str], float] | None = (
        None  # by a trial triangle: the link, three others, where its first corner stands
    )


@dataclass(slots=True)
class Known:
    """The centres found so far, and the common normals of contacts."""

    mech: Mechanism
    centres: dict[Pair, Centre] = field(default_factory=dict)
    normals: Mapping[Pair, Line] = field(default_factory=dict)
    far: frozenset[Pair] = frozenset()  # centres off the paper: lines through them are a last resort
    rank: Mapping[str, int] = field(init=False, repr=False)  # the links by number, the frame last

    def __post_init__(self) -> None:
        self.rank = {name: n for n, name in enumerate(real_links(self.mech))}

    def pair(self, a: str, b: str) -> Pair:
        """Two links in the order of their numbers."""
        return (a, b) if self.rank[a] < self.rank[b] else (b, a)

    def of(self, a: str, b: str) -> Centre:
        """A known centre."""
        return self.centres[self.pair(a, b)]

    def missing(self) -> tuple[Pair, ...]:
        """Pairs of links without a centre."""
        return tuple(pair for pair in combinations(self.rank, 2) if pair not in self.centres)

    def ways(self, pair: Pair) -> Iterator[Way]:
        """All lines on which this centre is known to lie."""
        if pair in self.normals:
            yield Way(via="", line=self.normals[pair])
        for via in self.rank:
            if via in pair:
                continue
            if all(self.pair(via, link) in self.centres for link in pair):
                yield self.way(pair, via)

    def way(self, pair: Pair, via: str) -> Way:
        """The line through the two centres that the links of a pair have with a third."""
        if not via:
            return Way(via="", line=self.normals[pair])
        a, b = (self.of(via, link) for link in pair)
        if same(a, b):
            return Way(via=via, at=a)
        base = 1.0 if a.at is None or b.at is None else min(1.0, abs(a.spot() - b.spot()) / SHORT)
        away = [self.pair(via, link) in self.far for link in pair]
        line = through(b, a) if away[0] else through(a, b)  # starting on the paper
        return Way(via=via, line=line, base=base * FAR ** sum(away))

    def on_paper(self, pair: Pair) -> tuple[Line, ...]:
        """The lines through a centre off the paper that pass a centre on it, or are normals."""
        lines = []
        for way in self.ways(pair):
            ends = [self.pair(way.via, link) for link in pair] if way.via else []
            if way.line is not None and (
                not ends or any(not self.centres[end].endless and end not in self.far for end in ends)
            ):
                lines.append(way.line)
        return tuple(lines)


def order(
    known: Known, accuracy: float, by_trial: Callable[[Known], Search | None] = lambda _: None
) -> Iterator[Search]:
    """Every missing centre in an order in which each is found from known ones; `known` grows.

    The first pair of lines that meet well is taken, else the best; where no two lines meet, what `by_trial` finds.
    Raises NoMethodError where nothing leads further.
    """
    while missing := known.missing():
        chosen = _next(known, missing, accuracy) or by_trial(known)
        if chosen is None:
            names = ", ".join("P_" + "".join(known.mech.number(name) for name in pair) for pair in missing)
            raise NoMethodError(
                Words(
                    f"用三心定理求不出其余瞬心（缺 {names}）：没有两条过已知瞬心的直线交于其中之一；"
                    "可用 vecpoly exact 由速度求得",
                    f"the theorem of three centres leads to no further centre ({names} are missing): no two "
                    "lines through known centres meet in one of them; 'vecpoly exact' gives them from the "
                    "velocities",
                )
            )
        known.centres[chosen.pair] = found(chosen)
        yield chosen


def _next(known: Known, missing: tuple[Pair, ...], accuracy: float) -> Search | None:
    """The first centre whose lines meet well, else the one whose lines meet best."""
    options = []
    for pair in missing:
        if (option := _best(pair, tuple(known.ways(pair)), accuracy)) is not None:
            if option.quality >= GOOD:
                return option
            options.append(option)
    return max(options, key=lambda one: one.quality, default=None)


def found(search: Search) -> Centre:
    """The centre that a search gives."""
    coincident = next((way.at for way in search.ways if way.at is not None), None)
    return coincident or meeting(search.ways[0].line, search.ways[1].line, search.endless)


def _best(pair: Pair, ways: tuple[Way, ...], accuracy: float) -> Search | None:
    """The sharpest meeting of two ways; a way that is a point needs no other."""
    point = next((way for way in ways if way.at is not None), None)
    if point is not None:
        return Search(pair=pair, ways=(point,), quality=1.0)
    trials = [
        Search(
            pair=pair,
            ways=two,
            quality=sharpness(two[0].line, two[1].line) * two[0].base * two[1].base,
            endless=_endless(*two, accuracy),
        )
        for two in combinations(ways, 2)
    ]
    best = next((one for one in trials if one.quality >= GOOD), None) or max(
        trials, key=lambda one: one.quality, default=None
    )
    return best if best is not None and best.quality > 0 else None


def _endless(one: Way, two: Way, accuracy: float) -> bool:
    return one.line is None or two.line is None or parallel(one.line, two.line, accuracy)
