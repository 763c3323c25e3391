"""M_e and J_e over a period as polynomials, for a motion of any speed: springs, dampers and motors are linear in ω."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre

from ...foundation.slotted import replace
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ..forces.laws.corners import corners
from ..forces.laws.drives import drive_range
from ..forces.laws.returning import turns_of
from ..state import Reals
from .reduced import reduce

PIECE, NODES, SAME = np.radians(10.0), 14, 1e-11
_AT, _WEIGHTS = legendre.leggauss(NODES)
_FITTED = legendre.legvander(_AT, NODES - 1).T * _WEIGHTS * (np.arange(NODES) + 0.5)[:, None]

_POWERS = np.array([np.pad(legendre.leg2poly([0.0] * k + [1.0]), (0, NODES - 1 - k)) for k in range(NODES)])


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Tables:
    """M_e = A + B ω, J_e and dJ_e/dφ: coefficients of powers of a piece's own coordinate, a row a piece."""

    cuts: Reals
    still: Reals
    drag: Reals
    inertias: Reals
    slopes: Reals

    def at(self, phi: float, omega: float) -> tuple[float, float, float]:
        """M_e, J_e, dJ_e/dφ at a state."""
        low, high = float(self.cuts[0]), float(self.cuts[-1])
        place = low + (phi - low) % (high - low)
        piece = min(max(int(np.searchsorted(self.cuts, place, "right")) - 1, 0), len(self.cuts) - 2)
        a, b = float(self.cuts[piece]), float(self.cuts[piece + 1])
        powers = np.power(2 * (place - a) / (b - a) - 1, np.arange(NODES))
        moment = float(powers @ self.still[piece]) + omega * float(powers @ self.drag[piece])
        return moment, float(powers @ self.inertias[piece]), float(powers @ self.slopes[piece])


def tables(mech: Mechanism, loads: Loads, sense: float) -> Tables:
    """For motion in this sense, from two speeds; the drive must go right round."""
    low, _, _ = drive_range(mech)
    high = low + 2 * np.pi * turns_of(mech, loads, low)
    cuts = np.unique(np.concatenate([np.linspace(low, high, round((high - low) / PIECE) + 1), corners(mech, loads)]))
    cuts = cuts[np.append(True, np.diff(cuts) > SAME)]
    places = (cuts[:-1, None] + np.diff(cuts)[:, None] / 2 * (1 + _AT)).ravel()
    one, two = (_reduced(mech, loads, places, sense * speed) for speed in (1.0, 2.0))
    drag = (two[0] - one[0]) * sense
    return Tables(
        cuts=cuts,
        still=_fitted(one[0] - drag * sense),
        drag=_fitted(drag),
        inertias=_fitted(one[1]),
        slopes=_fitted(one[2]),
    )


def _reduced(mech: Mechanism, loads: Loads, places: Reals, rate: float) -> tuple[Reals, Reals, Reals]:
    moving = replace(mech, drives=(replace(mech.drive, rate=rate, accel=0.0), *mech.drives[1:]))
    found = reduce(moving, loads, places)
    return found.power, found.energy, found.rate


def _fitted(values: Reals) -> Reals:
    """Powers of the piece's coordinate, a row a piece."""
    return np.asarray(values.reshape(-1, NODES) @ _FITTED.T @ _POWERS, np.float64)
