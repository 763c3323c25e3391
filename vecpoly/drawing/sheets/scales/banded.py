"""Scales with which sheets have room for the band of a legend over their title strip."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from ....board.construction import View
from ....board.paper.scales import Sketched
from ....board.place import Place
from ....foundation.slotted import replace
from ....foundation.stock import Paper
from ..space import LEGEND, rooms
from .composing import composed
from .composition import Composing, Scales
from .crowding import Crowded
from .easing import CLOSE, eased
from .exchanging import exchanged
from .refilling import refilled

COARSER, FILLED = 1.6, 0.8  # times: no figure is made smaller than this for the sake of a legend; of a sheet
SURE = 6.0  # mm of a sheet that stay free where figures grow once more: what is planned may turn out larger
LESS, MOST = (3.0, 2.0), 3.0  # mm that figures turn out narrower and lower than planned on the whole; times so at most
HALF = 0.5  # of that: they fit at least so
MANY = 3  # figures, of which that holds on the whole


def over_legend(figures: Sequence[Crowded], bare: Sequence[Sketched], given: Mapping[View, float], on: Paper) -> Scales:
    """The scales with which these figures fill their sheets; somewhat coarser ones where no band of white is left on
    them for a legend, and no further sheet is asked for.

    bare: the same figures without their details.
    """
    there = {one.of: one.scale for one in figures if one.of is not None} | dict(given)
    best = _chosen(figures, bare, given, there, on)
    if not best:
        return best
    kept, at = LEGEND + SURE, there | best
    least = min(_needed(_least(figures), at, on, 0.0), len(figures))
    if _needed(figures, at, on, kept) > least:
        return best  # which may do with fewer sheets
    slim = _slimmer(figures) if len(figures) >= MANY else figures
    ways = zip(_composings(slim, on, kept), _composings(_slimmer(figures, HALF), on), strict=True)
    found = refilled([*ways], there | best, set(best))
    return {kind: found[kind] for kind in best}


def weighed(
    figures: Sequence[Crowded], chosen: Mapping[Place, float], given: Mapping[View, float], on: Paper
) -> Scales:
    """These scales, or others for as many sheets at which what is read is clearly larger."""
    there = {one.of: one.scale for one in figures if one.of is not None} | dict(given) | dict(chosen)
    kinds = {one.of for one in figures if one.of is not None and max(one.size) > 0 and one.of not in given}
    slim = _slimmer(figures) if len(figures) >= MANY else figures
    sheets = _needed(_least(figures), there, on, 0.0)
    kept = LEGEND if _needed(slim, there, on, LEGEND) == sheets else 0.0
    plans = (_composings(figures, on), _composings(slim, on, kept), _composings(_least(figures), on))
    found = exchanged([*zip(*plans, strict=True)], there, kinds) if kinds else there
    return {kind: found[kind] for kind in chosen if kind in found}


def _chosen(
    figures: Sequence[Crowded], bare: Sequence[Sketched], given: Mapping[View, float], there: Scales, on: Paper
) -> Scales:
    """Those that fill the whole sheets, or others with room for a legend."""
    best, less = (eased(figures, composed(bare, given, on, kept), given, on, kept) for kept in (0.0, LEGEND))
    if best == less or not best:
        return best
    sheets = _needed(figures, there | best, on, 0.0)
    if _needed(figures, there | best, on, LEGEND) == sheets:
        return best
    small = any(less[kind] > COARSER * best[kind] for kind in best)
    if small or _needed(figures, there | less, on, LEGEND) > sheets:
        return best
    full, fuller = (_fullness(figures, there | scales, on) for scales in (less, best))
    return less if full >= min(FILLED, fuller) else best


def _composings(figures: Sequence[Crowded], on: Paper, kept: float = 0.0) -> Iterator[Composing]:
    """The figures with their details on sheets that lie either way, so much of each (mm) kept free."""
    kinds = {one.of for one in figures if one.of is not None}
    yield from (Composing(figures, kinds, page, CLOSE) for page in rooms(on, kept))


def _slimmer(figures: Sequence[Crowded], times: float = 1.0) -> list[Crowded]:
    """The figures as large as they turn out on the whole."""
    less = ([max(0.0, side - times * by) for side, by in zip(one.around, LESS, strict=True)] for one in figures)
    return [replace(one, around=(wide, high)) for one, (wide, high) in zip(figures, less, strict=True)]


def _least(figures: Sequence[Crowded]) -> list[Crowded]:
    """The figures as small as they may turn out, without their details, which are left out where they need a sheet."""
    return [replace(one, most=0) for one in _slimmer(figures, MOST)]


def _needed(figures: Sequence[Crowded], scales: Scales, on: Paper, kept: float) -> int:
    """How many sheets hold them at these scales."""
    return min(one.needed(scales) for one in _composings(figures, on, kept))


def _fullness(figures: Sequence[Crowded], scales: Scales, on: Paper) -> float:
    """What they take of the emptiest of their sheets."""
    return max(one.fullness(scales) for one in _composings(figures, on))
