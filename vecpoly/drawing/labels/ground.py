"""Hatching is broken off about the letters that stand on it, as a draughtsman leaves it out there; so are
long fine lines where letters find no other place near what they name (GB/T 4458.4: no line runs through a letter)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, pairwise
from typing import Any

import numpy as np
import shapely

from ...foundation.slotted import replace
from ..scene import Item, Layer, Rect, Stroke
from ..style import THIN, Hue

HALO = 0.45  # mm between a letter and the hatching that is broken off about it
STUB = 0.6  # mm: what is shorter of a hatch line is left out, it would look like a sign beside the letter
LONG, ROUND = 25.0, 60.0  # mm: fine lines and circles so long are seen to go on behind a letter
FINE = (Hue.GREY, Hue.FAINT)


def is_ground(stroke: Stroke) -> bool:
    """Whether letters may stand on a line: hatching of an area."""
    return stroke.hue.is_tint and stroke.layer is Layer.TINT


def gives_way(stroke: Stroke) -> bool:
    """Whether a line may be broken off about a letter: a long fine one."""
    if stroke.width > THIN or (stroke.layer is not Layer.THIN and stroke.hue not in FINE) or is_ground(stroke):
        return False
    length = sum(abs(b - a) for a, b in pairwise(stroke.points))
    return length >= (ROUND if stroke.closed else LONG)


def broken(items: tuple[Item, ...], letters: Sequence[Rect]) -> tuple[Item, ...]:
    """The items of a figure, their hatching and long fine lines left out where letters stand."""
    soft = [n for n, item in enumerate(items) if isinstance(item, Stroke) and (is_ground(item) or gives_way(item))]
    if not soft or not letters:
        return items
    sides = np.array([(r.x0 - HALO, r.y0 - HALO, r.x1 + HALO, r.y1 + HALO) for r in letters])
    boxes, lines = shapely.box(*sides.T), _lines([items[n] for n in soft])
    struck, letter = shapely.STRtree(boxes).query(lines, predicate="intersects")
    holes = shapely.union_all(boxes[np.unique(letter)])
    parted = {soft[k]: lines[k].difference(holes) for k in np.unique(struck).tolist()}
    left = (_left(item, parted[n]) if n in parted else (item,) for n, item in enumerate(items))
    return tuple(chain.from_iterable(left))


def _lines(strokes: Sequence[Item]) -> Any:
    """Their shapes, those of closed ones to where they begin."""
    found = [one.points + one.points[:1] if one.closed else one.points for one in strokes if isinstance(one, Stroke)]
    flat = np.array([z for points in found for z in points], dtype=complex)
    which = np.repeat(np.arange(len(found)), [len(points) for points in found])
    return shapely.linestrings(np.stack([flat.real, flat.imag], axis=1), indices=which)


def _left(item: Item, left: shapely.Geometry) -> Iterator[Item]:
    """The pieces of a line beside the letters."""
    for part in shapely.get_parts(shapely.line_merge(left)):
        if isinstance(item, Stroke) and part.length > STUB:
            yield replace(item, points=tuple(complex(x, y) for x, y in part.coords), closed=False)
