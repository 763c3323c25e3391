"""What is written in a problem file and changes nothing: branches and guesses without which the same assembly is found,
the acceleration of a drive where places and velocities alone are sought, loads that never act."""

from __future__ import annotations

import numpy as np

from .. import oracle
from ..errors import VecpolyError
from ..foundation.slotted import replace
from ..mechanism.model import Mechanism, Statement
from ..names import Kind, Rel
from ..problem.asked.asks import AskPoint
from ..problem.problem import Problem
from ..words import Words
from .never import never_acting


def idle(problem: Problem) -> tuple[Words, ...]:
    """A remark on each branch, load, and on guesses, that decide nothing: what is named may be left out together."""
    if not isinstance(problem.subject, Mechanism):
        return ()
    mech = least = problem.subject
    if mech.guesses and _same(mech, fewer := replace(mech, guesses={})):
        least = fewer
    for one in reversed(mech.branches):  # of two that say the same, the first is kept
        if _same(mech, fewer := replace(least, branches=tuple(other for other in least.branches if other is not one))):
            least = fewer
    told = [_said(one) for one in mech.branches if all(one is not kept for kept in least.branches)]
    rough = [_roughly(mech)] if mech.guesses and not least.guesses else []
    waiting = () if problem.loads is None else never_acting(mech, problem.loads)
    return (*told, *rough, *waiting, *([_ACCELERATED] if _is_accelerated_for_nothing(problem, mech) else []))


_ACCELERATED = Words(
    "input：所求只是位置和速度，原动件的加速度不起作用；这一项可以删去",
    "input: only places and velocities are sought, for which the acceleration of the drive decides nothing; it may be "
    "left out",
)


def _is_accelerated_for_nothing(problem: Problem, mech: Mechanism) -> bool:
    sought = [*problem.asks, *problem.printed]
    return (
        any(drive.accel for drive in mech.drives)
        and problem.loads is None
        and problem.machine is None
        and bool(problem.asks)
        and not any(isinstance(one, AskPoint) for one in sought)  # the place of a point with a given acceleration
        and all(isinstance(one.rel, Rel) and one.rel.kind in (Kind.P, Kind.V, Kind.OMEGA) for one in sought)
    )


def _roughly(mech: Mechanism) -> Words:
    points = ", ".join(mech.guesses)
    return Words(
        f"guesses：不用 {points} 的大致位置，机构的装配也是同样；这一项可以删去",
        f"guesses: without the rough places of {points} the mechanism is assembled just the same; they may be left out",
    )


def _said(statement: Statement) -> Words:
    return Words(
        f"branch：'{statement}' 不起决定作用，没有它装配也是同样；这一项可以删去",
        f"branch: '{statement}' decides nothing, for without it the assembly is just the same; it may be left out",
    )


def _same(one: Mechanism, other: Mechanism) -> bool:
    """Whether the other has one assembly too, and every link lies in it as in the first."""
    try:
        here, there = oracle.solve(one, order=0), oracle.solve(other, order=0)
    except VecpolyError:
        return False
    return all(
        np.allclose(here.origin(name), there.origin(name), atol=1e-9 * one.scale)
        and np.isclose(np.exp(1j * here.angle(name)), np.exp(1j * there.angle(name)))
        for name in here.bodies
    )
