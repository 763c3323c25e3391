"""Holes of a planned page: the largest rectangle of it that no figure takes."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from ..packing import Layout
from ..pages import Sized

Span = tuple[float, float, float, float]  # x0, y0, x1, y1


def hole(figures: Sequence[Sized], layout: Layout) -> float:
    """The share of the page of that rectangle."""
    wide, high = layout.page
    boxes = [_box(one, at) for one, at in zip(figures, layout.corners, strict=True)]
    edges = sorted({0.0, wide, *(box[0] for box in boxes), *(box[2] for box in boxes)})
    return max((b - a) * _gap(boxes, a, b, high) for a, b in combinations(edges, 2)) / (wide * high)


def _box(one: Sized, at: complex) -> Span:
    return at.real, at.imag, at.real + one.size[0], at.imag + one.size[1]


def _gap(boxes: Sequence[Span], left: float, right: float, high: float) -> float:
    """The largest height that is free from one place across to another."""
    taken = sorted((low, top) for x0, low, x1, top in boxes if x0 < right and x1 > left)
    best = reached = 0.0
    for low, top in (*taken, (high, high)):
        best, reached = max(best, low - reached), max(reached, top)
    return best
