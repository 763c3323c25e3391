"""Hatching is broken off about the letters that stand on it, as a draughtsman leaves it out there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import shapely

from ...foundation.slotted import replace
from ..scene import Item, Layer, Rect, Stroke

HALO = 0.45  # mm between a letter and the hatching that is broken off about it
STUB = 0.6  # mm: what is shorter of a hatch line is left out, it would look like a sign beside the letter


def is_ground(stroke: Stroke) -> bool:
    """Whether letters may stand on a line: hatching of an area."""
    return stroke.hue.is_tint and stroke.layer is Layer.TINT


def broken(items: tuple[Item, ...], letters: Sequence[Rect]) -> tuple[Item, ...]:
    """The items of a figure, their hatching left out where letters stand."""
    if not any(isinstance(item, Stroke) and is_ground(item) for item in items):
        return items
    holes = shapely.union_all([_hole(rect) for rect in letters])
    return tuple(piece for item in items for piece in _left(item, holes))


def _hole(rect: Rect) -> shapely.Geometry:
    r = rect.grown(HALO)
    return shapely.box(r.x0, r.y0, r.x1, r.y1)


def _left(item: Item, holes: shapely.Geometry) -> Iterator[Item]:
    """What is left of an item: all of it, or the pieces of a hatch line beside the letters."""
    if not (isinstance(item, Stroke) and is_ground(item)):
        yield item
        return
    line = shapely.LineString([(z.real, z.imag) for z in item.points])
    if not line.intersects(holes):
        yield item
        return
    for part in shapely.get_parts(line.difference(holes)):
        if part.length > STUB:
            yield replace(item, points=tuple(complex(x, y) for x, y in part.coords))
