"""How a mechanism is solved, planned once for it: every group's assembly is chosen at its own position."""

from __future__ import annotations

from functools import lru_cache, partial

import numpy as np

from ..errors import AssemblyError
from ..foundation.same import Same
from ..foundation.slotted import replace
from ..mechanism.gearing import misfit
from ..mechanism.groups.assur import decompose
from ..mechanism.groups.mobility import check
from ..mechanism.model import Mechanism, Rolling
from .assembly.branches import check_letters, choose, confirm
from .assembly.changes import Changes, touches
from .assembly.feasible import SEARCHED
from .closed.dyads import Hinged, Swinging
from .drive import driver
from .plan import Plan, quiet
from .steps import Step, is_followed, step_for

KEPT = 128  # plans of mechanisms met last: those of a whole turn of the player, which comes back to each


def build(mech: Mechanism) -> Plan:
    """Check mobility and letters, take the mechanism apart, choose every assembly at the own position.

    Raises MobilityError, UnknownNameError, AssemblyError.
    """
    check(mech)
    check_letters(mech)
    _check_gears(mech)
    raw = tuple(step_for(mech, group) for group in decompose(mech))
    empty = Plan(
        mech, tuple(driver(mech, drive) for drive in mech.drives if not drive.between), (), any(map(is_followed, raw))
    )
    chosen: list[Step] = []
    with quiet():
        run, bodies = empty.start(np.array([mech.drive.position]), strict=True)
        for step in raw:
            partial = replace(empty, steps=tuple(chosen))
            partial.placed(step, bodies, run)
            chosen.append(choose(mech, step, bodies, run))
            bodies |= chosen[-1].place(bodies, run)
        confirm(mech, bodies, run)
    return replace(empty, steps=tuple(chosen))


def through(plan: Plan) -> Plan:
    """The plan with the change points of every dyad, at which its assembly passes to the other side.

    They come again with every turn of the drive; behind a dyad that has an odd number of them, with every second turn.
    """
    drive, scale = plan.mech.drive, plan.mech.scale
    if drive.between:  # a cylinder's stroke, on which no link turns round
        return plan
    low, span = (
        (drive.position - SEARCHED * scale, 2 * SEARCHED * scale) if drive.slide else (drive.position, 2 * np.pi)
    )
    steps: list[Step] = []
    for step in plan.steps:
        if is_followed(step):
            break
        if isinstance(step, Hinged | Swinging) and step.two:
            before = replace(plan, steps=tuple(steps), followed=False)  # these know of their own change points
            places = touches(partial(before.fold, step), low, low + span, scale if drive.slide else 1.0)
            if places:
                step = replace(step, changes=Changes(drive.position, places, None if drive.slide else span))
                span *= 1 if drive.slide or len(places) % 2 == 0 else 2
        steps.append(step)
    return replace(plan, steps=(*steps, *plan.steps[len(steps) :]))


def _check_gears(mech: Mechanism) -> None:
    """AssemblyError where links hold gears at a distance that their radii do not fit."""
    for joint in mech.joints:
        if isinstance(joint, Rolling) and (why := misfit(mech, joint)) is not None:
            raise AssemblyError(why, code="gears-do-not-fit")


@lru_cache(maxsize=KEPT)
def _kept(key: Same[Mechanism]) -> Plan:
    return build(key.it)


@lru_cache(maxsize=KEPT)
def _whole(key: Same[Mechanism]) -> Plan:
    return through(_kept(key))


def plan_for(mech: Mechanism, own: bool = False) -> Plan:
    """The plan of the mechanism, built once for every mechanism object. own: for its own position alone."""
    here = _kept(Same(mech))
    return here if own and not here.is_tight else _whole(Same(mech))
