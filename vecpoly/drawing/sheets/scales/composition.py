"""Figures at some scales on sheets of one size: how many sheets they need, how large they are against what a hand
would draw, and what they take of the paper."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import starmap
from math import inf, log, sqrt

from ....board.construction import View
from ....board.paper.scales import Sketched, round_up
from ....board.place import Pane, Place, view_of
from ....foundation.slotted import dataclass
from ..packing import Layout, flat, inner, pack, padded
from ..pages import BANDS, INKED, Page, Paging, covered, trimmed
from ..slicing import Pair, Size, Slicing
from ..space import CLEAR, HIGHEST, PLATE, SPARSE

NEVER = 10**6  # sheets: of figures of which one fits none
LEAST = 0.55  # of the usual size: smaller no figure is drawn to save a sheet
USUAL_WIDE, USUAL = 150.0, 100.0  # mm: of a figure that has the width of a page, of another
USUAL_OWN = 180.0  # mm: of one with a scale of its own, on which the most is drawn
PER_LETTER, PLAIN = 8.0, 100.0  # mm: a diagram beside polygons is as large as its letters ask, but no smaller than this
READ = 10.0  # mm: a vector as long is read to 1 %; a figure with a shorter one counts as smaller than it is
ROOM, CROWDED = 5.0, 0.85  # mm that a letter asks for; but of the usual size at most
CRAMPED = 12.0  # mm between the nearest two pins of a mechanism: about a shorter crank letters find no room
OWN = 60.0  # mm that a mechanism itself measures, without what is constructed about it, wherever its sheet has room
STANDS = 6.0  # mm of the mechanism itself for every letter on it, beside polygons that take room from it
KNOT = 5.0  # mm of a construction for every letter on it, in which a linkage that is sought is found
SMALL = 0.66  # of the size that is wanted of a mechanism: a smaller one has too little room on its sheet
LOST = SPARSE + 0.08  # planned share of a page that may turn out too small
BEYOND = 0.25  # what a figure counts for that is larger than a hand would draw it

Scales = dict[Place, float]


def least_scales(kinds: set[Place], figures: Sequence[Sketched]) -> Scales:
    """Of each kind the scale at which it can just be read."""
    return {kind: _least(kind, figures) for kind in sorted(kinds, key=by_place)}


def _least(kind: Place, figures: Sequence[Sketched]) -> float:
    """The scale at which the largest figure of a kind can still be read."""
    found = [one for one in figures if one.of == kind and max(one.size) > 0]
    return max(round_up(one.scale * max(one.size) / _readable(kind, one.letters)) for one in found)


def _readable(kind: Place, letters: int) -> float:
    """The least size (mm) of a figure with so many letters."""
    whole = min(usual(kind), USUAL_WIDE)
    return max(LEAST * whole, min(ROOM * letters, CROWDED * whole))


def usual(kind: Place) -> float:
    """How large such a figure is drawn by hand (mm)."""
    if isinstance(kind, Pane):
        return USUAL_OWN
    return USUAL_WIDE if kind.wide else USUAL


def by_place(kind: Place) -> tuple[View, str]:
    return view_of(kind), kind.name if isinstance(kind, Pane) else ""


@lru_cache(maxsize=4096)
def _needed(sizes: tuple[Size, ...], page: Size, clear: float, pairs: frozenset[Pair]) -> int:
    """How many sheets hold figures of these sizes: asked again of the same ones while scales grow by turns."""
    cut = Slicing(padded(sizes, clear), inner(page, clear), pairs)
    area = [(w + clear) * (h + clear) for w, h in sizes]
    wide, high = inner(page, clear)
    count = [0]
    for end in range(1, len(sizes) + 1):
        starts = (s for s in range(end) if sum(area[s:end]) <= wide * high and cut.shapes(s, end))
        count.append(1 + min((count[start] for start in starts), default=NEVER))
    return count[-1]


@dataclass(frozen=True, slots=True)
class _Planned:
    """A figure as far as its place on a page goes."""

    view: View
    name: str
    size: Size


def _covered(figures: Sequence[_Planned], layout: Layout) -> float:
    lone = len(figures) == 1 and figures[0].view is View.MECHANISM  # polygons have details, and hardly become plates
    return covered(figures, trimmed(figures, layout) if lone else layout)


class Composing:
    """Figures on sheets of one size, with so much white between them (mm)."""

    def __init__(self, figures: Sequence[Sketched], kinds: set[Place], page: Size, clear: float = CLEAR) -> None:
        self.figures, self.kinds, self.page, self.clear = tuple(figures), kinds, page, clear
        self.pairs = frozenset(self._pairs())

    def _pairs(self) -> Iterator[Pair]:
        for i, (a, b) in enumerate(zip(self.figures, self.figures[1:], strict=False)):
            if b.view.beside is a.view and a.name == b.name:
                yield i, i + 1

    def sizes(self, scales: Mapping[Place, float]) -> list[Size]:
        """Each figure at these scales, with all that stands round it."""
        return [one.at(one.scale if one.of is None else scales[one.of]) for one in self.figures]

    def needed(self, scales: Mapping[Place, float]) -> int:
        """How many sheets hold the figures; more than there can be where one fits none."""
        return _needed(tuple(self.sizes(scales)), self.page, self.clear, self.pairs)

    def share(self, scales: Mapping[Place, float]) -> float:
        """What the figures take of one page; 1 where they need more than one."""
        sizes = self.sizes(scales)
        layout = pack(sizes, self.page, tuple(self.pairs))
        return 1.0 if layout is None else layout.share(sizes)

    def fullness(self, scales: Mapping[Place, float]) -> float:
        """What they take of the emptiest of their sheets; a mechanism alone of the plate that its sheet may become."""
        found = self.planned(scales)
        return 0.0 if found is None else min(starmap(_covered, found))

    def planned(self, scales: Mapping[Place, float]) -> list[Page[_Planned]] | None:
        """Their pages; None where one fits none."""
        sizes = zip(self.figures, self.sizes(scales), strict=True)
        found = Paging([_Planned(one.view, one.name, size) for one, size in sizes], self.page).best()
        return None if found is None else found[1]

    def worth(self, scales: Mapping[Place, float]) -> tuple[int, bool, float]:
        """The more, the better: few sheets, on which figures are not lost, and large figures."""
        return -self.needed(scales), self.share(scales) >= LOST, self.filled(scales)

    def low(self, scales: Mapping[Place, float], most: float = HIGHEST) -> float:
        """What they take of a plate as low as its width allows; 0 where it would be higher than this (mm)."""
        sizes = self.sizes(scales)
        layout = flat(sizes, self.pairs, (PLATE, most))
        return 0.0 if layout is None else layout.share(sizes)

    def leaves_bands(self, scales: Mapping[Place, float]) -> bool:
        """Whether the figures leave bands of their one page white, about them or between them."""
        sizes = self.sizes(scales)
        layout = pack(sizes, self.page, tuple(self.pairs))
        own = sum(wide * high for wide, high in sizes) / (self.page[0] * self.page[1])
        return layout is not None and (layout.share(sizes) < BANDS or own < INKED)

    def least(self, scales: Mapping[Place, float]) -> float:
        """How large the smallest kind is against what is usual."""
        return min((self.size(kind, scales) / self.wanted(kind) for kind in self.kinds), default=1.0)

    def cramped(self, scales: Mapping[Place, float], others: Mapping[Place, float]) -> bool:
        """Whether a figure with more letters than it has room for is smaller than at the other scales."""
        return any(
            scales[one.of] > others[one.of] and one.scale / scales[one.of] * max(one.size) < PER_LETTER * one.letters
            for one in self.figures
            if one.of in self.kinds and one.of is not None
        )

    def filled(self, scales: Mapping[Place, float]) -> float:
        """How large all kinds are against what is usual, the small ones counting most: a sum of logarithms."""
        sizes = [log(self.legible(kind, scales)) for kind in sorted(self.kinds, key=by_place)]
        return sum(size if size < 0 else BEYOND * size for size in sizes)

    def legibles(self, scales: Mapping[Place, float]) -> tuple[float, ...]:
        """The same of each, the smallest first; no figure need be larger than is wanted."""
        return tuple(sorted(min(1.0, self.legible(kind, scales)) for kind in self.kinds))

    def roomy(self, scales: Mapping[Place, float]) -> float:
        """How much room a mechanism has, itself, beside polygons for its letters, and where forces act or centres are
        found on it for those and about its shortest link; enough from 1 on."""
        kinds = [kind for kind in self.kinds if view_of(kind) is View.MECHANISM]
        room = min(self.alone(scales) / OWN, self.lettered(scales) / STANDS, self.knotted(scales) / KNOT)
        if View.FORCE in self.kinds or any(isinstance(kind, Pane) for kind in kinds):
            room = min(room, self.crank(scales) / CRAMPED, *(self.legible(kind, scales) / SMALL for kind in kinds))
        return room

    def alone(self, scales: Mapping[Place, float]) -> float:
        """How large the mechanism itself is where it is drawn smallest, without what is constructed about it (mm)."""
        sizes = (one.scale / scales[one.of] * one.linked for one in self.figures if one.of in self.kinds and one.of)
        return min((size for size in sizes if size), default=inf)

    @property
    def moving(self) -> bool:
        """Whether polygons of motion alone are beside it: lines of forces reach the farther the larger it is."""
        beside = {view_of(one.of) for one in self.figures if one.of is not None and any(one.size)}
        return View.VELOCITY in beside and View.FORCE not in beside

    def lettered(self, scales: Mapping[Place, float]) -> float:
        """How much of the mechanism there is for every letter on it (mm), where polygons of motion are drawn beside
        it."""
        if not self.moving:
            return inf
        drawn = (one for one in self.figures if one.linked and one.letters and one.of in self.kinds)
        return min((one.scale / scales[one.of] * one.linked / one.letters for one in drawn if one.of), default=inf)

    def knotted(self, scales: Mapping[Place, float]) -> float:
        """How much of a construction on which a linkage is found there is for every letter on it (mm)."""
        first = next((one for one in self.figures if one.of is View.MECHANISM), None)
        if first is None or first.linked or not (first.letters and first.scaled) or self.kinds != {View.MECHANISM}:
            return inf
        return first.scale / scales[View.MECHANISM] * max(first.size) / first.letters

    def legible(self, kind: Place, scales: Mapping[Place, float]) -> float:
        """How large a kind is against what is wanted, less the shorter the shortest vector is that is read in it."""
        at = scales[kind]
        shortest = min(
            (one.scale / at * one.short for one in self.figures if one.of == kind and one.short), default=READ
        )
        return self.size(kind, scales) / self.wanted(kind) * sqrt(min(1.0, shortest / READ))

    def wanted(self, kind: Place) -> float:
        """How large such a figure is drawn by hand: a diagram beside polygons as large as what stands in it asks."""
        if kind is not View.MECHANISM or not any(isinstance(one, Pane) or one.images for one in self.kinds):
            return usual(kind)
        letters = max((one.letters for one in self.figures if one.of is kind), default=0)
        return min(max(PLAIN, PER_LETTER * letters), usual(kind))

    def size(self, kind: Place, scales: Mapping[Place, float]) -> float:
        """How large a kind is drawn: the longer side of its largest figure (mm)."""
        at = scales[kind]
        return max(one.scale / at * max(one.size) for one in self.figures if one.of == kind)

    def crank(self, scales: Mapping[Place, float]) -> float:
        """How far the nearest two pins of the mechanism are drawn apart (mm)."""
        diagrams = (one for one in self.figures if one.of is View.MECHANISM and one.short)
        return min((one.scale / scales[View.MECHANISM] * one.short for one in diagrams), default=CRAMPED)

    def taken(self, scales: Mapping[Place, float], sheets: int) -> float:
        """What the figures take of so many sheets."""
        area = sum((wide + self.clear) * (high + self.clear) for wide, high in self.sizes(scales))
        return area / (sheets * self.page[0] * self.page[1])
