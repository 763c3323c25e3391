"""The shaking force of a linkage on its frame, over the turn of its drive, without and with counterweights."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...mechanism.counterweights import Counterweights
from ...mechanism.model import Mechanism
from .. import solve
from ..forces.laws.drives import drive_range
from ..motion import Motion
from ..state import Points, Reals
from .balance import Hung

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
    whole = drive_range(mech)[2]
    at = np.linspace(0, 2 * np.pi, STATIONS, endpoint=False) if whole else np.atleast_1d(mech.drive.position)
    motion = solve(mech, at)
    force = np.zeros(at.shape, np.complex128)
    moment = np.zeros(at.shape, np.complex128)
    for mass in asked.loads.masses:
        add = _weighed(motion, mass.link, mass.mass, mech.link(mass.link).points[mass.centre])
        force, moment = force - add[1], moment + add[0]
    for one in hung:
        local = mech.link(one.of.link).points[one.of.outlets[0].point]
        place = local + (one.w / one.mass if one.mass else 0.0)
        add = _weighed(motion, one.of.link, one.mass, place)
        force, moment = force - add[1], moment + add[0]
    total = asked.own + sum(one.mass for one in hung)
    return Shaking(at=at, force=force, centre=moment / total)


def _weighed(motion: Motion, link: str, mass: float, local: complex) -> tuple[Points, Points]:
    """m r and m a of a point of a link."""
    body = motion.moving(link, 2)
    return mass * body.point(local), mass * body.acceleration_of(local)
