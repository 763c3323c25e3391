"""A detail beside its figure: in a corner that the figure leaves free, or next to it, near the place that it shows."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from ...foundation.slotted import replace
from ..details.room import Grow, Room, Spots, along, filled, reach_of
from ..scene import Fill, Item, Rect, Scene, Stroke, rect_of

KEPT = 16  # figures


def nested(scene: Scene, details: Sequence[tuple[Scene, complex]]) -> dict[Grow, tuple[complex, ...]]:
    """By how much the scene of each detail, given with the place that it shows, is moved to stand beside the figure,
    in whichever direction this may grow."""
    boxes = [one.extents for one, _ in details]
    bare = Room.about(scene.extents, [_ink(scene)], reach_of(boxes))
    moved = dict[Grow, tuple[complex, ...]]()
    for grow in Grow:
        room = replace(bare, taken=bare.taken.copy(), ink=[*bare.ink])
        found = [room.put(e, shown, grow) for e, (_, shown) in zip(boxes, details, strict=True)]
        moved[grow] = tuple(complex(at.x0 - e.x0, at.y0 - e.y0) for at, e in zip(found, boxes, strict=True))
    return moved


@lru_cache(maxsize=KEPT)
def _ink(scene: Scene) -> Spots:
    """Points of all its items; a figure is tried with ever fewer details."""
    return np.concatenate([_spots(item) for item in scene.items])


def _spots(item: Item) -> Spots:
    """Points of an item that leave no cell out."""
    if isinstance(item, Stroke):
        return along((*item.points, item.points[0]) if item.closed else item.points)
    return _inside(item.points) if isinstance(item, Fill) else filled(rect_of(item))


def _inside(points: Sequence[complex]) -> Spots:
    """A filled area with its edge."""
    import shapely  # heavy: plans of scales fill nothing

    at = np.array(points)
    spots = filled(Rect(at.real.min(), at.imag.min(), at.real.max(), at.imag.max()))
    area = shapely.Polygon([(z.real, z.imag) for z in points]).buffer(0)
    return np.concatenate([along((*points, points[0])), spots[shapely.contains_xy(area, spots.real, spots.imag)]])
