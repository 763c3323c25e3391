"""Dimension lines on sheets of slider-cranks: the stroke H under the guide, the offset e beside the crank's pivot."""

from __future__ import annotations

from ...board.construction import Place
from ...board.paper.marks import Role
from ...designs.quantities import OFFSET, STROKE
from ...plane import Points, nominal
from ..devices.sketches.dimensions import dimension
from .draft import SHEET, Draft

UNDER, CLEAR, OVER = 15.0, 3.5, 2.0  # mm: below the guide; of thin lines there, and past a dimension
ASIDE, SHORT = 14.0, 3.0  # mm: from the pivot; an offset of less has no room for arrowheads


def stroke(draft: Draft, ends: tuple[Points, Points], below: float = UNDER) -> None:
    """H between C₁ and C₂, so far below them."""
    feet = [complex(nominal(end)) for end in ends]
    levels = [end - 1j * below for end in feet]
    for end, level in zip(feet, levels, strict=True):
        draft.board.join(SHEET, end - 1j * CLEAR, level - 1j * OVER, Role.CONSTRUCTION)
    dimension(draft, SHEET, levels[0], levels[1], STROKE.symbol)


def offset(draft: Draft, place: Place, pivot: Points, foot: Points) -> None:
    """e from the pivot to its foot on the guide."""
    ends = [complex(nominal(at)) for at in (pivot, foot)]
    if abs(ends[1] - ends[0]) < SHORT:
        return
    for end in ends:
        draft.board.join(place, end, end - (ASIDE + OVER), Role.CONSTRUCTION)
    dimension(draft, place, ends[0] - ASIDE, ends[1] - ASIDE, OFFSET.symbol)
