"""Low figures of a row nearer to the middle of its height, while their titles stay on one line."""

from __future__ import annotations

from collections.abc import Sequence

from ....foundation.slotted import replace
from ...scene import Rect, Scene
from ..packing import Layout
from ..paging import Drawn, standing

SAME, LOW, MOST = 0.1, 12.0, 14.0  # mm: between lines that are one; a figure lower by this is low; that it rises
CLEAR = 4.0  # mm that it keeps of all others then


def lifted(group: Sequence[Drawn], layout: Layout) -> tuple[Drawn, ...]:
    """The figures as they are drawn; those that are low in their row higher over their titles, where nothing is in the
    way. What has details stays: these stand about it as it is."""
    boxes, lines = standing(group, layout)
    return tuple(one if one.details else _raised(one, _rise(n, boxes, lines)) for n, one in enumerate(group))


def _rise(n: int, boxes: Sequence[Rect], lines: Sequence[float]) -> float:
    """By how much: half of what it is lower than the tallest of its row."""
    row = [box.y1 for box, line in zip(boxes, lines, strict=True) if abs(line - lines[n]) < SAME]
    low = max(row) - boxes[n].y1
    by = min(low / 2, MOST)
    near = replace(boxes[n], y1=boxes[n].y1 + by).grown(CLEAR)
    free = not any(near.overlaps(box) and not boxes[n].grown(CLEAR).overlaps(box) for box in boxes)
    return by if low > LOW and free else 0.0


def _raised(one: Drawn, by: float) -> Drawn:
    """Without its title, which is drawn last."""
    if not by or one.figure is None:
        return one
    titles = 2 if one.figure.scale.symbol and one.figure.scale.value else 1
    body, title = one.scene.items[:-titles], one.scene.items[-titles:]
    return replace(one, scene=Scene.of((*Scene.of(body).moved(1j * by).items, *title)), by=one.by + 1j * by)
