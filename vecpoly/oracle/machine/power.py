"""Power flow at an instant of the true motion: what every load gives, and at what rate every link gains energy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...foundation.slotted import replace
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from .. import solve
from ..forces.acting import given
from ..state import dot
from .forward import Mover


@dataclass(frozen=True, slots=True, kw_only=True)
class Flow:
    """Powers of loads, springs and weights by name, dT/dt by link (W); their sums are equal."""

    powers: dict[str, float]
    gains: dict[str, float]


def power_flow(mech: Mechanism, loads: Loads, phi: float, omega: float, flywheel: float = 0.0) -> Flow:
    """Σ (F · v + M ω) = Σ (m v · a + J ω α) with the acceleration that the drive has (rad, rad/s, kg·m²)."""
    return flow_with(mech, loads, (phi, omega, Mover(mech, loads, flywheel).acceleration(phi, omega)), flywheel)


def flow_with(mech: Mechanism, loads: Loads, state: tuple[float, float, float], flywheel: float = 0.0) -> Flow:
    """The same where φ, ω, α of the drive are known (rad, rad/s, rad/s²)."""
    phi, omega, accel = state
    moving = replace(mech, drives=(replace(mech.drive, rate=omega, accel=accel), *mech.drives[1:]))
    bodies = solve(moving, np.array([phi])).bodies
    powers = {
        one.name: float(one.power(bodies)[0])
        for one in given(moving, replace(loads, inertia=False), bodies, np.array([phi]))
    }
    gains = {mech.drive.link: flywheel * omega * accel} if flywheel else {}
    for mass in loads.masses:
        body, local = bodies[mass.link], mech.link(mass.link).points[mass.centre]
        along = dot(body.velocity_of(local), body.acceleration_of(local))
        own = mass.mass * along + mass.inertia * body.omega * body.alpha
        gains[mass.link] = gains.get(mass.link, 0.0) + float(own[0])
    return Flow(powers=powers, gains=gains)
