"""Places at which a smooth curve is set out so that the area below it can be told exactly: Gauss' places in strips that
are cut in two as long as a finer division would tell another area."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from numpy.polynomial import legendre

from ...plane import Reals

COARSE, FINE = (legendre.leggauss(n) for n in (6, 10))
ORDERS = np.arange(len(FINE[0]))
# A row a place: the polynomial that is 1 there and 0 at the others; and, of all, ∫ from the start up to each place.
ALONE = legendre.legvander(FINE[0], ORDERS[-1]) * FINE[1][:, None] * (ORDERS + 0.5)
RISING = np.array([legendre.legval(FINE[0], legendre.legint(one, lbnd=-1)) for one in ALONE]).T
NEAR, MOST = 1e-8, 40  # of the area: by how much it may change; how often a strip is halved at most
Array = npt.NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Strip:
    """From one place to another, with the places between at which the curve is set out, and what each counts."""

    start: float
    end: float
    places: tuple[float, ...]
    weights: tuple[float, ...]


def strips(curve: Callable[[Array], Array], stops: Sequence[float]) -> tuple[Strip, ...]:
    """The strips between these places, each as fine as the curve asks for."""
    return tuple(strip for a, b in itertools.pairwise(stops) for strip in _divided(curve, a, b, 0))


def _divided(curve: Callable[[Array], Array], a: float, b: float, deep: int) -> Iterator[Strip]:
    areas = [float(curve(a + (b - a) * (at + 1) / 2) @ weight) for at, weight in (COARSE, FINE)]
    if deep > MOST or abs(areas[0] - areas[1]) <= NEAR * abs(areas[1]):
        at, weight = FINE
        half = (b - a) / 2
        yield Strip(
            start=a,
            end=b,
            places=tuple(float(x) for x in a + half * (at + 1)),
            weights=tuple(float(x) for x in half * weight),
        )
        return
    for low, high in ((a, (a + b) / 2), ((a + b) / 2, b)):
        yield from _divided(curve, low, high, deep + 1)


def root(function: Callable[[float], float], low: float, high: float) -> float:
    """The place between these at which a function is zero, by halving; its signs there differ."""
    sign = function(low) > 0
    for _ in range(200):
        middle = (low + high) / 2
        if middle in (low, high):
            break
        low, high = (middle, high) if (function(middle) > 0) is sign else (low, middle)
    return (low + high) / 2


def summed(weights: Sequence[float], sizes: Sequence[Reals]) -> Reals:
    """Σ w y, by every hand."""
    total: Reals = 0.0
    for weight, size in zip(weights, sizes, strict=True):
        total = total + weight * size
    return total


def running(strip: Strip, sizes: Sequence[Reals]) -> list[Reals]:
    """The area from the start of a strip up to each of its places, by every hand."""
    half = (strip.end - strip.start) / 2
    return [summed([half * float(share) for share in row], sizes) for row in RISING]
