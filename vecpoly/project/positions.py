"""The positions of a mechanism that are drawn: the given one, those beside it, each with the loads that act there."""

from __future__ import annotations

from dataclasses import dataclass
from math import degrees

from ..cycle.pose import posed
from ..errors import FaultError
from ..foundation.slotted import replace
from ..problem.problem import Problem, Scales
from ..solution import Solution, scales_of, solve
from ..words import Words
from .working import Working, without


@dataclass(frozen=True, slots=True, kw_only=True)
class Position:
    """The drive's position (rad, or m), and the drawing there; acts: whether the load of one stroke does."""

    phi: float
    solution: Solution
    acts: bool = True


def position(solution: Solution, phi: float, working: Working, by: str, seed: int) -> Position:
    """The mechanism drawn at another position, to the same μ_l. Raises FaultError where it cannot stand there."""
    there = next(posed(solution.problem, phi))
    if there is None:
        slide = solution.problem.mechanism.drive.slide
        where = f"{1e3 * phi:g} mm" if slide else f"{degrees(solution.problem.mechanism.drive.told(phi)):g}°"
        raise FaultError(
            Words(
                f"机构不能装配在 {where} 处，或无法由已知装配方式到达；请另选位置",
                f"the mechanism cannot be assembled at {where}, or not reached from where it stands; choose another",
            ),
            code="no-assembly",
        )
    acts = working.at(phi)
    loads = there.loads if acts or working.force is None or there.loads is None else without(there.loads, working.force)
    scale = scales_of(solution.construction).given.get("mu_l")
    posed_there = replace(
        there, loads=loads and loads.without_roles(), printed=(), scales=Scales({"mu_l": scale} if scale else {})
    )
    return Position(phi=phi, solution=solve(posed_there, by=by, seed=seed, repeats=0), acts=acts)


def refuse_idle(problem: Problem, working: Working) -> None:
    """Raise FaultError where the load of one stroke does not act at the given position."""
    phi = problem.mechanism.drive.position
    if working.force is None or working.at(phi):
        return
    told = working.loaded.drive.told
    at = "、".join(f"{told(a):.1f}°～{told(b):.1f}°" for a, b in working.stretches)
    name, here = working.force.name, told(phi) % 360
    raise FaultError(
        Words(
            f"载荷 {name} 在题设位置 {here:g}° 不作用（只作用于 {at}）；请把 phi 取在该范围内",
            f"load {name} does not act at the given position, {here:g}°, but at "
            f"{at.replace('、', ', ').replace('～', ' to ')}: choose phi there",
        ),
        code="contradiction",
    )
