"""Scales exchanged where a figure that says little has the room of one that is read: the diagram of the mechanism, on
which everything is constructed, is not small beside a polygon, nor a vector short beside a figure that is large; of
like scales those with which the sheets have no broad hole."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import islice, product
from math import inf, log, sqrt
from operator import itemgetter

from ....board.construction import View
from ....board.paper.scales import Sketched, coarser, finer
from ....board.place import Place
from ....foundation.slotted import dataclass
from ..space import LARGEST, PLATE, SPARSE
from .balancing import GROWS, MOTION
from .composition import READ, Composing, Scales, by_place, usual
from .growing import MOST
from .holes import hole

WIDE, CRANK, ARM = 130.0, 15.0, 12.0  # mm: of a mechanism; between its nearest two pins; the shortest that is measured
LOW, SEEN = 75.0, 60.0  # mm: of any other figure; no smaller for the sake of the mechanism
SHRUNK = 0.75  # of its size, if it is smaller already
UNLIKE = 1.9  # times as long as a polygon of motion a mechanism is at most
SLENDER = 0.45  # of its length: a figure that is lower than this looks smaller than it is long
THIN = 0.1  # the same of one that is a line
LONE = 60.0  # mm: of a polygon of one vector, which says no more if it is longer
GAIN = 0.08  # for which scales are changed at all
_SMALL, _LOW, _SHORT, _OVER, _LARGE = 1.0, 1.0, 0.8, 1.0, 0.2  # what weighs each of these, by its logarithm
_HOLE = 3.0  # the same of a hole, as a share of its sheet
SMALL_HOLE, BROAD = 0.1, 0.15  # a hole that is no fault; one that is not made larger
FINEST, COARSEST = 4, {True: 2, False: 4}  # steps: of any figure; of the mechanism, of another
MANY, FEW = 4, 2  # kinds of figure, of which there are too many scales; so many steps then
TRIED = 12  # scales that are compared by the holes that they leave

Pages = tuple[Composing, ...]


@dataclass(frozen=True, slots=True)
class Trial:
    """A kind of figure at a scale: how long it is and how large it looks (mm), what of it is bad by itself, and whether
    it is one vector."""

    kind: Place
    scale: float
    long: float
    looks: float
    bad: float
    lone: bool


def exchanged(pages: Sequence[Pages], scales: Scales, kinds: set[Place]) -> Scales:
    """These scales of some kinds, or others for as many sheets at which what is read is clearly larger.

    pages: all figures on sheets that lie either way, as large as they are planned and as they may turn out: none of
    these may ask for more sheets than one did before.
    """
    room = _Room(pages, scales)
    now = _bad([_trial(room.page, kind, scales[kind]) for kind in kinds], room.page, scales)
    found = islice((one for one in _better(room.page, scales, kinds, now) if room.holds(one[1])), TRIED)
    before = room.hole(scales)
    weighed = [(bad + _HOLE * white, trial) for bad, trial in found if (white := room.hole(trial)) < max(before, BROAD)]
    bad, best = min(weighed, key=itemgetter(0), default=(inf, scales))
    return best if bad < now + _HOLE * before - GAIN else scales


class _Room:
    """The sheets on which figures stand at some scales, and whether others do with as many."""

    def __init__(self, pages: Sequence[Pages], before: Scales) -> None:
        self.pages, self.page = pages, pages[0][0]
        self.sheets = min(one.needed(before) for some in pages for one in some)
        self._never = list[Scales]()
        self._roomy = min(1.0, self.page.roomy(before))
        self._plate = Composing(self.page.figures, self.page.kinds, (PLATE, LARGEST), self.page.clear)
        self._low = self._plate.low(before, LARGEST)
        self._full = min(SPARSE, self._fullness(before))

    def holds(self, trial: Scales) -> bool:
        """Whether the sheets do, no worse filled; where a figure found no room, one larger still is not tried."""
        if any(all(trial[kind] <= other[kind] for kind in other) for other in self._never):
            return False
        if not any(all(one.needed(trial) <= self.sheets for one in some) for some in self.pages):
            self._never.append(trial)
            return False
        if self._low and self._plate.low(trial, LARGEST) < self._low - 0.02:
            return False
        return self.page.roomy(trial) >= self._roomy and self._fullness(trial) >= self._full

    def hole(self, scales: Scales) -> float:
        """The largest hole on any sheet, if it is one that is seen."""
        planned = (found for some in self.pages if (found := some[0].planned(scales)) is not None)
        return max(SMALL_HOLE, min((max(hole(*page) for page in found) for found in planned), default=1.0))

    def _fullness(self, scales: Scales) -> float:
        return max(some[0].fullness(scales) for some in self.pages)


def _better(page: Composing, scales: Scales, kinds: set[Place], now: float) -> Iterator[tuple[float, Scales]]:
    """Scales that are no worse but for holes, and how bad they are, the best first."""
    ordered = sorted(kinds, key=by_place)
    steps = [[*_trials(page, kind, scales[kind], len(ordered))] for kind in ordered]
    ways = (trial for trial in product(*steps) if _grows(trial, [some[0] for some in steps]))
    made = [(bad, trial) for trial in ways if (bad := _bad(trial, page, scales)) < now]
    for bad, trial in sorted(made, key=itemgetter(0)):
        yield bad, scales | {one.kind: one.scale for one in trial}


def _grows(trial: Sequence[Trial], now: Sequence[Trial]) -> bool:
    """Whether the mechanism is larger; where there is none, or its scale is given, another figure; and none small for
    its sake, or beside it."""
    main = next((one.long for one in trial if one.kind is View.MECHANISM), 0.0)
    for new, old in zip(trial, now, strict=True):
        beside = new.kind in MOTION and not new.lone and main > UNLIKE * new.long
        if beside or new.long < min(SHRUNK * old.long, SEEN):
            return False
    grown = {new.kind: new.long / old.long for new, old in zip(trial, now, strict=True)}
    return grown.get(View.MECHANISM, max(grown.values())) > GROWS


def _trials(page: Composing, kind: Place, scale: float, count: int) -> Iterator[Trial]:
    """A kind as it is, then a few steps finer and coarser, no larger than a hand would draw it."""
    yield _trial(page, kind, scale)
    for way, many in ((finer, FINEST), (coarser, COARSEST[kind is View.MECHANISM])):
        at = scale
        for _ in range(many if count <= MANY else FEW):
            at = way(at)
            if way is coarser or page.size(kind, {kind: at}) <= MOST * usual(kind):
                yield _trial(page, kind, at)


def _trial(page: Composing, kind: Place, scale: float) -> Trial:
    """A kind at a scale, by the figure that looks largest."""
    mine = [one for one in page.figures if one.of == kind and any(one.size)]
    first = max(mine, key=_looks)
    times, lone = first.scale / scale, _is_lone(first)
    looks, long = _looks(first) * times, max(first.size) * times
    short = min((one.short * times for one in mine if one.short), default=inf)
    arm = min((one.arm * times for one in mine if one.arm), default=inf)
    if kind is View.MECHANISM:
        bad = _SMALL * _lacks(looks, WIDE) + _SHORT * (_lacks(short, CRANK) + _lacks(arm, ARM))
    else:
        bad = _LOW * _lacks(long, LONE if lone else LOW) + _SHORT * _lacks(short, READ)
    return Trial(kind, scale, long, looks, bad - (0.0 if lone else _LARGE * log(looks)), lone)


def _looks(one: Sketched) -> float:
    """How large a figure looks (mm): one that is slender looks smaller than it is long."""
    longer, lower = max(one.size), min(one.size)
    return sqrt(longer * min(longer, max(lower / SLENDER, THIN * longer)))


def _is_lone(one: Sketched) -> bool:
    """Whether it is a polygon of vectors that are one line, as long as its shortest."""
    return one.short >= 0.99 * abs(complex(*one.size))


def _lacks(size: float, enough: float) -> float:
    return log(enough / size) if size < enough else 0.0


def _bad(trial: Sequence[Trial], page: Composing, scales: Mapping[Place, float]) -> float:
    """The less, the better is read what is read: what is bad of each, and how much larger a polygon is than the
    mechanism."""
    main = next((one.looks for one in trial if one.kind is View.MECHANISM), 0.0)
    if not main and any(one.of is View.MECHANISM and any(one.size) for one in page.figures):
        main = _trial(page, View.MECHANISM, scales[View.MECHANISM]).looks
    others = (one.looks for one in trial if one.kind is not View.MECHANISM)
    over = sum(max(0.0, log(looks / main)) for looks in others) if main else 0.0
    return _OVER * over + sum(one.bad for one in trial)
