"""Where a curve that is drawn by trial crosses zero, and where it is highest."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

ROUNDS = 80
HALVINGS = 45  # towards the end of the curve
FINER = 24  # further trials where the curve turns back near zero
TOUCHES = 1e-9  # of the larger of two trials: what is no smaller between them is a jump
STRIDE = 1e-7  # of the drive's position: the first secant of the last steps
POLISHINGS = 6
GOLDEN = (5**0.5 - 1) / 2

Curve = Callable[[float], float]


def halved(curve: Curve, low: float, high: float, times: int) -> float:
    """The zero between two trials of different sign, by halving, at most down to two neighbouring numbers."""
    above = curve(low) > 0
    for _ in range(times):
        middle = (low + high) / 2
        if middle in (low, high):
            break
        low, high = (middle, high) if (curve(middle) > 0) == above else (low, middle)
    return (low + high) / 2


def top(curve: Callable[[Any], Any], low: float, high: float, times: int) -> float:
    """The place of the one top between two trials, by the golden section; the curve is read at an array of places."""
    for _ in range(times):
        left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        at_left, at_right = curve(np.array([left, right]))
        narrower = (left, high) if at_left < at_right else (low, right)
        if narrower == (low, high):
            break
        low, high = narrower
    return (low + high) / 2


def crossings(curve: Curve, grid: Sequence[float], near: float) -> list[float]:
    """Zeros of the curve (NaN where it does not exist), those between neighbouring trials that nearly touch included.

    near: a gap below which the curve may touch zero between two trials.
    """
    values = [curve(float(x)) for x in grid]
    points = _refined(curve, list(zip(map(float, grid), values, strict=True)), near)
    found = [_root(curve, a, b) for a, b in pairwise(points) if a[1] * b[1] < 0 and abs(a[1] - b[1]) < np.pi]
    found += [x for x, y in points[:-1] if y == 0.0]
    return sorted(x for x in found if np.isfinite(x))


def _refined(curve: Curve, points: list[tuple[float, float]], near: float) -> list[tuple[float, float]]:
    """The trials, with more of them where the curve turns back towards the other side, or where it begins and ends."""
    return [*_between(curve, points, near), points[-1]]


def _between(curve: Curve, points: list[tuple[float, float]], near: float) -> Iterator[tuple[float, float]]:
    for i, (a, b) in enumerate(pairwise(points)):
        yield a
        neighbours = points[max(i - 1, 0) : i + 3]
        gaps = [abs(y) for _, y in neighbours if np.isfinite(y)]
        if np.isfinite(a[1]) != np.isfinite(b[1]):
            yield from _to_the_edge(curve, a, b)
            continue
        turns = (
            bool(gaps)
            and min(gaps) in (abs(a[1]), abs(b[1]))
            and not a[1] * b[1] < 0
            and min(gaps) < max(near, 2 * (max(gaps) - min(gaps)))
        )
        if turns:
            for x in np.linspace(a[0], b[0], FINER + 2)[1:-1]:
                yield float(x), curve(float(x))


def _to_the_edge(curve: Curve, a: tuple[float, float], b: tuple[float, float]) -> Iterator[tuple[float, float]]:
    """Trials that crowd towards the place where the links just meet: the curve ends there, often steeply."""
    inside, outside = (a[0], b[0]) if np.isfinite(a[1]) else (b[0], a[0])
    start = inside
    for _ in range(HALVINGS):
        middle = (inside + outside) / 2
        inside, outside = (middle, outside) if np.isfinite(curve(middle)) else (inside, middle)
    found = [inside + (start - inside) * share**3 for share in np.linspace(0.0, 1.0, FINER)[:-1]]
    yield from ((float(x), curve(float(x))) for x in sorted(found))


def _root(curve: Curve, low: tuple[float, float], high: tuple[float, float]) -> float:
    """The zero between two trials on either side of it (false position, the stale end halved);
    NaN where the curve jumps."""
    (a, fa), (b, fb) = low, high
    small = TOUCHES * max(abs(fa), abs(fb))
    for _ in range(ROUNDS):
        x = (a * fb - b * fa) / (fb - fa) if fb != fa else (a + b) / 2
        y = curve(x)
        if y == 0.0:
            return x
        if abs(b - a) < 1e-15 * max(1.0, abs(x)):
            return _polished(curve, x, y) if abs(y) < small else np.nan
        if not np.isfinite(y):
            return np.nan
        if y * fb < 0:
            a, fa = b, fb
        else:
            fa /= 2
        b, fb = x, y
    return _polished(curve, b, fb) if abs(fb) < small else np.nan


def _polished(curve: Curve, x: float, y: float) -> float:
    """The zero to the last digits: secants through the trial that is nearest so far, as long as they come nearer."""
    other = x + STRIDE * max(1.0, abs(x))
    value = curve(other)
    for _ in range(POLISHINGS):
        if y == 0.0 or not np.isfinite(value) or value == y:
            break
        new = x - y * (other - x) / (value - y)
        found = curve(new)
        if not abs(found) < abs(y):
            break
        other, value, x, y = x, y, new, found
    return x
