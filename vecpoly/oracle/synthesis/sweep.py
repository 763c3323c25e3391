"""Where a function of one number takes a value, and where it is greatest: by dense trial, then to the last digit."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import isnan, sqrt

import numpy as np

DENSE = 2000  # trials over the range
GOLDEN = (sqrt(5) - 1) / 2
Function = Callable[[float], float]


def _trials(low: float, high: float) -> list[float]:
    """Trials inside the range, its ends left out."""
    return [float(x) for x in np.linspace(low, high, DENSE + 2)[1:-1]]


def crossings(of: Function, value: float, low: float, high: float) -> Iterator[float]:
    """Every place where the function takes the value."""
    at = _trials(low, high)
    off = [of(x) - value for x in at]
    for x0, x1, f0, f1 in zip(at, at[1:], off, off[1:], strict=False):
        if f0 == 0:
            yield x0
        elif f0 * f1 < 0:
            yield _halved(lambda x: of(x) - value, x0, x1, f0)


def _halved(of: Function, low: float, high: float, start: float) -> float:
    for _ in range(80):
        middle = (low + high) / 2
        if (of(middle) > 0) == (start > 0):
            low = middle
        else:
            high = middle
    return (low + high) / 2


def summits(of: Function, low: float, high: float) -> Iterator[float]:
    """The place where the function is greatest; none where it has no value anywhere."""
    at = _trials(low, high)
    values = np.array([of(x) for x in at])
    if np.isnan(values).all():
        return
    best = int(np.nanargmax(values))
    yield _golden(of, at[max(best - 1, 0)], at[min(best + 1, len(at) - 1)])


def _golden(of: Function, low: float, high: float) -> float:
    """Golden section: the range shrinks by 0.618 a trial."""
    for _ in range(90):
        left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        f, g = of(left), of(right)
        if isnan(f) or (not isnan(g) and f < g):
            low = left
        else:
            high = right
    return (low + high) / 2
