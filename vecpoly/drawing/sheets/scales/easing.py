"""Scales a little coarser where the details of a figure would find no room else."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ....board.construction import View
from ....board.paper.scales import coarser
from ....board.place import Place
from ....foundation.slotted import replace
from ....foundation.stock import Paper
from ...details.knots import MOST
from ...details.room import Grow
from ..slicing import Size
from ..space import SPARSE, rooms
from .composition import Composing, Scales, least_scales
from .crowding import Crowded
from .growing import grown

CLOSE = 3.0  # mm of white, as planned: a little more than is left at least, for letters that stand out farther
MOST_COARSER = 1.3  # times: a figure that is read is not made smaller for the sake of details
MANY = 4  # details of a construction that are worth a sheet


def eased(
    figures: Sequence[Crowded], best: Scales, given: Mapping[View, float], on: Paper, kept: float = 0.0
) -> Scales:
    """These scales, or coarser ones at which figures that have one sheet have it with their details, too: with all of
    them, or with the worst of each figure; as they are where these would be too small. Many details have two sheets
    rather than few of them one, where the figures fill both well."""
    there = {one.of: one.scale for one in figures if one.of is not None} | dict(given) | best
    count = sum(len(one.knots(there[one.of])) for one in figures if one.of is not None)
    if not count:
        return best
    pages = rooms(on, kept)
    alone = [replace(one, most=0) for one in figures]
    if all(Composing(alone, set(best), page, CLOSE).needed(there) > 1 for page in pages):
        return best
    least = {kind: min(scale, MOST_COARSER * best[kind]) for kind, scale in _least(set(best), alone).items()}
    planned = (_on_one(_trials(figures, set(best), pages, most), there, least) for most in range(MOST, 0, -1))
    all_shown = next(planned)
    if all_shown is None and count >= MANY:
        all_shown = _on_two(_trials(figures, set(best), pages, MOST), there)
    found = all_shown or next((one for one in planned if one is not None), there)
    return {kind: found[kind] for kind in best}


def _on_one(trials: Sequence[Composing], there: Scales, least: Scales) -> Scales | None:
    """These scales if one sheet holds the figures at them, else the largest coarser ones at which it does."""
    if any(trial.needed(there) == 1 for trial in trials):
        return there
    made = [(trial, found) for trial in trials if (found := _shrunk(trial, there, least)) is not None]
    return max(made, key=lambda one: one[0].filled(one[1]))[1] if made else None


def _on_two(trials: Sequence[Composing], there: Scales) -> Scales | None:
    """The scales with which the figures fill two sheets well."""
    made = [(trial, found) for trial in trials if (found := grown(trial, there, 2)) is not None]
    made = [(trial, found) for trial, found in made if trial.fullness(found) >= SPARSE]
    return max(made, key=lambda one: one[0].filled(one[1]))[1] if made else None


def _trials(figures: Sequence[Crowded], kinds: set[Place], pages: Sequence[Size], most: int) -> tuple[Composing, ...]:
    """So many details of each figure beside it, or below, on sheets that lie either way."""
    arranged = ([replace(one, grow=grow, most=most) for one in figures] for grow in Grow)
    return tuple(Composing(some, kinds, page, CLOSE) for some in arranged for page in pages)


def _least(kinds: set[Place], figures: Sequence[Crowded]) -> Scales:
    """Of each kind the scale at which it can just be read; letters need less room with details."""
    return least_scales(kinds, [replace(one, letters=0) for one in figures])


def _shrunk(trial: Composing, scales: Scales, least: Scales) -> Scales | None:
    """Coarser scales, of the largest kind first, until one sheet will do."""
    while trial.needed(scales) > 1:
        free = [kind for kind in least if coarser(scales[kind]) <= least[kind] * (1 + 1e-9)]
        if not free:
            return None
        kind = max(free, key=lambda one: trial.legible(one, scales))
        scales = scales | {kind: coarser(scales[kind])}
    return scales
