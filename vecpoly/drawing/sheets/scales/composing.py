"""The scales of all figures of a problem chosen together: as few sheets as hold them at a size that can be read, then
as large as these sheets allow.

What is known is a sketch: the size of the bare lines at some scale, what lettering and title will take round them,
and which kind's scale a figure follows. From the least size that can be read every kind grows by one round scale at a
time, the one that is farthest from the size that a hand would draw it in first, as long as no further sheet is asked
for.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ....board.construction import View
from ....board.paper.scales import Sketched
from ....board.place import Place
from ....foundation.slotted import replace
from ....foundation.stock import ANY_A4, Paper
from ..pages import BANDS, FULLER
from ..space import HIGHEST, LARGEST, PLATE, SPARSE, rooms
from .balancing import balanced
from .composition import CRAMPED, LOST, OWN, Composing, Scales, least_scales
from .growing import grown

ENOUGH = 0.62  # of the usual size: no figure need be smaller for a plate
NARROWER = 1.4  # times: no figure is made smaller than this for the sake of a plate as wide as the text
WORTH = 0.63  # planned share of a page that figures of one scale take, below which they stand on a plate
LARGER = 1.3  # times as large a mechanism is drawn on one sheet more, at least: 1.5 for 2, 3 for 4
TAKEN = 0.45  # planned share of all sheets that figures take where one more is drawn about a short crank
FULL = 0.53  # planned share of the emptiest of these sheets, or of the plate that it becomes
WELL, LETTERS = 0.58, 0.5  # the same of a mechanism that is small altogether; of one that is small for its letters


def composed(figures: Sequence[Sketched], given: Mapping[View, float], on: Paper = ANY_A4, kept: float = 0.0) -> Scales:
    """A round scale for each kind of figure that has none given.

    given: scales that stay. on: the paper, which lies as is wished, or as it holds more. kept: so much (mm) of a sheet
    stays free. Where one sheet holds the figures and there is one scale to choose, they grow into the white beside
    their titles.
    """
    kinds = {one.of for one in figures if one.of is not None and max(one.size) > 0} - set(given)
    there = {one.of: one.scale for one in figures if one.of is not None}
    known = dict(given)
    start = there | known
    if len(kinds) == 1:
        grown = _composed(figures, kinds, start, on, kept)
        if any(Composing(figures, kinds, page).needed(start | grown) == 1 for page in rooms(on, kept)):
            return grown
    return _composed([replace(one, spare=0.0) for one in figures], kinds, start, on, kept)


def _composed(figures: Sequence[Sketched], kinds: set[Place], there: Scales, on: Paper, kept: float) -> Scales:
    """The scales with which the figures fill as few sheets as will do, or a plate."""
    start = there | least_scales(kinds, figures)
    trials = [Composing(figures, kinds, page) for page in rooms(on, kept)]
    made = [(trial, found) for trial in trials if (found := grown(trial, start)) is not None]
    if not made:
        return {kind: start[kind] for kind in kinds}
    trial, best = max(made, key=lambda one: one[0].worth(one[1])) if len(made) > 1 else made[0]
    if trial.roomy(best) < 1.0:
        best = _roomier(trials, trial, best, start)
    best = balanced(trials, best)
    if on.way is None and trial.share(best) < LOST:
        best = _lower(trial, best, start)
    if on.way is None and trial.leaves_bands(best):
        best = _narrower(trial, best, start)
    return {kind: best[kind] for kind in kinds}


def _roomier(trials: Sequence[Composing], page: Composing, best: Scales, start: Scales) -> Scales:
    """The scales with one sheet more, where the mechanism is drawn larger on it and the sheets are not left white; else
    as they are: in a small mechanism, and about a short crank, lines and letters find no room."""
    sheets, share = page.needed(best) + 1, TAKEN if page.crank(best) < CRAMPED else LETTERS if page.moving else WELL
    made = [(one, found) for one in trials if (found := grown(one, start, sheets)) is not None]
    made = [pair for pair in made if pair[0].taken(pair[1], sheets) >= share]
    if page.moving:
        made = [pair for pair in made if pair[0].fullness(pair[1]) >= FULL]
    one, found = max(
        made, key=lambda pair: (min(1.0, pair[0].roomy(pair[1])), pair[0].filled(pair[1])), default=(page, best)
    )
    return found if one.roomy(found) >= LARGER * page.roomy(best) else best


def _lower(page: Composing, best: Scales, start: Scales) -> Scales:
    """The scales for a plate, where figures that would be lost on a page fill it better; else as they are."""
    plate = Composing(page.figures, page.kinds, (PLATE, HIGHEST))
    low = grown(plate, start)
    if low is None or plate.needed(low) > 1 or plate.least(low) < ENOUGH:
        return best
    if plate.alone(low) < OWN and page.alone(best) >= LARGER * plate.alone(low):
        return best
    share, own = page.share(best), plate.low(low)
    if share >= SPARSE and plate.cramped(low, best):
        return best
    if share < WORTH and own < BANDS and len(page.kinds) == 1:
        return _on_large_plate(page, best, start) or low
    return best if own <= share else low


def _narrower(page: Composing, best: Scales, start: Scales) -> Scales:
    """Somewhat coarser scales, where figures that leave bands of their page white find room on a plate so, which is no
    wider than the text; else as they are."""
    low = _on_large_plate(page, best, start)
    if low is None:
        return best
    plate = Composing(page.figures, page.kinds, (PLATE, LARGEST))
    return best if plate.low(low, LARGEST) < page.share(best) + FULLER or plate.roomy(low) < 1.0 else low


def _on_large_plate(page: Composing, best: Scales, start: Scales) -> Scales | None:
    """Scales that are the same or somewhat coarser, with which the figures find room on a plate that is nearly as high
    as a page; None where none nearly as large does."""
    plate = Composing(page.figures, page.kinds, (PLATE, LARGEST))
    if plate.low(best, LARGEST) > 0:
        return best
    if (low := grown(plate, start)) is None or not plate.low(low, LARGEST):
        return None
    return None if any(low[kind] > NARROWER * best[kind] for kind in page.kinds) else low
