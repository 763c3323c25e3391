"""How well the exact values are conditioned: how far they move when the input moves by a hair."""

from __future__ import annotations

from dataclasses import replace

from vecpoly.check.truth import exact_values
from vecpoly.errors import VecpolyError
from vecpoly.mechanism.model import Mechanism
from vecpoly.solution import Solution

HAIR = 1e-12  # rad, or m: a few units in the last place of a position
FACTOR = 100.0


def slack(solution: Solution) -> dict[str, float]:
    """Key → how much drawing and oracle may differ because both are rounded before they are magnified."""
    problem = solution.problem
    if not isinstance(problem.subject, Mechanism):
        return {}
    drive = problem.subject.drive
    starts = tuple(replace(start, value=start.value + HAIR) for start in problem.subject.starts)
    moved = replace(
        problem.subject,
        starts=starts,
        drives=(replace(drive, position=drive.position + HAIR), *problem.subject.drives[1:]),
    )
    try:
        near = exact_values(replace(problem, subject=moved))
    except VecpolyError:
        return {}
    return {
        key: FACTOR * abs(near[key] - (one.exact if one.exact_vector is None else one.exact_vector))
        for key, one in solution.answers.items()
        if key in near
    }


def natural(mech: Mechanism) -> dict[str, float]:
    """Unit → size of a quantity of this kind by the drive alone:
    what is far below it is rounding, and no smaller measure of error."""
    drive, size = mech.drive, mech.scale
    turning = abs(drive.rate) / (size if drive.slide else 1.0)
    bending = abs(drive.accel) / (size if drive.slide else 1.0) + turning**2
    return {"rad/s": turning, "rad/s^2": bending, "m/s": turning * size, "m/s^2": bending * size, "m": size}
