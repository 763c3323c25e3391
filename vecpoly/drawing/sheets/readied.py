"""The figures of a construction as they are drawn on sheets: in the order of reading, two solutions that crowd each
other apart, and no part of a sketched mechanism too small to be seen."""

from __future__ import annotations

from collections.abc import Sequence

from ...board.construction import Figure
from ...board.paper.extent import extent, figured
from ..details.larger import larger, may_be_larger
from ..parted import parted
from .paging import reading_order

SEEN = 16.0  # mm: the longer side of a part that is drawn apart without a scale, at least
LEAST = 0.5  # mm: what is no longer is a point


def readied(figures: Sequence[Figure]) -> tuple[Figure, ...]:
    """These figures, for their sheets."""
    return tuple(map(_seen, parted(reading_order(figures))))


def _seen(figure: Figure) -> Figure:
    """A sketched part, as the crank on its frame, as large as is seen; any other figure as it is."""
    if figure.scale.symbol or not may_be_larger(figure):
        return figure
    across = max(extent(figured(figure.marks)))
    return larger(figure, SEEN / across) if LEAST < across < SEEN else figure
