"""A machine in steady motion: its work over a period, the flywheel by areas and exact, the flywheel tried out."""

from __future__ import annotations

from dataclasses import dataclass

from ...errors import EquilibriumError, VecpolyError
from ...foundation.slotted import replace
from ...mechanism.loads import Constant, Loads
from ...mechanism.machine import Steady, flywheel_of, known_of
from ...mechanism.model import Mechanism
from ...oracle.machine import (
    Confirmed,
    Course,
    Evenness,
    Flow,
    Tangents,
    Top,
    confirmed,
    course,
    evenness,
    surplus,
    tangents,
)
from ...problem.problem import Problem
from ...words import Words

__all__ = ["Confirmed", "Evenness", "Flow", "Running", "Tangents", "running"]
ASSUMED = "M_c"  # the moment that is thought where the problem has none of its own


@dataclass(frozen=True, eq=False, slots=True, kw_only=True)
class Running:
    """The machine over a period. high, low: where its energy is greatest and least. name: of the constant moment (""
    where none is needed), thought: whether the problem itself has none. steady: the speed and unevenness asked for;
    found, cuts, trial: the motion with the flywheel, Wittenbauer's tangents, the true motion."""

    mech: Mechanism
    of: Course
    high: Top
    low: Top
    name: str = ""
    thought: bool = False
    steady: Steady | None = None
    found: Evenness | None = None
    cuts: Tangents | None = None
    trial: Confirmed | None = None

    @property
    def surplus(self) -> float:
        """ΔW_max (J)."""
        return self.high.value - self.low.value

    @property
    def constant(self) -> float:
        """The constant moment (N·m), counter-clockwise positive."""
        return self.of.sense * self.of.constant

    @property
    def by_areas(self) -> float | None:
        """J_F = ΔW_max / (δ ω_m²) (kg·m²), as if J_e were constant; None without a δ."""
        run = self.steady
        return None if run is None or run.delta is None else flywheel_of(self.surplus, run.speed, run.delta)


def running(problem: Problem) -> Running | Words | None:
    """What is known of the machine's motion; why nothing is; None where there is neither mass nor load."""
    loads = problem.acting
    if loads is None:
        return None
    if (why := _missing(problem, loads)) is not None:
        return why
    try:
        return _running(problem, loads)
    except VecpolyError as error:
        return error.words


def _missing(problem: Problem, loads: Loads) -> Words | None:
    mech = problem.mechanism
    if not loads.masses:
        return Words("题目没有给出构件的质量", "no masses are given")
    if len(mech.drives) > 1 or mech.drive.between:
        return Words("机构不是由机架上的一个原动件驱动", "the mechanism is not driven by one link against the frame")
    if loads.friction:
        return Words("等效量按无摩擦计算，而题目有摩擦", "equivalents know no friction, of which this problem has some")
    known = known_of(loads)
    if not (known.all or known.springs or known.weight or loads.constant):
        return Words("除质量外没有已知载荷", "beside the masses there is no known load")
    return None


def _running(problem: Problem, loads: Loads) -> Running:
    """Raises VecpolyError where there is no steady period."""
    mech, known = problem.mechanism, known_of(loads)
    machine = problem.machine
    try:
        of, thought = course(mech, known), False
    except EquilibriumError as error:
        if error.code != "work-left":
            raise
        known, thought = replace(known, constant=Constant(name=ASSUMED, link=mech.drive.link)), True
        of = course(mech, known)
    top, low = surplus(of)
    plain = Running(
        mech=mech, of=of, high=top, low=low, name=known.constant.name if known.constant else "", thought=thought
    )
    run = machine.steady if machine is not None else None
    if run is None:
        return plain
    found = evenness(of, run)
    cuts = None if run.delta is None else tangents(of, run.speed, run.delta)
    return replace(plain, steady=run, found=found, cuts=cuts, trial=confirmed(mech, known, of, run.speed, found))
