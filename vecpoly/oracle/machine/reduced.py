"""The equivalent link, from exact velocities: T = ½ J_e ω² and P = M_e ω, at all positions of the drive at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ...foundation.slotted import replace
from ...mechanism.asked.machine import Equivalent
from ...mechanism.loads import Loads, Mass
from ...mechanism.model import FRAME, Mechanism, Prismatic
from .. import solve
from ..forces.acting import given
from ..motion import Motion
from ..state import Body, Points, Reals, dot

ROUNDING = 1e-14  # of the powers that the forces could have: none at all
NOTHING = 1e-9  # of the greatest v / ω_1, or ω_i / ω_1, that the mechanism can have at all: rounding


@dataclass(frozen=True, eq=False, kw_only=True)
class Reduced:
    """A mechanism with loads at the positions `at` of its drive, which moves evenly; every answer has one element a
    position.

    energy: J_e of the drive, twice the kinetic energy over ω_1² (kg·m², or kg). rate: dJ_e/dφ (kg·m², or kg/m), from
    the accelerations. power: M_e of the drive, the powers of all loads over ω_1 (N·m, or N).
    """

    mech: Mechanism
    loads: Loads
    motion: Motion
    at: Reals

    @property
    def pace(self) -> float:
        """ω_1 (rad/s), or v_1 (m/s)."""
        return self.motion.mech.drive.rate

    @property
    def energy(self) -> Reals:
        """Σ m v_S² + Σ J ω², over ω_1²."""
        return self._sum([self._energy(mass) for mass in self.loads.masses]) / self.pace**2

    @property
    def rate(self) -> Reals:
        """2 Σ m v_S · a_S + 2 Σ J ω α, over ω_1³."""
        return self._sum([self._rate(mass) for mass in self.loads.masses]) / self.pace**3

    @property
    def power(self) -> Reals:
        """Σ F · v + Σ M ω, over ω_1; of springs and weights too."""
        acting = given(self.motion.mech, replace(self.loads, inertia=False), self.motion.bodies, self.at)
        powers = [one.power(self.motion.bodies) for one in acting]
        whole, largest = self._sum(powers), self._sum([np.abs(power) for power in powers])
        pace = abs(self.pace) * (1.0 if self.mech.drive.slide else self.mech.scale)
        forces = sum((np.abs(one.force) + np.abs(one.couple) / self.mech.scale for one in acting), np.zeros(1))
        return np.where(np.abs(whole) <= ROUNDING * (largest + forces * pace), 0.0, whole) / self.pace

    def inertia(self, to: Equivalent) -> Reals:
        """J_e = Σ m (v_S / ω)² + Σ J (ω_i / ω)² of a link; m_e with v in the place of ω; NaN where that rests."""
        return self._over(self.energy, self.speed(to) ** 2)

    def load(self, to: Equivalent) -> Reals:
        """M_e = Σ F · v / ω + Σ M ω_i / ω of a link; F_e with |v|, positive along the motion; NaN where that rests."""
        speed = self.speed(to)
        return self._over(self.power, np.abs(speed) * np.sign(self.pace) if to.slide else speed)

    def speed(self, to: Equivalent) -> Reals:
        """ω of the link, or v of the slider along its guide, over the rate of the drive; 0 where nothing is left but
        rounding."""
        body = self.motion.moving(to.link)
        found = (along(self.mech, to.link, body) if to.slide else body.omega) / self.pace
        size = 1.0 if to.slide == self.mech.drive.slide else self.mech.scale if to.slide else 1 / self.mech.scale
        return self._sum([np.where(np.abs(found) <= NOTHING * size, 0.0, found)])

    def _energy(self, mass: Mass) -> Reals:
        body, velocity = self.motion.bodies[mass.link], self._velocity(mass)
        return mass.mass * dot(velocity, velocity) + mass.inertia * body.omega**2

    def _rate(self, mass: Mass) -> Reals:
        body, local = self.motion.bodies[mass.link], self._centre(mass)
        pull = dot(self._velocity(mass), body.acceleration_of(local))
        return 2 * (mass.mass * pull + mass.inertia * body.omega * body.alpha)

    def _velocity(self, mass: Mass) -> Points:
        return self.motion.bodies[mass.link].velocity_of(self._centre(mass))

    def _centre(self, mass: Mass) -> complex:
        return self.mech.link(mass.link).points[mass.centre]

    def _sum(self, parts: list[Reals]) -> Reals:
        total: Reals = sum(parts, np.zeros(self.motion.shape or (1,)))
        return total

    @staticmethod
    def _over(whole: Reals, part: Reals) -> Reals:
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(part == 0, np.nan, whole / part)


def along(mech: Mechanism, link: str, body: Body) -> Reals:
    """The velocity of a slider on the frame, positive along its guide."""
    sliding = (joint for joint in mech.joints if isinstance(joint, Prismatic))
    joint = next(one for one in sliding if {link, FRAME} == {one.block, one.guide})  # it may guide a block of its own
    guide = 1.0 if joint.block == link else body.unit
    axis = np.asarray(guide * np.full(1, np.exp(1j * joint.direction)), np.complex128)
    return dot(axis, body.velocity)


def reduce(mech: Mechanism, loads: Loads, position: ArrayLike | None = None, *, strict: bool = True) -> Reduced:
    """The machine at one or many positions of its drive (rad, or m); None is the mechanism's own.

    strict: as for `solve`. Raises AssemblyError, DeadPointError.
    """
    even = replace(mech, drives=(replace(mech.drive, rate=mech.drive.rate or 1.0, accel=0.0), *mech.drives[1:]))
    at = np.atleast_1d(np.asarray(mech.drive.position if position is None else position, np.float64))
    return Reduced(mech=mech, loads=loads, motion=solve(even, position, strict=strict), at=at)
