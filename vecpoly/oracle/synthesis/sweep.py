"""Where the lesser of two smooth functions on (0, 1) takes a value, and where it is greatest, to the last digits.

The functions are worked out at many places at once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise
from math import isnan, sqrt
from typing import Any

import numpy as np
import numpy.typing as npt

DENSE = 2000  # trials over the range
GOLDEN = (sqrt(5) - 1) / 2
MEETING = 1e-6  # of two functions at their summit: it is where they cross
STEP = 0.1  # of the distance of two trials: that of central differences
Function = Callable[[Any], Any]  # of one place or of an array of them
Both = Callable[[Any], tuple[Any, Any]]
Trials = list[tuple[float, float]]  # places, and what the function is there


def _trials() -> npt.NDArray[np.float64]:
    """Trials inside the range, its ends left out."""
    return np.linspace(0, 1, DENSE + 2)[1:-1]


def crossings(both: Both, value: float) -> Iterator[float]:
    """Every place where the lesser takes the value."""

    def off(x: Any) -> Any:
        return np.minimum(*both(x)) - value

    places = np.array([0.0, *_trials()])
    at: Trials = list(zip(places.tolist(), off(places).tolist(), strict=True))
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
            yield good, float(of(good))


def _peaks(of: Function, at: Trials) -> Iterator[tuple[float, float]]:
    """Every top and every bottom between the trials, where the value may be passed twice."""
    for (low, f0), (_, f1), (high, f2) in zip(at, at[1:], at[2:], strict=False):
        if f0 <= f1 >= f2 or f0 >= f1 <= f2:
            way = 1.0 if f0 <= f1 else -1.0
            top = _golden(lambda x, way=way: way * of(x), low, high)  # type: ignore[misc]
            yield top, float(of(top))


def _root(of: Function, low: float, high: float) -> float:
    """By halves, down to two neighbouring numbers."""
    above = of(low) > 0
    middle = (low + high) / 2
    while low < middle < high:
        low, high = (middle, high) if (of(middle) > 0) == above else (low, middle)
        middle = (low + high) / 2
    return middle


def summits(both: Both) -> Iterator[float]:
    """The place where the lesser is greatest; none where it grows towards an end of the range.

    There both are equal, or the slope of the lesser vanishes.
    """
    at = _trials().tolist()
    values = np.minimum(*both(_trials()))
    best = 0 if np.isnan(values).all() else int(np.nanargmax(values))
    if not 0 < best < len(at) - 1:
        return
    low, high = at[best - 1], at[best + 1]
    top = _golden(lambda x: np.minimum(*both(x)), low, high)
    one, other = both(top)
    if abs(one - other) < MEETING:
        yield _root(lambda x: np.subtract(*both(x)), low, high)
    else:
        which, h = int(other < one), STEP * (high - low)
        yield _root(lambda x: _slope(lambda y: both(y)[which], x, h), max(low, top - h), min(high, top + h))


def _slope(of: Function, x: float, h: float) -> float:
    """Twelve times h times the slope, by central differences of fourth order."""
    ahead, behind, far_ahead, far_behind = of(np.array([x + h, x - h, x + 2 * h, x - 2 * h]))
    return float(8 * (ahead - behind) - (far_ahead - far_behind))


def _golden(of: Function, low: float, high: float) -> float:
    """Golden section: the range shrinks by 0.618 a trial."""
    for _ in range(60):
        left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        at_left, at_right = of(np.array([left, right]))
        low, high = (left, high) if at_left < at_right else (low, right)
    return (low + high) / 2


def greatest(of: Function) -> float:
    """The maximum on [0, 1], ends included: the best of many trials, then by golden section between its neighbours."""
    at = np.arange(DENSE + 1) / DENSE
    values = of(at)
    best = int(np.argmax(values))
    top = _golden(of, float(at[max(best - 1, 0)]), float(at[min(best + 1, DENSE)]))
    return float(max(values[best], of(top)))
