"""Maxima, minima and zeros of a column, found on a grid and refined on the solved mechanism itself."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .curve import Curve
from .cycle import Cycle
from .root import ridders

Reals = NDArray[np.float64]
SAME = 1e-6  # rad (or part of the range): roots nearer than this are one


@dataclass(frozen=True, slots=True)
class Spot:
    """A value (SI) at a position of the drive (rad, or m); end: at an end of the drive's range, not a turning point."""

    phi: float
    value: float
    end: bool = False


@dataclass(frozen=True, slots=True)
class Extremes:
    """Turning points and zeros of one column in order of the drive's position; highest and lowest of all, None of a lost column."""

    key: str
    maxima: tuple[Spot, ...]
    minima: tuple[Spot, ...]
    zeros: tuple[Spot, ...]
    highest: Spot | None
    lowest: Spot | None

    @property
    def is_constant(self) -> bool:
        """Whether the column does not change."""
        return not (self.maxima or self.minima) and self.highest == self.lowest


def extremes(cycle: Cycle, key: str) -> Extremes:
    """Maxima, minima and zeros over the drive's whole range, to full accuracy: the mechanism is solved again around each.

    A vector's are those of its magnitude. f'(φ) = 0 by Ridders' method on the oracle's derivative where it has one (φ, ω, p, v), else on
    a seven-point difference. Raises UnknownNameError.
    """
    curve = Curve.of(cycle, key)
    phi, f = curve.grid()
    known = f[np.isfinite(f)]
    if not known.size:
        return Extremes(key, (), (), (), None, None)
    if known.max() - known.min() <= 1e-10 * max(float(np.abs(known).max()), curve.size):
        flat = Spot(cycle.low, float(known.mean()))
        return Extremes(key, (), (), (), flat, flat)
    maxima, minima = _turning(curve, phi, f)
    every = (*maxima, *minima, *_ends(curve, float(known.max() - known.min())))
    small = 1e-9 * float(np.abs(known).max())
    touching = tuple(spot for spot in (*maxima, *minima) if abs(spot.value) <= small)
    return Extremes(key, maxima, minima, _crossing(curve, phi, f, touching), max(every, key=lambda s: s.value, default=None),
                    min(every, key=lambda s: s.value, default=None))


def _turning(curve: Curve, phi: Reals, f: Reals) -> tuple[tuple[Spot, ...], tuple[Spot, ...]]:
    """Maxima and minima."""
    with np.errstate(invalid="ignore"):
        rise = np.diff(f)
        top = (rise[:-1] > 0) & (rise[1:] <= 0)
        turn = np.flatnonzero(top | ((rise[:-1] < 0) & (rise[1:] >= 0)))
    at = ridders(curve.slope, phi[turn], phi[turn + 2])
    return _spots(curve, at[top[turn]]), _spots(curve, at[~top[turn]])


def _crossing(curve: Curve, phi: Reals, f: Reals, touching: tuple[Spot, ...]) -> tuple[Spot, ...]:
    with np.errstate(invalid="ignore"):
        change = np.flatnonzero(np.signbit(f[:-1]) != np.signbit(f[1:]))
    found = _spots(curve, ridders(curve.value, phi[change], phi[change + 1]))
    spots = sorted((*found, *touching), key=lambda s: s.phi)
    return tuple(spot for i, spot in enumerate(spots) if not i or spot.phi - spots[i - 1].phi > SAME)


def _spots(curve: Curve, at: Reals) -> tuple[Spot, ...]:
    """Each root once, in order, within the drive's range."""
    places = curve.reduced(at[np.isfinite(at)])
    if not places.size:
        return ()
    kept = np.sort(places)
    kept = kept[np.append(True, np.diff(kept) > SAME)]
    values = curve.value(kept)
    return tuple(Spot(float(q), float(v)) for q, v in zip(kept, values, strict=True) if np.isfinite(v))


def _ends(curve: Curve, span: float) -> tuple[Spot, ...]:
    """Values at the ends of the drive's range; none of a whole turn that comes back to the same value."""
    cycle = curve.cycle
    first, last = (float(value) for value in curve.value(np.array([cycle.low, cycle.high])))
    if cycle.whole and not abs(last - first) > 1e-6 * span:
        return ()
    return tuple(Spot(q, value, True) for q, value in ((cycle.low, first), (cycle.high, last)) if np.isfinite(value))
