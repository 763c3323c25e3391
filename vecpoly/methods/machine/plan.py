"""The stage of the machine: what acts is shown on the diagram, then every equivalent that is asked for is found."""

from __future__ import annotations

from collections.abc import Sequence

from ...board.construction import View
from ...errors import NoMethodError
from ...foundation.slotted import replace
from ...mechanism.asked.machine import STEADY, Equivalent, constant_of, equivalents
from ...mechanism.groups.assur import Group
from ...problem.problem import Problem
from ...words import Words
from ..desk import Desk
from ..forces.bodies.given_loads import draw_given_loads
from ..forces.laws.found import found_loads
from ..forces.masses import masses, weight_force, weights
from ..forces.state import Statics
from ..registry import Stage
from .doors import EQUIVALENTS
from .steady import draw_steady


def machine_pass(desk: Desk, problem: Problem, groups: Sequence[Group]) -> None:
    """Draw what is asked of the machine; the readings are on the board.

    Raises DeadPointError where the equivalent link stands still, NoMethodError for a motion from a state.
    """
    machine, asked = problem.machine, {ask.rel.key for ask in problem.asks}
    assert machine is not None
    if wanted := [to for to in equivalents(desk.mech) if asked & {to.inertia.key, to.load.key}]:
        _equivalents(desk, problem, wanted)
    run = machine.steady
    if run is not None and asked & {named.key for named in (*STEADY, *constant_of(machine))}:
        draw_steady(desk, problem, machine, run)
    if machine.started is not None:
        raise _exact_alone()


def _equivalents(desk: Desk, problem: Problem, wanted: Sequence[Equivalent]) -> None:
    """All of this position, one after the other."""
    assert problem.machine is not None
    here, pulls = found_loads(desk, replace(problem.machine.loads, inertia=False))
    st = Statics(desk=desk, loads=here, pulls=pulls)
    if problem.loads is None:
        _acting(st)
    else:
        weights(st)  # told with the forces
    for to in wanted:
        EQUIVALENTS.find(Stage.MACHINE, "slider" if to.slide else "turning link").draw(st, to)


def _acting(st: Statics) -> None:
    """Masses, loads and weights, as the forces of an equilibrium are shown."""
    masses(st)
    if st.loads.all:
        st.board.step(
            Words("在机构图上标出各已知力（矩）。", "Mark the given forces and moments on the diagram."), View.MECHANISM
        )
        draw_given_loads(st)
    if st.loads.weight:
        for mass in st.loads.masses:
            weight_force(st, mass)


def _exact_alone() -> NoMethodError:
    return NoMethodError(
        Words(
            "由初始状态求真实运动没有图解法；请用 vecpoly exact",
            "no graphical method on file follows a motion from a state; use 'vecpoly exact'",
        ),
        code="no-method",
    )
