"""How large the quantities of a mechanism are likely to be, whatever its position: from its data alone."""

from __future__ import annotations

from ..mechanism.loads import Loads
from ..problem.problem import Problem


def natural(problem: Problem) -> dict[str, float]:
    """Unit → size that the data make likely, whatever the position."""
    drive, long = problem.mechanism.drive, problem.mechanism.scale
    rate = abs(drive.rate) / (long if drive.slide else 1.0)
    accel = rate**2 + abs(drive.accel) / (long if drive.slide else 1.0)
    force = _largest_force(problem.loads, long) if problem.loads else 0.0
    return {
        "m": long,
        "m/s": rate * long,
        "m/s^2": accel * long,
        "rad/s": rate,
        "rad/s^2": accel,
        "N": force,
        "N·m": force * long,
    }


def _largest_force(loads: Loads, long: float) -> float:
    """The largest given force; a moment as the force that it makes with the mechanism's size as its arm (N)."""
    return max(
        (*(abs(one.size or 0.0) for one in loads.forces), *(abs(one.size or 0.0) / long for one in loads.moments)),
        default=0.0,
    )
