"""How large the quantities of a mechanism are likely to be, whatever its position: from its data alone."""

from __future__ import annotations

from ..mechanism.loads import GRAVITY, Loads
from ..problem.problem import Problem


def natural(problem: Problem) -> dict[str, float]:
    """Unit → size that the data make likely, whatever the position."""
    drive, long = problem.mechanism.drive, problem.mechanism.scale
    rate = abs(drive.rate) / (long if drive.slide else 1.0)
    accel = rate**2 + abs(drive.accel) / (long if drive.slide else 1.0)
    loads = problem.acting or Loads()
    force, mass = _largest_force(loads, long), sum(one.mass + one.inertia / long**2 for one in loads.masses)
    return {
        "m": long,
        "m/s": rate * long,
        "m/s^2": accel * long,
        "rad/s": rate,
        "rad/s^2": accel,
        "N": force,
        "N·m": force * long,
        "kg": mass,
        "kg·m^2": mass * long**2,
    }


def _largest_force(loads: Loads, long: float) -> float:
    """The largest given force or weight; a moment as the force that it makes with the mechanism's size as its arm (N).

    Equivalents vanish where all that is loaded rests: they are held against what loads and masses could do elsewhere.
    """
    return max(
        (
            *(abs(one.size or 0.0) for one in loads.forces),
            *(abs(one.size or 0.0) / long for one in loads.moments),
            *(GRAVITY * one.mass for one in loads.masses if loads.weight),
        ),
        default=0.0,
    )
