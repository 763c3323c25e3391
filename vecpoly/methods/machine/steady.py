"""The steady motion of a machine: twelve positions, the diagram of moments, the energy, the flywheel."""

from __future__ import annotations

import numpy as np

from ...errors import EquilibriumError, NoMethodError
from ...mechanism.asked.machine import DELTA, constant_of
from ...mechanism.laws.rated import refuse_rated
from ...mechanism.machine import Machine, Steady
from ...problem.problem import Problem
from ...words import Words
from ..desk import Desk
from .energy import draw_energy
from .french import French, french
from .period import period_of, shown
from .positions import draw_positions
from .scales import sizes_of
from .torque import draw_moments, draw_surplus, rows_of
from .wittenbauer import contacts_of, draw_loop, keep_areas, reach_of

POSITIONS = Words("等效量随转角的变化", "The equivalent model over a period")
WORK = Words("盈亏功", "Surplus and deficit of work")
LOOP = Words("能量–质量图与飞轮", "Energy over inertia, and the flywheel")
LITTLE = 1e-7  # of the work done and taken: what is left over beyond it is left


def draw_steady(desk: Desk, problem: Problem, machine: Machine, run: Steady) -> None:
    """Draw what the questions need. Raises EquilibriumError, NoMethodError."""
    asked = {ask.rel.key for ask in problem.asks}
    if run.delta is None:
        raise _no_iteration()
    if DELTA.key in asked:
        raise _given(run.delta)
    refuse_rated(machine.loads)
    curve = french(desk.mech, machine.loads)
    _refuse_change(curve, machine)
    period = period_of(desk, run, curve, machine.loads)
    named = next(iter(constant_of(machine)), None)
    heights = [shown(height) for _, height in rows_of(period, -1.0 if curve.mean > 0 else 1.0)]
    top, low = (curve.highest(0.0, curve.mean, sign) for sign in (1.0, -1.0))
    swing = curve.work(top, curve.mean) - curve.work(low, curve.mean)
    looped = bool(asked & {"J_F", "phi_max", "phi_min", "omega_max", "omega_min"})
    contacts = contacts_of(period)
    reach = reach_of(period, contacts) if looped else 0.0
    sizes = sizes_of(
        curve, problem.scales, (min(heights), max(abs(curve.mean), *heights)), swing, speed=run.speed, reach=reach
    )
    board = desk.board
    board.section(POSITIONS)
    draw_positions(period, sizes)
    board.section(WORK)
    moments = draw_moments(period, sizes, named)
    surplus = draw_surplus(period, sizes, moments)
    keep_areas(period, surplus)
    if looped:
        board.section(LOOP)
        constant = 0.0 if named is None else curve.sense * board.found[named.key]
        energies = draw_energy(period, sizes, (contacts[0].psi, contacts[1].psi), constant)
        draw_loop(period, sizes, energies, contacts)


def _refuse_change(curve: French, machine: Machine) -> None:
    """EquilibriumError where the loads do work over a period, and nothing is there to balance it."""
    left = curve.work(curve.period, curve.mean)
    moved = float(np.diff(curve.cuts) @ np.abs(curve.moments[:, 0]))
    if machine.loads.constant is None and abs(left) > LITTLE * moved:
        raise EquilibriumError(
            Words(
                f"一个周期内各力（矩）所作的功之和为 {left:.6g} J，不为零，机器不能稳定运转；请改正载荷，或写一个 "
                "size: constant 的力矩",
                f"the loads do {left:.6g} J of work over a period, not 0: the machine cannot run steadily; correct the "
                "loads, or write a moment of size: constant",
            ),
            code="work-left",
            numbers={"work": left},
        )


def _no_iteration() -> NoMethodError:
    return NoMethodError(
        Words(
            f"由已有的飞轮求 {DELTA.key} 没有图解法（切线的斜率与所求的速度有关）；请给出 delta 求 "
            "J_F，或用 vecpoly exact",
            f"no graphical method on file finds {DELTA.key} from a flywheel that is there (the slopes of the tangents "
            "depend on the speeds sought); give delta and ask J_F, or use 'vecpoly exact'",
        ),
        code="no-method",
    )


def _given(delta: float) -> NoMethodError:
    return NoMethodError(
        Words(
            f"题目已给出 {DELTA.key} = {delta:g}，图解法由它求 J_F；机器实际的不均匀系数请用 vecpoly exact 求",
            f"{DELTA.key} = {delta:g} is given, and the drawing finds J_F from it; how uneven the machine is then "
            "tells 'vecpoly exact'",
        ),
        code="no-method",
    )
