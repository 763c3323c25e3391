"""The French curve: J_e and M_e between the positions that were drawn, smooth from one corner of the loads to the next.

ψ is the drive's way in the sense of its motion, from φ = 0 on (rad). Everything here comes from velocity polygons on
scratch paper, at Gauss's places of each piece; through them a polynomial is laid as a hand lays its curve. Where a
piece bends more than a polynomial follows (a crank-rocker near its change point), it is halved, and places are drawn
closer: a smooth curve of degree n is off by about its last coefficients, so these are what a piece is halved for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import pairwise
from math import lcm

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from ...mechanism.laws.sizes import Table
from ...mechanism.laws.windows import During, Moving
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ..exchange.profile import corners
from ..positions.laps import laps
from ..roots import halved
from .changes import bends, jumps
from .turn import Station, stations

Array = NDArray[np.float64]
Piece = tuple[float, float, Array, Array]  # from, to; coefficients of M and of J_e
Fit = Callable[[float, float], tuple[Array, Array]]
LOOKED, PIECE = np.radians(7.5), np.radians(20.0)  # where corners are looked for; no piece is longer
CLOSEST = np.radians(0.5)  # looked for no closer than that
NODES = 14
TAIL, DEEPEST = (
    1e-12,
    7,
)  # of the greatest value: the last coefficients are rounding; a piece is halved so often at most
SAMPLES, HALVINGS = 41, 60
_AT, _WEIGHTS = legendre.leggauss(NODES)
_FITTED = legendre.legvander(_AT, NODES - 1).T * _WEIGHTS * (np.arange(NODES) + 0.5)[:, None]


@dataclass(frozen=True, slots=True, eq=False)
class French:
    """cuts: ends of the pieces; moments (positive where the load drives), inertias: coefficients, a row a piece.

    corners: where a load jumps. mean: the constant moment (N·m) that does the work of the loads, with its sign.
    """

    sense: float
    cuts: Array
    moments: Array
    inertias: Array
    corners: tuple[float, ...]
    mean: float

    @property
    def period(self) -> float:
        """2π, or some turns (rad)."""
        return float(self.cuts[-1])

    def moment(self, psi: float, *, before: bool = False) -> float:
        """M of the given loads; at a corner as it is before it, or behind."""
        return self._at(self.moments, psi, before)

    def inertia(self, psi: float) -> float:
        """J_e."""
        return self._at(self.inertias, psi, before=False)

    def work(self, psi: float, constant: float) -> float:
        """∫ (M + constant) dψ from 0 (J)."""
        half = np.diff(self.cuts) / 2
        piece = self._piece(psi, before=True)
        whole = legendre.legint(self.moments[piece], lbnd=-1) * half[piece]
        done = 2 * float(half[:piece] @ self.moments[:piece, 0])
        return float(done + legendre.legval(self._within(piece, psi), whole) + constant * psi)

    def highest(self, weight: float, constant: float, sign: float) -> float:
        """Where sign · (E − weight · J_e) is greatest: at a turning point, or at a corner."""

        rises = legendre.legder(self.inertias, axis=1)

        def slope(piece: int, x: Array) -> Array:
            half = (self.cuts[piece + 1] - self.cuts[piece]) / 2
            rise = legendre.legval(x, rises[piece]) / half
            return np.asarray(sign * (legendre.legval(x, self.moments[piece]) + constant - weight * rise))

        places = [*map(float, self.cuts), *self._roots(slope)]
        return max(places, key=lambda psi: sign * (self.work(psi, constant) - weight * self.inertia(psi)))

    def crossings(self, level: float) -> tuple[float, ...]:
        """Where M runs through this level, without a jump."""
        found = [*self._roots(lambda piece, x: np.asarray(legendre.legval(x, self.moments[piece])) - level)]
        return tuple(sorted(found))

    def _roots(self, f: Callable[[int, Array], Array]) -> Iterator[float]:
        grid = np.linspace(-1.0, 1.0, SAMPLES)
        for piece, (a, b) in enumerate(pairwise(self.cuts)):
            values = f(piece, grid)
            for i in np.flatnonzero(values[:-1] * values[1:] < 0):
                x = halved(partial(_alone, f, piece), float(grid[i]), float(grid[i + 1]), HALVINGS)
                yield float(a + (b - a) / 2 * (1 + x))

    def _at(self, rows: Array, psi: float, before: bool) -> float:
        piece = self._piece(psi, before=before)
        return float(legendre.legval(self._within(piece, psi), rows[piece]))

    def _piece(self, psi: float, *, before: bool) -> int:
        place = int(np.searchsorted(self.cuts, psi, "left" if before else "right")) - 1
        return min(max(place, 0), len(self.cuts) - 2)

    def _within(self, piece: int, psi: float) -> float:
        a, b = self.cuts[piece], self.cuts[piece + 1]
        return float(2 * (psi - a) / (b - a) - 1)


def _alone(f: Callable[[int, Array], Array], piece: int, x: float) -> float:
    return float(f(piece, np.array(x)))


@lru_cache(maxsize=16)
def french(mech: Mechanism, loads: Loads) -> French:
    """Corners first, then every piece. Raises AssemblyError, DeadPointError."""
    sense = float(np.sign(mech.drive.rate)) or 1.0
    period = 2 * np.pi * lcm(loads.turns, laps(mech))
    looked = _looked(loads, sense, period)
    places = looked if sense > 0 else [-one for one in reversed(looked)]
    own, bent = (sorted(sense * q % period for q in of(mech, loads, places)) for of in (jumps, bends))
    laws = _again([sense * place for place in corners(mech)], 2 * np.pi, period)
    fit = partial(_fitted, partial(stations, mech, loads), sense)
    rough = [(a, b, *fit(a, b)) for a, b in pairwise(_cuts(loads, sense, period, [*own, *bent, *laws]))]
    great = tuple(max(float(np.abs(piece[k]).sum(axis=-1)) for piece in rough) for k in (2, 3))
    pieces = [part for piece in rough for part in _settled(piece, fit, great, DEEPEST)]
    cuts = np.array([0.0, *(piece[1] for piece in pieces)])
    moments, inertias = (np.array([piece[k] for piece in pieces]) for k in (2, 3))
    mean = -float(np.diff(cuts) @ moments[:, 0]) / period if loads.constant is not None else 0.0
    return French(sense, cuts, moments, inertias, tuple(own), mean)


def _again(places: Sequence[float], every: float, period: float) -> list[float]:
    """What recurs after every so much of the drive's way, within the period (rad)."""
    return [(place + every * k) % period for place in places for k in range(max(round(period / every), 1))]


