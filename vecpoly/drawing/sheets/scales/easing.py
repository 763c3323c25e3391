"""Scales a little coarser where the details of a figure would find no room else."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from ....board.construction import View
from ....board.paper.scales import coarser
from ....board.place import Place
from ....foundation.stock import Paper
from ...details.knots import MOST
from ...details.room import Grow
from ..space import rooms
from .composition import Composing, Scales, least_scales
from .crowding import Crowded

CLOSE = 3.0  # mm of white, as planned: a little more than is left at least, for letters that stand out farther
MOST_COARSER = 2.0  # times: a figure that is read is not made smaller for the sake of details


def eased(figures: Sequence[Crowded], best: Scales, given: Mapping[View, float], on: Paper) -> Scales:
    """These scales, or coarser ones at which figures that have one sheet have it with their details, too: with all of
    them, or with the worst of each figure; as they are where these would be too small."""
    there = {one.of: one.scale for one in figures if one.of is not None} | dict(given) | best
    if not any(one.knots(there[one.of]) for one in figures if one.of is not None):
        return best
    pages = rooms(on)
    alone = [replace(one, most=0) for one in figures]
    if all(Composing(alone, set(best), page, CLOSE).needed(there) > 1 for page in pages):
        return best
    least = {kind: min(scale, MOST_COARSER * best[kind]) for kind, scale in _least(set(best), alone).items()}
    for most in range(MOST, 0, -1):
        trials = [Composing(some, set(best), page, CLOSE) for some in _arranged(figures, most) for page in pages]
        if any(trial.needed(there) == 1 for trial in trials):
            return best
        made = [(trial, found) for trial in trials if (found := _shrunk(trial, there, least)) is not None]
        if made:
            found = max(made, key=lambda one: one[0].filled(one[1]))[1]
            return {kind: found[kind] for kind in best}
    return best


def _least(kinds: set[Place], figures: Sequence[Crowded]) -> Scales:
    """Of each kind the scale at which it can just be read; letters need less room with details."""
    return least_scales(kinds, [replace(one, letters=0) for one in figures])


def _arranged(figures: Sequence[Crowded], most: int) -> Iterator[list[Crowded]]:
    """The details of all beside them, or below."""
    for grow in Grow:
        yield [replace(one, grow=grow, most=most) for one in figures]


def _shrunk(trial: Composing, scales: Scales, least: Scales) -> Scales | None:
    """Coarser scales, of the largest kind first, until one sheet will do."""
    while trial.needed(scales) > 1:
        free = [kind for kind in least if coarser(scales[kind]) <= least[kind] * (1 + 1e-9)]
        if not free:
            return None
        kind = max(free, key=lambda one: trial.legible(one, scales))
        scales = scales | {kind: coarser(scales[kind])}
    return scales
