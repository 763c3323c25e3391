"""Edges of frames that nearly lie on one line: they are moved on to it, where their figures leave them free."""

from __future__ import annotations

from collections.abc import Sequence

from ....drawing.sheets.mounting.spreading import Box
from ....drawing.sheets.slicing import Size

CLOSE = 15.0  # mm between edges that look as if they had missed one line
_SAME = 1e-6  # mm


def aligned(boxes: Sequence[Box], least: Sequence[Size]) -> list[Box]:
    """The boxes that fill a room, each with its least size, with their edges on as few lines as may be."""
    found = list(boxes)
    for axis in (0, 1):
        inner = sorted({*(one[axis] for one in found)} - {min(one[axis] for one in found)})
        for edge, other in ((a, b) for n, a in enumerate(inner) for b in inner[n + 1 :]):
            if _SAME < other - edge <= CLOSE:
                tried = (_moved(found, axis, (edge, other), edge + part * (other - edge)) for part in _PARTS)
                found = next((one for one in tried if _fit(one, axis, least)), found)
    return found


_PARTS = (0.5, 0.0, 1.0, 0.25, 0.75)  # of the way from the one edge to the other, where both are moved to


def _moved(boxes: Sequence[Box], axis: int, edges: tuple[float, float], to: float) -> list[Box]:
    """The boxes with these edges moved."""

    def at(edge: float) -> float:
        return to if min(abs(edge - one) for one in edges) < _SAME else edge

    moved = []
    for one in boxes:
        start, end = at(one[axis]), at(one[axis] + one[axis + 2])
        left, top, wide, high = one
        moved.append((start, top, end - start, high) if axis == 0 else (left, start, wide, end - start))
    return moved


def _fit(boxes: Sequence[Box], axis: int, least: Sequence[Size]) -> bool:
    """Whether each is as large as it must be."""
    return all(one[axis + 2] >= need[axis] - _SAME for one, need in zip(boxes, least, strict=True))
