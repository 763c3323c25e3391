"""Where the lesser of two smooth functions on (0, 1) takes a value, and where it is greatest, to the last digits."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise
from math import isnan, sqrt

import numpy as np

DENSE = 2000  # trials over the range
GOLDEN = (sqrt(5) - 1) / 2
MEETING = 1e-6  # of two functions at their summit: it is where they cross
STEP = 0.1  # of the distance of two trials: that of central differences
Function = Callable[[float], float]
Both = Callable[[float], tuple[float, float]]
Trials = list[tuple[float, float]]  # places, and what the function is there


def _trials() -> list[float]:
    """Trials inside the range, its ends left out."""
    return [float(x) for x in np.linspace(0, 1, DENSE + 2)[1:-1]]


def crossings(both: Both, value: float) -> Iterator[float]:
    """Every place where the lesser takes the value."""

    def off(x: float) -> float:
        return min(both(x)) - value

    at = [(x, off(x)) for x in (0.0, *_trials())]
    at = sorted([*at, *_ends(off, at), *_peaks(off, at)])
    for (x0, f0), (x1, f1) in pairwise(at):
        if f0 * f1 < 0:
            yield _root(off, x0, x1)


def _ends(of: Function, at: Trials) -> Iterator[tuple[float, float]]:
    """The last place with a value, between a trial that has one and a neighbour that has none."""
    for one, other in pairwise(at):
        if isnan(one[1]) != isnan(other[1]):
            good, bad = (other[0], one[0]) if isnan(one[1]) else (one[0], other[0])
            for _ in range(80):
                middle = (good + bad) / 2
                good, bad = (good, middle) if isnan(of(middle)) else (middle, bad)
            yield good, of(good)


def _peaks(of: Function, at: Trials) -> Iterator[tuple[float, float]]:
    """Every top and every bottom between the trials, where the value may be passed twice."""
    for (low, f0), (_, f1), (high, f2) in zip(at, at[1:], at[2:], strict=False):
        if f0 <= f1 >= f2 or f0 >= f1 <= f2:
            way = 1.0 if f0 <= f1 else -1.0
            top = _golden(lambda x, way=way: way * of(x), low, high)  # type: ignore[misc]
            yield top, of(top)


def _root(of: Function, low: float, high: float) -> float:
    """By halves."""
    above = of(low) > 0
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if (of(middle) > 0) == above else (low, middle)
    return (low + high) / 2


def summits(both: Both) -> Iterator[float]:
    """The place where the lesser is greatest; none where it grows towards an end of the range.

    There both are equal, or the slope of the lesser vanishes.
    """
    at = _trials()
    values = np.array([min(both(x)) for x in at])
    best = 0 if np.isnan(values).all() else int(np.nanargmax(values))
    if not 0 < best < len(at) - 1:
        return
    low, high = at[best - 1], at[best + 1]
    top = _golden(lambda x: min(both(x)), low, high)
    one, other = both(top)
    if abs(one - other) < MEETING:
        yield _root(lambda x: both(x)[0] - both(x)[1], low, high)
    else:
        which, h = int(other < one), STEP * (high - low)
        yield _root(lambda x: _slope(lambda y: both(y)[which], x, h), max(low, top - h), min(high, top + h))


def _slope(of: Function, x: float, h: float) -> float:
    """Twelve times h times the slope, by central differences of fourth order."""
    return 8 * (of(x + h) - of(x - h)) - (of(x + 2 * h) - of(x - 2 * h))


def _golden(of: Function, low: float, high: float) -> float:
    """Golden section: the range shrinks by 0.618 a trial."""
    for _ in range(60):
        left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        low, high = (left, high) if of(left) < of(right) else (low, right)
    return (low + high) / 2


def greatest(of: Function) -> float:
    """The maximum on [0, 1], ends included: the best of many trials, then by golden section between its neighbours."""
    at = [n / DENSE for n in range(DENSE + 1)]
    best = max(range(DENSE + 1), key=lambda n: of(at[n]))
    top = _golden(of, at[max(best - 1, 0)], at[min(best + 1, DENSE)])
    return max(of(at[best]), of(top))
