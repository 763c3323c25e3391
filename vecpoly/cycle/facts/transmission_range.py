"""The least and the greatest transmission angle of a dyad over the cycle."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..columns import dyads
from ..cycle import Cycle
from ..extremes import Spot, extremes
from ..root import ridders
from .transmission import folded

USUAL, ABOUT = 40.0, 39.5  # degrees: the usual bound of transmission angles, and what to a whole degree is as much
POOR, FOLDED = np.radians(ABOUT), np.radians(15.0)  # below: poor transmission; nearly folded
_STEADY = 1e-9  # rad


@dataclass(frozen=True, slots=True)
class Transmission:
    """The folded transmission angle of a dyad over the cycle: least and greatest (rad) with the drive's positions."""

    key: str
    links: str
    kind: str
    least: Spot
    greatest: Spot

    @property
    def is_constant(self) -> bool:
        """Whether it is the same in every position, so that none has the least."""
        return self.greatest.value - self.least.value <= _STEADY

    @property
    def is_poor(self) -> bool:
        """Whether it falls below 40°, the usual bound, by more than a drawing tells."""
        return bool(self.least.value < POOR)

    @property
    def is_folded(self) -> bool:
        """Whether the dyad comes so near its folded position (15°) that rates depend strongly on every length."""
        return bool(self.least.value < FOLDED)


def transmission(cycle: Cycle, key: str) -> Transmission | None:
    """The least and the greatest acute angle of a column gamma_23; None of one without values."""
    name = key.removeprefix("gamma_")
    return transmission_of(cycle, name, dyads(cycle.mech)[name].kind)


def transmission_of(cycle: Cycle, name: str, kind: str) -> Transmission | None:
    """The extremes of γ, of which those near 180° count as their supplement."""
    key = f"gamma_{name}"
    found = extremes(cycle, key)
    if found.highest is None or found.lowest is None:
        return None
    both = [Spot(s.phi, float(folded(np.array(s.value))), s.end) for s in (found.highest, found.lowest)]
    crossed = found.highest.value >= np.pi / 2 >= found.lowest.value
    least = min(both, key=lambda s: s.value)
    greatest = max(both, key=lambda s: s.value)
    if crossed:
        greatest = Spot(_right_angle(cycle, key, greatest.phi), np.pi / 2)
    return Transmission(key, name, kind, least, greatest)


def _right_angle(cycle: Cycle, key: str, otherwise: float) -> float:
    """The first position where γ passes 90°."""
    phi, gamma = cycle.on_grid(key)
    with np.errstate(invalid="ignore"):
        change = np.flatnonzero((gamma[:-1] - np.pi / 2) * (gamma[1:] - np.pi / 2) <= 0)
    found = ridders(lambda q: np.asarray(cycle.at(key, q), np.float64) - np.pi / 2, phi[change], phi[change + 1])
    sound = found[np.isfinite(found)]
    return float(sound.min()) if sound.size else otherwise
