"""The shaking force of a linkage on its frame, over the turn of its drive, without and with counterweights."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ...mechanism.counterweights import Counterweights
from ...mechanism.model import Mechanism
from .. import solve
from ..forces.laws.drives import drive_range
from ..motion import Motion
from ..state import Points, Reals
from .balance import Hung
from .shaking import Placed, inertia_force, placed

STATIONS = 720  # of a turn


@dataclass(frozen=True, eq=False, kw_only=True)
class Shaking:
    """F = −Σ m a_S (N) at the drive's positions `at` (rad), and where the common centre of mass is (m)."""

    at: Reals
    force: Points
    centre: Points

    @property
    def largest(self) -> tuple[float, float]:
        """|F| (N), and at which position (rad)."""
        place = int(np.abs(self.force).argmax())
        return float(np.abs(self.force[place])), float(self.at[place])

    @property
    def wander(self) -> float:
        """The greatest distance of the common centre of mass from its mean place (m)."""
        return float(np.abs(self.centre - self.centre.mean()).max())


def shaking(mech: Mechanism, asked: Counterweights, hung: Sequence[Hung] = ()) -> Shaking:
    """Over a turn, or in the mechanism's own position alone where the drive makes none; hung: what is added."""
    at, motion = _turned(mech)
    masses = [*(placed(mech, one) for one in asked.loads.masses), *(_beyond_pivot(mech, one) for one in hung)]
    moments = (mass * motion.bodies[link].point(local) for link, mass, local in masses)
    moment: Points = sum(moments, np.zeros(at.shape, np.complex128))
    total = asked.own + sum(one.mass for one in hung)
    return Shaking(at=at, force=inertia_force(motion, masses), centre=moment / total)


@lru_cache(maxsize=8)
def _turned(mech: Mechanism) -> tuple[Reals, Motion]:
    """The positions and the motion: the same with any counterweights."""
    whole = drive_range(mech)[2]
    at = np.linspace(0, 2 * np.pi, STATIONS, endpoint=False) if whole else np.atleast_1d(mech.drive.position)
    return at, solve(mech, at)


def _beyond_pivot(mech: Mechanism, one: Hung) -> Placed:
    pivot = mech.link(one.of.link).points[one.of.outlets[0].point]
    return one.of.link, one.mass, pivot + (one.w / one.mass if one.mass else 0.0)
