"""The printed direction of a vector against the exact one."""

from __future__ import annotations

import cmath
from collections.abc import Callable
from dataclasses import replace
from math import degrees, pi, radians

from .. import oracle
from ..devices.base import Device
from ..mechanism.loads import Loads
from ..names import Named, Rel
from ..oracle.forces import forces
from ..problem.problem import Printed, Problem
from ..words import Words
from .verdict import Checked, Verdict

CALCULATED, GRAPHICAL = radians(0.5), radians(3.0)  # how far a direction may be off


def with_directions(problem: Problem, checked: list[Checked]) -> list[Checked]:
    """The verdicts, wrong where the printed direction is another than the exact one."""
    if isinstance(problem.subject, Device) or all(one.printed.direction is None for one in checked):
        return checked
    way = _ways(problem)
    return [_weighed(one, way(one.printed)) for one in checked]


def _ways(problem: Problem) -> Callable[[Printed], complex | None]:
    """The exact vector behind a printed answer; None where there is none."""
    motion = oracle.solve(problem.mechanism)

    def vector(printed: Printed) -> complex | None:
        match printed.rel:
            case Rel() as rel if rel.kind.is_vector:
                return complex(motion.value(rel))
            case Named() as named if named.is_vector and problem.loads:
                return complex(forces(problem.mechanism, problem.loads or Loads()).value(named.key))
        return None

    return vector


def _weighed(one: Checked, exact: complex | None) -> Checked:
    if one.printed.direction is None or not exact:
        return one
    off = cmath.phase(cmath.rect(1.0, one.printed.direction) / exact)
    if abs(off) <= (GRAPHICAL if one.printed.kind == "graphical" else CALCULATED):
        return one
    here, there = (f"{degrees(angle) % 360:.4g}°" for angle in (one.printed.direction, cmath.phase(exact)))
    turned = Words("，恰好相反", ", just the opposite") if abs(abs(off) - pi) < GRAPHICAL else Words.same("")
    said = Words(f"方向应为 {there}，原书为 {here}", f"its direction is {there}, not {here}") + turned
    return replace(one, verdict=Verdict.WRONG, slip=said if one.slip is None else one.slip + Words("；", "; ") + said)