def _looked(loads: Loads, sense: float, period: float) -> list[float]:
    """Places so near each other that no load begins and ends between two of them: within every part of the drive's
    turn in which one acts, and in which it does not; of a part of a stroke two, also at thrice its mean speed.
    """
    windows = [one for load in loads.all if load.law is not None for one in load.law.windows]
    parts = [window.high - window.low for window in windows if isinstance(window, Moving)]
    step = max(min([LOOKED, *(part / 2 for part in parts)]), CLOSEST)
    even = np.linspace(0.0, period, round(period / step) + 1)
    within = [
        place
        for one in windows
        if isinstance(one, During) and one.period
        for start, end in ((one.low, one.high), (one.high, one.low))
        for place in _again([sense * (start + (end - start) % one.period / 2)], one.period, period)
    ]
    return [float(x) for x in np.unique(np.concatenate([even, within]))]


def _cuts(loads: Loads, sense: float, period: float, own: list[float]) -> Array:
    """Ends of pieces: even ones, the jumps, the corners of tables."""
    even = np.linspace(0.0, period, round(period / PIECE) + 1)
    tables = [load.law.size for load in loads.all if load.law is not None]
    over_drive = [
        place
        for table in tables
        if isinstance(table, Table) and table.over is None and table.period
        for place in _again([sense * place for place in table.places], table.period, period)
    ]
    cuts = np.unique(np.concatenate([even, own, over_drive]))
    return np.asarray(cuts[np.append(True, np.diff(cuts) > 1e-9)], np.float64)


def _fitted(drawn: Callable[[Sequence[float]], list[Station]], sense: float, a: float, b: float) -> tuple[Array, Array]:
    """Coefficients of M and J_e between two places."""
    there = drawn([float(sense * (a + (b - a) / 2 * (1 + x))) for x in _AT])
    moments = np.array([sense * float(one.moment) for one in there])
    inertias = np.array([float(one.inertia) for one in there])
    return _FITTED @ moments, _FITTED @ inertias


def _settled(piece: Piece, fit: Fit, great: tuple[float, ...], deep: int) -> Iterator[Piece]:
    """The piece, or its halves, until the last coefficients are rounding beside the greatest values."""
    a, b, *rows = piece
    if not deep or all(np.abs(row[-2:]).max() <= TAIL * size for row, size in zip(rows, great, strict=True)):
        yield piece
        return
    middle = (a + b) / 2
    for low, high in ((a, middle), (middle, b)):
        yield from _settled((low, high, *fit(low, high)), fit, great, deep - 1)
