"""A column in unbroken pieces: where it breaks off (nothing can be assembled,
friction locks) and where it jumps (a slip changes its sense)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .curve import Curve
from .facts.breaks import breaks

Reals = NDArray[np.float64]
HALVINGS = 30  # of a step of the grid
SLIVER, EDGE = 1e-7, 1e-4
NEAR = 2.0**-10  # of a turn, or of the range: how near its end a piece is watched
# from one to the next of four places, each at a quarter of the distance from the end: a value that runs away
GROWTH = 1.4


@dataclass(frozen=True, slots=True)
class Piece:
    """An unbroken stretch of a column:
    its grid with both ends, and whether an end is a break (else an end of the grid)."""

    phi: Reals
    f: Reals
    starts: bool
    stops: bool


def pieces(curve: Curve, phi: Reals, f: Reals) -> tuple[Piece, ...]:
    """The grid of a column cut at its gaps and jumps, each end found by halving."""
    phi, f = _parted(curve, phi, f)
    known = np.isfinite(f)
    starts = np.flatnonzero(known & ~np.append(False, known[:-1]))
    stops = np.flatnonzero(known & ~np.append(known[1:], False)) + 1
    short = SLIVER * (curve.cycle.high - curve.cycle.low)  # between a dead point and the rounding beside it
    return tuple(
        Piece(phi[i:j], f[i:j], bool(i > 0), bool(j < len(f)))
        for i, j in zip(starts, stops, strict=True)
        if phi[j - 1] - phi[i] > short
    )


def _parted(curve: Curve, phi: Reals, f: Reals) -> tuple[Reals, Reals]:
    """The grid with the two sides of every break added, and a NaN between the sides of a jump."""
    left, right, fl, fr, told = _shared(curve, phi, f)
    edge = _edges(curve, phi, np.isfinite(f), told)
    more = _jumps(curve, phi, f, told)
    left, right, fl, fr = (np.concatenate(both) for both in zip((left, right, fl, fr), more, strict=True))
    every = np.concatenate([phi, edge, left, (left + right) / 2, right])
    values = np.concatenate([f, _value(curve, edge), fl, np.full(len(left), np.nan), fr])
    order = np.argsort(every, kind="stable")
    return every[order], values[order]


def _shared(curve: Curve, phi: Reals, f: Reals) -> tuple[Reals, Reals, Reals, Reals, NDArray[np.bool_]]:
    """The breaks that all columns of what presses have in common:
    both sides, the values there; and in which steps of the grid they lie."""
    told = np.zeros(len(phi) - 1, np.bool_)
    if not curve.presses:
        return *(np.empty(0) for _ in range(4)), told  # type: ignore[return-value]
    left, right = breaks(curve.cycle).T
    fl, fr = np.split(curve.value(np.append(left, right)), 2) if len(left) else (left, right)
    step = np.clip(np.searchsorted(phi, left) - 1, 0, len(told) - 1)
    smooth = np.abs(fr - fl) <= 1e-3 * np.abs(f[step + 1] - f[step]) + 1e-9 * float(np.nanmax(np.abs(f), initial=0.0))
    both = np.isfinite(f[step + 1]) & np.isfinite(f[step]) & smooth  # this column does not break here
    told[step[~both]] = True
    return left[~both], right[~both], fl[~both], fr[~both], told


def _edges(curve: Curve, phi: Reals, known: NDArray[np.bool_], told: NDArray[np.bool_]) -> Reals:
    """The last places with a value beside those without, in other steps than those told."""
    at = np.flatnonzero((known[:-1] != known[1:]) & ~told)
    inner, outer = np.where(known[at], phi[at], phi[at + 1]), np.where(known[at], phi[at + 1], phi[at])
    for _ in range(HALVINGS if len(at) else 0):
        middle = (inner + outer) / 2
        good = np.isfinite(_value(curve, middle))
        inner, outer = np.where(good, middle, inner), np.where(good, outer, middle)
    return inner


def _jumps(curve: Curve, phi: Reals, f: Reals, told: NDArray[np.bool_]) -> tuple[Reals, Reals, Reals, Reals]:
    """Both sides of every jump and the values there:
    of a step, always the half with the greater change, as long as it keeps most of the change."""
    at = _leaps(f)
    at = at[~told[at]]
    if not curve.cycle.whole:  # at a dead point the rates' rounding jumps
        edge = EDGE * (curve.cycle.high - curve.cycle.low)
        at = at[(phi[at] > curve.cycle.low + edge) & (phi[at + 1] < curve.cycle.high - edge)]
    left, right, fl, fr = phi[at], phi[at + 1], f[at], f[at + 1]
    whole = np.abs(fr - fl)
    for _ in range(HALVINGS if len(at) else 0):
        middle = (left + right) / 2
        fm = _value(curve, middle)
        first = (np.abs(fm - fl) >= np.abs(fr - fm)) | ~np.isfinite(fm)  # a place without a value: the jump itself
        right, left = np.where(first & np.isfinite(fm), middle, right), np.where(first, left, middle)
        fr, fl = np.where(first & np.isfinite(fm), fm, fr), np.where(first, fl, fm)
        kept = np.abs(fr - fl) > 0.5 * whole
        left, right, fl, fr, whole = left[kept], right[kept], fl[kept], fr[kept], whole[kept]
    return left, right, fl, fr


def _value(curve: Curve, phi: Reals) -> Reals:
    return curve.value(phi) if len(phi) else phi


def _leaps(f: Reals) -> NDArray[np.intp]:
    """Steps of the grid that stand out from both neighbours: a jump, or a sharp bend."""
    rise = np.diff(f)
    with np.errstate(invalid="ignore"):
        beside = np.fmax(np.abs(np.append(np.nan, rise[:-1])), np.abs(np.append(rise[1:], np.nan)))
        change = np.abs(
            np.fmin(np.abs(rise - np.append(np.nan, rise[:-1])), np.abs(rise - np.append(rise[1:], np.nan)))
        )
        return np.flatnonzero(
            (change > 0.5 * np.fmin(beside, np.abs(rise)))
            & (np.abs(rise) > 1e-9 * float(np.nanmax(np.abs(f), initial=0.0)))
        )


def ends(curve: Curve, piece: Piece) -> Iterator[tuple[float, float]]:
    """The ends of a piece that are breaks: place, and the value it comes to there, ±∞ where it runs away."""
    for is_break, index, inward in ((piece.starts, 0, 1.0), (piece.stops, -1, -1.0)):
        if is_break:
            yield (
                float(piece.phi[index]),
                towards(curve, float(piece.phi[index]), inward, float(piece.f[index]), float(np.ptp(piece.phi))),
            )


def towards(curve: Curve, end: float, inward: float, value: float, room: float) -> float:
    """The value at an end, ±∞ where it runs away: four places, each four times nearer, at which it grows each time.

    Where rates run away, rounding spoils what stays finite:
    a value off the trend of the four is replaced by their limit (Aitken).
    """
    reach = min(NEAR * (curve.cycle.high - curve.cycle.low), room / 2)
    near = curve.value(np.asarray(end + inward * reach * 0.25 ** np.arange(4), np.float64))
    if not np.isfinite([*near, value]).all() or reach <= 0.0:
        return value
    size, (_, before, last) = np.abs(near), np.diff(near)
    if (size[1:] > GROWTH * size[:-1]).all() and abs(value) > size[-1] > 1e-9 * curve.size:
        return float(np.copysign(np.inf, near[-1]))
    if abs(value - near[-1]) <= 4 * abs(last) + 1e-6 * size[-1]:
        return value
    return float(near[-1] + (last * last / (before - last) if abs(last) < abs(before) else 0.0))
