"""What loads ask of the mechanism as it stands and moves, answered by the solved motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....errors import EquilibriumError
from ....mechanism.laws.acting import couple, is_beyond, place_in, size_of, tension
from ....mechanism.laws.sizes import Table
from ....mechanism.laws.springs import Coil, Spring
from ....mechanism.laws.told import STILL, beyond, no_direction
from ....mechanism.loads import Load, Loads
from ....mechanism.model import FRAME, Mechanism
from ....words import Words
from ...run import wrapped
from ...state import Bodies, Body, Points, Reals, at_rest, dot
from .drives import unit_drive
from .strokes import stroke

ROUNDING = 1e-9  # of the mechanism's scale of rates: below it nothing moves
RANGE = 12  # positions that are a range: fewer are one position with its neighbours


@dataclass(frozen=True, slots=True, eq=False)
class Stands:
    """The mechanism at the positions q of its drive (rad, or m), with the motion of its links there.

    rounding: of the mechanism's scale of rates, what counts as rest; 0 where a change of sense is sought to the last
    digit: the point may well move the other way meanwhile, and there a load does work.
    """

    mech: Mechanism
    bodies: Bodies
    q: Reals
    rounding: float = ROUNDING

    def drive(self) -> Reals:
        """The drive's own coordinate."""
        return self.q

    def travelled(self, link: str, point: str, direction: float) -> tuple[Reals, float]:
        """How far the point is from where its stroke along the direction begins, and how long the stroke is (m)."""
        low, high = stroke(unit_drive(self.mech), link, point, direction)
        return self._along(self._place(link, point), direction) - low, high - low

    def speed(self, link: str, point: str, direction: float) -> Reals:
        """v · u (m/s), 0 where it is only rounding."""
        return self._quiet(self._along(self._velocity(link, point), direction), self._pace)

    def spin(self, link: str) -> Reals:
        """ω (rad/s), 0 where it is only rounding."""
        return self._quiet(self._body(link).omega, self._pace / self.mech.scale)

    def length(self, spring: Spring) -> Reals:
        """The distance of the ends (m)."""
        return np.abs(self.ray(spring))

    def lengthening(self, spring: Spring) -> Reals:
        """dl/dt = (v - v') · u (m/s)."""
        ray = self.ray(spring)
        gap = self._velocity(spring.link, spring.point) - self._velocity(spring.against, spring.foot)
        with np.errstate(invalid="ignore", divide="ignore"):  # ends at one place have no direction: NaN
            return dot(ray / np.abs(ray), gap)

    def turned(self, coil: Coil) -> Reals:
        """φ - φ_0 within half a turn (rad)."""
        relative = self._body(coil.link).unit * np.conj(self._body(coil.against).unit)
        return wrapped(np.angle(relative) - coil.free)

    def turning(self, coil: Coil) -> Reals:
        """ω - ω' (rad/s)."""
        return self._body(coil.link).omega - self._body(coil.against).omega

    def ray(self, spring: Spring) -> Points:
        """From the spring's foot to its point (m)."""
        return self._place(spring.link, spring.point) - self._place(spring.against, spring.foot)

    def ends(self, spring: Spring) -> tuple[Points, Points]:
        """Where the spring's foot and its point are (m)."""
        return self._place(spring.against, spring.foot), self._place(spring.link, spring.point)

    @property
    def _pace(self) -> float:
        drive = self.mech.drive
        return abs(drive.rate) * (1.0 if drive.slide else self.mech.scale)

    def _quiet(self, rate: Reals, pace: float) -> Reals:
        return np.where(np.abs(rate) <= self.rounding * pace, 0.0, rate)

    def _along(self, vector: Points, direction: float) -> Reals:
        return np.asarray(np.real(vector * complex(np.exp(-1j * direction))), np.float64)

    def _body(self, link: str) -> Body:
        return at_rest() if link == FRAME else self.bodies[link]

    def _place(self, link: str, point: str) -> Points:
        return self._body(link).point(self.mech.link(link).points[point])

    def _velocity(self, link: str, point: str) -> Points:
        return self._body(link).velocity_of(self.mech.link(link).points[point])


def size_here(load: Load, at: Stands) -> Reals:
    """The size of a known load at every position (N, N·m); EquilibriumError where its table says nothing of one."""
    if load.law is None:
        assert load.size is not None
        return np.full(1, load.size)
    table = load.law.size
    if isinstance(table, Table) and (lost := np.broadcast_to(is_beyond(load, at), at.q.shape)).any():
        place = np.broadcast_to(place_in(table, at), at.q.shape)
        raise EquilibriumError(beyond(load, table, float(place[lost][0]), at.mech), code="out-of-range")
    return np.asarray(size_of(load, at), np.float64) + np.zeros(1)


def pull_here(spring: Spring, at: Stands) -> Reals:
    """T of a spring at every position (N)."""
    return np.asarray(tension(spring, at), np.float64) + np.zeros(1)


def couple_here(coil: Coil, at: Stands) -> Reals:
    """M of a torsion spring on its link at every position (N·m)."""
    return np.asarray(couple(coil, at), np.float64) + np.zeros(1)


def refuse_still(mech: Mechanism, loads: Loads) -> None:
    """EquilibriumError where a load depends on the motion, and the drive stands still."""
    named = [load.name for load in loads.all if load.law is not None and load.law.needs_motion]
    if named and mech.drive.rate == 0.0:
        raise EquilibriumError(
            Words(
                f"载荷 {named[0]} 由运动决定，而原动件静止（速度为 0）；请给出原动件的速度",
                f"load {named[0]} depends on the motion, and the drive stands still (its rate is 0); give it a rate",
            ),
            code="contradiction",
        )


def refuse_met(spring: Spring, at: Stands) -> None:
    """EquilibriumError where the ends of a spring meet in one of a few positions; in a range that is NaN."""
    if np.size(at.q) < RANGE and (at.length(spring) <= STILL * at.mech.scale).any():
        raise EquilibriumError(no_direction(spring), code="no-direction", numbers={"spring": spring.name})
