"""The scales of all figures of a problem chosen together: as few sheets as hold them at a size that can be read, then
as large as these sheets allow.

What is known is a sketch: the size of the bare lines at some scale, what lettering and title will take round them,
and which kind's scale a figure follows. From the least size that can be read every kind grows by one round scale at a
time, the one that is farthest from the size that a hand would draw it in first, as long as no further sheet is asked
for.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from math import log, sqrt

from ...board.construction import View
from ...board.paper.scales import Sketched, finer, round_up
from ...board.place import Pane, Place, view_of
from ...foundation.stock import ANY_A4, Paper
from .packing import flat, inner, pack, padded
from .slicing import Pair, Size, Slicing
from .space import CLEAR, HIGHEST, PLATE, SPARSE, rooms

LEAST, MOST = 0.55, 1.5  # of the usual size: smaller no figure is drawn to save a sheet, larger none to fill one
USUAL_WIDE, USUAL = 150.0, 100.0  # mm: of a figure that has the width of a page, of another
USUAL_OWN = 180.0  # mm: of one with a scale of its own, on which the most is drawn
PER_LETTER, PLAIN = 8.0, 100.0  # mm: a diagram beside polygons is as large as its letters ask, but no smaller than this
READ = 10.0  # mm: a vector as long is read to 1 %; a figure with a shorter one counts as smaller than it is
ENOUGH = 0.62  # of the usual size: no figure need be smaller for a plate
ROOM, CROWDED = 5.0, 0.85  # mm that a letter asks for; but of the usual size at most
CRAMPED = 12.0  # mm between the nearest two pins of a mechanism: about a shorter crank its forces find no room
LARGER = 1.3  # times as large it is then, at least: 1.5 for 2, 3 for 4; a sheet more for less is not worth its while
TAKEN = 0.45  # planned share of all sheets that figures take where one more is drawn for that
LOST = SPARSE + 0.08  # planned share of a page that may turn out too small

Scales = dict[Place, float]


def composed(figures: Sequence[Sketched], given: Mapping[View, float], on: Paper = ANY_A4) -> Scales:
    """A round scale for each kind of figure that has none given.

    given: scales that stay. on: the paper, which lies as is wished, or as it holds more. Where one sheet holds the
    figures and there is one scale to choose, they grow into the white beside their titles.
    """
    kinds = {one.of for one in figures if one.of is not None and max(one.size) > 0} - set(given)
    there = {one.of: one.scale for one in figures if one.of is not None}
    known = dict(given)
    start = there | known
    if len(kinds) == 1:
        grown = _composed(figures, kinds, start, on)
        if any(Composing(figures, kinds, page).needed(start | grown) == 1 for page in rooms(on)):
            return grown
    return _composed([replace(one, spare=0.0) for one in figures], kinds, start, on)


def _composed(figures: Sequence[Sketched], kinds: set[Place], there: Scales, on: Paper) -> Scales:
    """The scales with which the figures fill as few sheets as will do, or a plate."""
    start = there | least_scales(kinds, figures)
    trials = [Composing(figures, kinds, page) for page in rooms(on)]
    made = [(trial, found) for trial in trials if (found := trial.grown(start)) is not None]
    if not made:
        return {kind: start[kind] for kind in kinds}
    trial, best = max(made, key=lambda one: one[0].worth(one[1])) if len(made) > 1 else made[0]
    if View.FORCE in kinds and trial.crank(best) < CRAMPED:
        best = _roomier(trials, trial, best, start)
    if on.way is None and trial.share(best) < LOST:
        best = _lower(trial, best, start)
    return {kind: best[kind] for kind in kinds}


def _roomier(trials: Sequence[Composing], page: Composing, best: Scales, start: Scales) -> Scales:
    """The scales with one sheet more, where the mechanism is drawn larger on it and the sheets are not left white; else
    as they are: about a short crank the lines and letters of its forces find no room."""
    sheets = page.needed(best) + 1
    made = [(one, found) for one in trials if (found := one.grown(start, sheets)) is not None]
    made = [(one, found) for one, found in made if one.taken(found, sheets) >= TAKEN]
    one, found = max(
        made, key=lambda pair: (min(CRAMPED, pair[0].crank(pair[1])), pair[0].filled(pair[1])), default=(page, best)
    )
    return found if one.crank(found) >= LARGER * page.crank(best) else best


def _lower(page: Composing, best: Scales, start: Scales) -> Scales:
    """The scales for a plate, where figures that would be lost on a page fill it better; else as they are."""
    plate = Composing(page.figures, page.kinds, (PLATE, HIGHEST))
    low = plate.grown(start)
    if low is None or plate.needed(low) > 1 or plate.least(low) < ENOUGH:
        return best
    share = page.share(best)
    return best if plate.low(low) <= share or (share >= SPARSE and plate.cramped(low, best)) else low


def least_scales(kinds: set[Place], figures: Sequence[Sketched]) -> Scales:
    """Of each kind the scale at which it can just be read."""
    return {kind: _least(kind, figures) for kind in sorted(kinds, key=_by_place)}


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


def _by_place(kind: Place) -> tuple[View, str]:
    return view_of(kind), kind.name if isinstance(kind, Pane) else ""


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
        """How many sheets hold the figures; more than there are figures where one fits none."""
        sizes = self.sizes(scales)
        cut = Slicing(padded(sizes, self.clear), inner(self.page, self.clear), self.pairs)
        area = [(w + self.clear) * (h + self.clear) for w, h in sizes]
        wide, high = inner(self.page, self.clear)
        count = [0]
        for end in range(1, len(sizes) + 1):
            starts = (s for s in range(end) if sum(area[s:end]) <= wide * high and cut.shapes(s, end))
            count.append(1 + min((count[start] for start in starts), default=len(sizes)))
        return count[-1]

    def share(self, scales: Mapping[Place, float]) -> float:
        """What the figures take of one page; 1 where they need more than one."""
        sizes = self.sizes(scales)
        layout = pack(sizes, self.page, tuple(self.pairs))
        return 1.0 if layout is None else layout.share(sizes)

    def worth(self, scales: Mapping[Place, float]) -> tuple[int, bool, float]:
        """The more, the better: few sheets, on which figures are not lost, and large figures."""
        return -self.needed(scales), self.share(scales) >= LOST, self.filled(scales)

    def low(self, scales: Mapping[Place, float]) -> float:
        """What they take of a plate as low as its width allows; 0 where it would be as high as a page."""
        sizes = self.sizes(scales)
        layout = flat(sizes, self.pairs)
        return 0.0 if layout is None else layout.share(sizes)

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
        return sum(log(self.legible(kind, scales)) for kind in self.kinds)

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

    def grown(self, start: Scales, most: int = 0) -> Scales | None:
        """Finer scales, as far as they ask for no further sheet, or for no more than so many; None where a figure fits
        none."""
        scales, sheets = dict(start), max(most, self.needed(start))
        if sheets > max(most, len(self.figures)):
            return None
        growing, waiting = set(self.kinds), set[Place]()
        while growing:
            kind = min(sorted(growing, key=_by_place), key=lambda one: self.legible(one, scales))
            trial = scales | {kind: finer(scales[kind])}
            if self.size(kind, trial) <= MOST * self.wanted(kind) and self.needed(trial) <= sheets:
                scales, growing, waiting = trial, growing | waiting, set()
            else:
                growing.remove(kind)
                waiting.add(kind)  # it may find room once another has grown and stands elsewhere
        return scales
