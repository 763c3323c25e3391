"""An arrow that lies on a bar cannot be told from it: it is set farther out on its line, past the end of the bar."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

import numpy as np

from ....board.paper.marks import Mark, Plate, Role, Segment

Bar = tuple[complex, complex]

ON, MOST = 0.7, 0.25  # mm from a bar within which an arrow lies on it; the share of it that may
LEAN = 0.1  # rad: one that leans more is told from the bar at sight
STEP, FARTHEST = 1.0, 60.0  # mm by which it is set out, at most
PAST = 2.0  # mm past the end of the bar
SHAFT = np.linspace(0.0, 1.0, 21)
SHORT = 0.1  # mm


def bars_of(marks: Iterable[Mark]) -> Iterator[Bar]:
    """The bars, and the edges of plates."""
    for mark in marks:
        match mark:
            case Segment(a=a, b=b, role=Role.LINK) if abs(b - a) > SHORT:
                yield a, b
            case Plate(points=points):
                yield from pairwise((*points, points[0]))
            case _:
                pass


def is_hidden(start: complex, end: complex, bars: Iterable[Bar]) -> bool:
    """Whether an arrow runs along a bar, and lies on it."""
    return any(_leans(start, end, *bar) < LEAN and _share(start, end, *bar) > MOST for bar in bars)


def past_bars(start: complex, end: complex, out: complex, bars: Sequence[Bar]) -> float:
    """How far (mm) an arrow is to be set out, along this unit vector, until it lies on no bar; 0 where it lies on none,
    or where that is too far."""
    if not is_hidden(start, end, bars):
        return 0.0
    for by in np.arange(STEP, FARTHEST, STEP):
        moved = (start + by * out, end + by * out)
        if all(_share(*moved, *bar) == 0.0 for bar in bars):
            return float(by) + PAST
    return 0.0


def _leans(start: complex, end: complex, a: complex, b: complex) -> float:
    """The angle between an arrow and a bar (rad, to 90°)."""
    way = (end - start) / (b - a)
    return abs(cmath.phase(way if way.real > 0 else -way))


def _share(start: complex, end: complex, a: complex, b: complex) -> float:
    """The part of an arrow that lies on a bar."""
    if abs(b - a) < SHORT:
        return 0.0
    shaft = (start + (end - start) * SHAFT - a) / (b - a)
    on = (shaft.real > 0.0) & (shaft.real < 1.0) & (abs(shaft.imag) * abs(b - a) < ON)
    return float(on.mean())
