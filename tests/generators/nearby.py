"""How well the exact values are conditioned: how far they move when the input moves by a hair."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from vecpoly.check.truth import exact_values, truth_of
from vecpoly.errors import VecpolyError
from vecpoly.mechanism.laws.sizes import Table
from vecpoly.mechanism.model import Mechanism
from vecpoly.problem.problem import Problem
from vecpoly.solution import Solution

HAIR = 1e-12  # rad, or m: a few units in the last place of a position
FACTOR = 100.0
LEAST = 1e-9


def slack(solution: Solution) -> dict[str, float]:
    """Key → how much drawing and oracle may differ because both are rounded before they are magnified."""
    problem = solution.problem
    if not isinstance(problem.subject, Mechanism):
        return _scattered(solution)
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


def _scattered(solution: Solution) -> dict[str, float]:
    """The same of a design: a hundred times what its data moved in their last places bring about."""
    near = truth_of(solution.problem).nearby
    return {
        key: FACTOR * max((abs(values[key] - one.exact) for values in near if key in values), default=0.0)
        for key, one in solution.answers.items()
    }


def natural(mech: Mechanism) -> dict[str, float]:
    """Unit → size of a quantity of this kind by the drive alone:
    what is far below it is rounding, and no smaller measure of error."""
    drive, size = mech.drive, mech.scale
    turning = abs(drive.rate) / (size if drive.slide else 1.0)
    bending = abs(drive.accel) / (size if drive.slide else 1.0) + turning**2
    return {"rad/s": turning, "rad/s^2": bending, "m/s": turning * size, "m/s^2": bending * size, "m": size}


def largest(solution: Solution, unit: str, floor: Mapping[str, float]) -> float:
    """What an error of an answer in this unit is measured against: the largest of them, its natural size at least."""
    alike = (one for one in solution.answers.values() if one.reading.unit == unit and not one.undefined)
    return max(floor.get(unit, 0.0), LEAST, *(abs(one.exact) for one in alike))


def over_a_period(problem: Problem) -> dict[str, float]:
    """Unit → what a moment that is the mean of others, and may be nothing, is small against: the greatest of them."""
    acting = problem.machine.loads if problem.machine is not None else problem.loads
    if acting is None or acting.constant is None:
        return {}
    sizes = [abs(one.size or 0.0) for one in acting.moments] + [
        abs(one.law.size.greatest) for one in acting.all if one.law is not None and isinstance(one.law.size, Table)
    ]
    scale = problem.mechanism.scale
    forces = [scale * abs(one.size or 0.0) for one in acting.forces]
    springs = [scale**2 * one.stiffness for one in acting.springs]  # of coils less, which is no harm
    return {"N·m": max([*sizes, *forces, *springs], default=0.0)}
