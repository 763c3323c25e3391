"""The problem at other positions of its drive, drawn to the given scale, its loads free to drive or to resist."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TypeVar

from ....board.construction import Construction, View
from ....board.hand import hand
from ....cycle.pose import posed
from ....errors import AssemblyError, LockedError
from ....figures.mu import LENGTH
from ....findings.study.study import Study
from ....foundation.slotted import replace
from ....mechanism.asked.curvature import centrode_lengths
from ....mechanism.asked.machine import machine_quantities, reduced_quantities
from ....problem.problem import Problem, Scales
from ....solution import Answer, Solution, read_off, solve
from ....words import Words

Found = TypeVar("Found")


def at_position(study: Study, phi: float, *, same_scale: bool = True) -> Problem:
    """The problem with its drive at phi (rad, or m), the diagram to the given position's scale or to its own. Raises
    AssemblyError where no statement tells the assembly."""
    there = next(posed(study.problem, phi))
    if there is None:
        raise AssemblyError(
            Words("没有与给定位置连通的装配方式", "there is no assembly here that hangs together with the given one")
        )
    figure = study.solution.construction.figure(View.MECHANISM)
    return replace(
        there,
        loads=there.loads and there.loads.without_roles(),
        asks=tuple(ask for ask in there.asks if ask.rel.key not in _of_period(there) | _of_range(there)),
        curvature=there.curvature and replace(there.curvature, centrodes=None),
        printed=(),
        scales=Scales({LENGTH.key: figure.scale.value} if figure and same_scale else {}),
    )


def _of_period(problem: Problem) -> set[str]:
    """What is the same wherever the drive stands: the flywheel, the constant moment, the greatest surplus."""
    mech, machine = problem.mechanism, problem.machine
    return set() if machine is None else {*machine_quantities(mech, machine)} - {*reduced_quantities(mech)}


def _of_range(problem: Problem) -> set[str]:
    """The lengths of the centrodes, which are drawn over a range about the given position, and there alone."""
    asked = problem.curvature.centrodes if problem.curvature else None
    return set() if asked is None else {named.key for named in centrode_lengths(problem.mechanism, asked.link)}


def draw_there(there: Problem, by: str) -> Solution:
    """What is drawn there; where the other loads alone cannot move the mechanism, the balancing one drives too."""
    return _or_driven(lambda problem: solve(problem, by=by, repeats=0), there)


def read_there(there: Problem, by: str) -> tuple[Mapping[str, Answer], Construction]:
    """The same as it is read off, and the drawing, of which nothing is written out."""
    return _or_driven(lambda problem: read_off(problem, hand(by, repeats=0)), there)


def _or_driven(drawn: Callable[[Problem], Found], there: Problem) -> Found:
    try:
        return drawn(there)
    except LockedError:
        if there.loads is None:
            raise
        return drawn(replace(there, loads=there.loads.driven()))
