"""The flywheel tried out: the machine let go from its fastest place, and followed for a period by its true motion.

The flywheel comes from energies alone; here J_e α + ½ J_e′ ω² = M_e is integrated, and must give the same unevenness.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...foundation.slotted import replace
from ...mechanism.loads import Loads, Moment
from ...mechanism.model import Mechanism
from ..state import Reals
from .course import Course
from .forward import Moved, Mover
from .power import Flow, flow_with
from .run import follow
from .steady import Evenness

PLACES = 12  # of a turn, where the powers are told


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Confirmed:
    """A period of true motion. delta: (ω_max − ω_min) / ω_m of it. missed: ω at its end less that at its beginning,
    over ω_m. phi, omega: its states (rad, rad/s), φ on from the fastest place. flows: at even places φ (rad)."""

    delta: float
    missed: float
    phi: Reals
    omega: Reals
    flows: tuple[tuple[float, Flow], ...]

    @property
    def extremes(self) -> tuple[float, float]:
        """ω_max and ω_min by size (rad/s)."""
        return float(np.abs(self.omega).max()), float(np.abs(self.omega).min())


def confirmed(mech: Mechanism, loads: Loads, of: Course, speed: float, found: Evenness) -> Confirmed:
    """Follow the machine with this flywheel from its fastest place on. speed: ω_m (rad/s). Raises EquilibriumError."""
    mover = Mover(mech, with_constant(loads, of), found.flywheel)
    start, places = of.sense * found.fastest.psi, _places(of)
    ways = tuple(float(of.sense * (at - start) % of.period) or of.period for at in places)
    moved = follow(mover, start, of.sense * found.fastest.value, of.period, ways)
    (_, fast), (_, slow) = moved.extremes
    phi, omega = (_joined(moved, what) for what in ("phi", "omega"))
    return Confirmed(
        delta=(abs(fast) - abs(slow)) / speed,
        missed=(abs(float(omega[-1])) - abs(float(omega[0]))) / speed,
        phi=phi,
        omega=omega,
        flows=tuple(
            (at, _flow(mover, at, moved.passed[way][1]))
            for at, way in zip(places, ways, strict=True)
            if way in moved.passed
        ),
    )


def _places(of: Course) -> list[float]:
    """φ = 0°, 30° ... of the period (rad)."""
    count = round(PLACES * of.period / (2 * np.pi))
    return [of.period * k / count for k in range(count)]


def _flow(mover: Mover, phi: float, omega: float) -> Flow:
    state = (phi, omega, mover.acceleration(phi, omega))
    return flow_with(mover.mech, mover.loads, state, mover.flywheel)


def with_constant(loads: Loads, of: Course) -> Loads:
    """The loads with the moment that is constant over the period in its true size."""
    one = loads.constant
    if one is None:
        return loads
    moment = Moment(name=one.name, link=one.link, size=of.sense * of.constant)
    return replace(loads, constant=None, moments=(*loads.moments, moment))


def _joined(moved: Moved, what: str) -> Reals:
    return np.concatenate([getattr(leg, what) for leg in moved.legs])
