"""How much of a page stays white in one piece: the largest rectangle on which nothing is drawn."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from math import ceil

import numpy as np

from ...details.room import Spots
from ...scene import Fill, Item, Rect, Scene, Stroke, rect_of
from ..slicing import Size

CELL = 6.0  # mm: how finely white is looked for


def inked(scenes: Iterable[Scene], extents: Rect) -> Spots:
    """The middles of half cells on which something is drawn, from the lower left corner of these extents."""
    half, low = CELL / 2, complex(extents.x0, extents.y0)
    ends = np.array([line for scene in scenes for item in scene.items for line in _lines(item)], dtype=complex)
    a, way = ends[:, 0] - low, ends[:, 1] - ends[:, 0]
    count = np.ceil(np.abs(way) / half).astype(int) + 1
    number = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    at = (np.repeat(a, count) + np.repeat(way / np.maximum(count - 1, 1), count) * number) / half
    cells = np.unique(np.floor(at.real) + 1j * np.floor(at.imag))
    return np.asarray((cells + 0.5 + 0.5j) * half, dtype=complex)


def _lines(item: Item) -> Iterator[tuple[complex, complex]]:
    """The lines of an item; of an area its edge, and from its middle to its corners."""
    if isinstance(item, Stroke):
        yield from pairwise((*item.points, item.points[0]) if item.closed else item.points)
        return
    corners = item.points if isinstance(item, Fill) else rect_of(item).corners
    middle = sum(corners) / len(corners)
    yield from pairwise((*corners, corners[0]))
    yield from ((middle, corner) for corner in corners)


def white(ink: Sequence[Spots], page: Size) -> float:
    """The share of a page of the largest rectangle that ink at these points leaves free."""
    wide, high = (ceil(side / CELL) for side in page)
    taken = np.zeros((high, wide), dtype=bool)
    for some in ink:
        rows, columns = (some.imag // CELL).astype(int), (some.real // CELL).astype(int)
        taken[rows.clip(0, high - 1), columns.clip(0, wide - 1)] = True
    depth, best = [0] * wide, 0
    for row in taken.tolist():
        depth = [0 if cell else above + 1 for cell, above in zip(row, depth, strict=True)]
        best = max(best, *_areas(depth))
    return best / (wide * high)


def _areas(depth: Sequence[int]) -> Iterator[int]:
    """Of the rectangles under a skyline, each as wide as its height allows."""
    rising = list[tuple[int, int]]()  # where each began, and how high it is
    for x, now in enumerate((*depth, 0)):
        start = x
        while rising and rising[-1][1] >= now:
            start, high = rising.pop()
            yield high * (x - start)
        rising.append((start, now))
