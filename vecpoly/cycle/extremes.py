"""Maxima, minima and zeros of a column, found on a grid and refined on the solved mechanism itself."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from ..foundation.slotted import replace
from .curve import Curve
from .cycle import Cycle
from .facts.closing import INSIDE
from .grid import noise
from .root import highest, ridders
from .unbroken import Piece, ends, pieces, towards

Reals = NDArray[np.float64]
ROUNDING = 1e-14  # of a value: what may change by chance
LEVEL = 1e-6  # of a column's range, as far as it does not run away: extremes that differ by less are equally high
SAME = 1e-6  # rad (or part of the range): roots nearer than this are one


@dataclass(frozen=True, slots=True)
class Spot:
    """A value (SI) at a position of the drive (rad, or m); end: at an end of the drive's range, or where the column
    breaks off or jumps, not a turning point.

    ±∞ where the value runs away towards that end.
    """

    phi: float
    value: float
    end: bool = False


@dataclass(frozen=True, slots=True)
class Extremes:
    """Turning points and zeros of one column in order of the drive's position;
    highest and lowest of all, None of a lost column."""

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


_FOUND: WeakKeyDictionary[Cycle, dict[str, Extremes]] = WeakKeyDictionary()


def extremes(cycle: Cycle, key: str) -> Extremes:
    """Maxima, minima and zeros over the drive's whole range, to full accuracy:
    the mechanism is solved again around each.

    A vector's are those of its magnitude. f'(φ) = 0 by Ridders' method on the oracle's derivative where it has one (φ,
    ω, p, v), else on a seven-point difference; at a sharp bend by shrinking the bracket. A column that breaks off or
    jumps also has the values at its ends, ±∞ where it runs away towards one. Raises UnknownNameError.
    """
    kept = _FOUND.setdefault(cycle, {})
    if key not in kept:
        kept[key] = _extremes(cycle, key)
    return kept[key]


def _extremes(cycle: Cycle, key: str) -> Extremes:
    curve = Curve.of(cycle, key)
    phi, f = curve.grid()
    known = f[np.isfinite(f)]
    if not known.size:
        return Extremes(key, (), (), (), None, None)
    if _is_rate_of_nothing(cycle, key):
        return Extremes(key, (), (), (), Spot(cycle.low, 0.0), Spot(cycle.low, 0.0))
    if known.max() - known.min() <= noise(cycle.mech) * max(float(np.abs(known).max()), curve.size):
        flat = Spot(cycle.low, float(known.mean()))
        return Extremes(key, (), (), (), flat, flat)
    parts = pieces(curve, phi, f)
    maxima, minima = (
        _spots(curve, np.concatenate(places)) for places in zip(*(_turning(curve, part) for part in parts), strict=True)
    )
    broken = [
        Spot(float(curve.reduced(np.array([q]))[0]), value, True) for part in parts for q, value in ends(curve, part)
    ]
    span = float(known.max() - known.min())
    found, grid = (*maxima, *minima, *_ends(curve, span), *broken), tuple(_on_grid(curve, phi, f))
    usual = curve.size + float(np.median(np.abs(known)))  # of a column that runs away the greatest tells nothing
    small, level = 1e-9 * min(float(np.abs(known).max()), usual), LEVEL * min(span, usual)
    touching = tuple(spot for spot in (*maxima, *minima) if abs(spot.value) <= small)
    return Extremes(
        key,
        maxima,
        minima,
        _crossing(curve, parts, touching),
        _farthest(found, grid, 1.0, level),
        _farthest(found, grid, -1.0, level),
    )


def _is_rate_of_nothing(cycle: Cycle, key: str) -> bool:
    """Whether it is the rate of a column that does not change while the drive moves evenly: α of a link that only
    translates, whose rounding grows towards a dead point."""
    drive = cycle.mech.drive
    if drive.rate == 0.0 or drive.accel != 0.0:
        return False
    of = next((one.key for one in cycle.columns if one.rate == key and not one.is_vector), None)
    return of is not None and extremes(cycle, of).is_constant


def _farthest(found: tuple[Spot, ...], grid: tuple[Spot, ...], sign: float, level: float) -> Spot:
    """The greatest (sign −1: the least) of all; of those that are level with it the first, as a curve marks it, with
    the value that no other passes: at the ends of a range each is known to the root of rounding only."""
    most = max((*found, *grid), key=lambda spot: sign * spot.value)
    alike = (spot for spot in found if sign * (most.value - spot.value) <= level or spot.value == most.value)
    return replace(min(alike, key=lambda spot: spot.phi, default=most), value=most.value)


def _on_grid(curve: Curve, phi: Reals, f: Reals) -> Iterator[Spot]:
    """The greatest and least value on the grid, which nothing that is found may fall short of by more than rounding."""
    phi, f = phi[phi <= curve.cycle.high], f[phi <= curve.cycle.high]
    for i, sign in ((int(np.nanargmax(f)), -1.0), (int(np.nanargmin(f)), 1.0)):
        small = 1e-12 * (abs(float(f[i])) + curve.size)
        yield Spot(float(curve.reduced(phi[i : i + 1])[0]), float(f[i]) + sign * small)


def _turning(curve: Curve, piece: Piece) -> tuple[Reals, Reals]:
    """Places of the maxima and minima of an unbroken piece."""
    rise = np.diff(piece.f)
    about = np.maximum(np.abs(piece.f[:-1]), np.abs(piece.f[1:]))  # elsewhere it may run away
    rise[np.abs(rise) <= ROUNDING * about + noise(curve.cycle.mech) * curve.size] = 0.0
    moving = np.flatnonzero(rise)  # what stands still between two of them is level
    top = rise[moving[:-1]] > 0
    turn = np.flatnonzero(top != (rise[moving[1:]] > 0))
    low, high = piece.phi[moving[turn]], piece.phi[moving[turn + 1] + 1]
    top = top[turn]
    step = (high - low) / 2
    at = ridders(lambda q: curve.slope(q, step), low, high)
    doubtful = ~np.isfinite(at) if curve.rate else np.ones(at.shape, np.bool_)
    at[doubtful] = _sharper(curve, at[doubtful], np.where(top[doubtful], 1.0, -1.0), low[doubtful], high[doubtful])
    return at[top], at[~top]


def _sharper(curve: Curve, at: Reals, sign: Reals, low: Reals, high: Reals) -> Reals:
    """Each top, or where a bend within its bracket stands higher (a slide changes its side:
    the differences smear it), that bend."""
    if not at.size:
        return at
    bend = highest(lambda q: np.repeat(sign, q.size // sign.size) * curve.value(q), low, high)
    smooth, sharp = (sign * curve.value(place) for place in (np.where(np.isfinite(at), at, bend), bend))
    better = sharp - smooth > 1e-12 * (np.abs(smooth) + curve.size)
    return np.where(better | ~np.isfinite(at), bend, at)


def _crossing(curve: Curve, parts: tuple[Piece, ...], touching: tuple[Spot, ...]) -> tuple[Spot, ...]:
    change = [(part, np.flatnonzero(np.signbit(part.f[:-1]) != np.signbit(part.f[1:]))) for part in parts]
    low, high = (np.concatenate([part.phi[at + i] for part, at in change]) for i in (0, 1))
    found = _spots(curve, ridders(curve.value, low, high))
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
    """Values at the ends of the drive's range, ±∞ where it runs away;
    none of a whole turn that comes back to the same value."""
    cycle = curve.cycle
    first, last = (float(value) for value in curve.value(np.array([cycle.low, cycle.high])))
    inside, again = (float(value) for value in curve.value(cycle.low + INSIDE + np.array([0.0, cycle.period])))
    if cycle.whole and not max(abs(last - first), abs(again - inside)) > 1e-6 * span:
        return ()
    room = cycle.high - cycle.low
    told = ((cycle.low, first, 1.0), (cycle.high, last, -1.0))
    return tuple(
        Spot(q, value if cycle.whole else towards(curve, q, inward, value, room), True)
        for q, value, inward in told
        if np.isfinite(value)
    )
