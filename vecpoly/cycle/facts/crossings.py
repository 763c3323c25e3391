"""Where a path passes through one point twice."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ..cycle import Cycle
from ..sample import sample

Points = NDArray[np.complex128]
Reals = NDArray[np.float64]
NEWTON = 12
STILL = 1e-9  # of the path's size: a step of less is rounding, the point rests


def crossings(cycle: Cycle, point: str, phi: Reals, p: Points, closed: bool) -> list[tuple[complex, float, float]]:
    """Self-intersections of the polygon p, each refined on the mechanism by Newton's method on p(s) = p(t):
    place, s, t."""
    found: list[tuple[complex, float, float]] = []
    size = float(np.abs(p - p[0]).max())
    pairs = np.array(list(_pairs(p, closed)), np.intp).reshape(-1, 2)
    for refined in _refined(cycle, point, phi[pairs.T]):
        at, first, _ = refined
        if all(abs(at - other) > 1e-6 * size or abs(first - one) > 1e-5 for other, one, _ in found):
            found.append(refined)
    return sorted(found, key=lambda item: item[1])


def _pairs(p: Points, closed: bool) -> Iterator[tuple[int, int]]:
    """Indices of pairs of sides that cross; neighbours do not count, nor the sides of a rest."""
    a, d = p[:-1], np.diff(p)
    n = len(d)
    ahead = np.maximum(p[1:].real, a.real), np.minimum(p[1:].real, a.real)
    moves = np.abs(d) > STILL * np.abs(p - p[0]).max()
    for i in np.flatnonzero(moves[:-2]):
        j = np.arange(i + 2, n - (1 if closed and i == 0 else 0))
        j = j[moves[j] & (ahead[0][j] >= ahead[1][i]) & (ahead[1][j] <= ahead[0][i])]
        gap = a[j] - a[i]
        one = (np.conj(d[i]) * gap).imag * (np.conj(d[i]) * (gap + d[j])).imag
        two = (np.conj(d[j]) * -gap).imag * (np.conj(d[j]) * (d[i] - gap)).imag
        yield from ((int(i), int(k)) for k in j[(one <= 0) & (two <= 0)])


def _refined(cycle: Cycle, point: str, x: Reals) -> Iterator[tuple[complex, float, float]]:
    """p(s) = p(t) from all pairs (2 × pairs) at once; none of those where the two run together:
    a touch, or a path swept to and fro."""
    for _ in range(NEWTON if x.size else 0):
        here = sample(cycle.mech, None, x.ravel())
        p, v = (
            here.value(f"p_{point}").reshape(x.shape),
            here.value(f"v_{point}").reshape(x.shape) / cycle.mech.drive.rate,
        )
        det = np.imag(np.conj(v[0]) * v[1])
        with np.errstate(invalid="ignore"):
            sound = np.isfinite(det) & (np.abs(det) > 1e-9 * np.abs(v[0]) * np.abs(v[1]))
        gap = (p[1] - p[0])[sound]
        step = np.imag(np.conj(gap) * v[::-1, sound]) / det[sound]
        x = x[:, sound] + step
        if not float(np.abs(step).max(initial=0.0)) >= 1e-14:
            break
    full = cycle.high - cycle.low
    x = cycle.low + np.mod(x - cycle.low, full) if cycle.whole else x
    first, second = np.sort(x, axis=0)
    apart = np.minimum(second - first, full - (second - first) if cycle.whole else full) >= 1e-4
    if apart.any():
        places = np.asarray(cycle.at(f"p_{point}", first[apart]), np.complex128)
        yield from zip(places.tolist(), first[apart].tolist(), second[apart].tolist(), strict=True)
