"""The moment that is constant over a period: the same position drawn at twelve places, and the rectangle of equal area.

It stands with the machine because the diagram of moments does; no mass and no mean speed need be known.
"""

from __future__ import annotations

from ...algebra.columns import column
from ...board.construction import Listing
from ...errors import NoMethodError
from ...problem.asked.asks import AskNamed
from ...problem.problem import Problem
from ...words import Words
from ..desk import Desk
from .french import french
from .period import Period, period_of, shown
from .scales import sizes_of
from .torque import draw_moments, rows_of

SECTION = Words("一个周期内的常力矩", "The moment that is constant over the period")


def draw_constant(desk: Desk, problem: Problem) -> None:
    """M_d from ∮ M_e dφ, where it is asked and no steady motion of a machine gives it. Raises NoMethodError."""
    loads = problem.loads
    constant = loads.constant if loads is not None else None
    if loads is None or constant is None:
        return
    named = next((ask.rel for ask in problem.asks if isinstance(ask, AskNamed) and ask.rel.key == constant.name), None)
    if named is None or (problem.machine is not None and problem.machine.steady is not None):
        return
    if loads.friction:
        raise _rubs(constant.name)
    curve = french(desk.mech, loads)
    period = period_of(desk, None, curve, loads)
    heights = [shown(height) for _, height in rows_of(period, -1.0 if curve.mean > 0 else 1.0)]
    sizes = sizes_of(curve, problem.scales, (min(heights), max(abs(curve.mean), *heights)), 0.0)
    desk.board.section(SECTION)
    _say_positions(period)
    draw_moments(period, sizes, named)


def _say_positions(period: Period) -> None:
    """M_e of the given loads at twelve places, as a table."""
    board, count = period.board, len(period.read) - 1
    board.step(
        Words(
            f"取原动件的 {count} 个等分位置，在各位置作速度多边形，由功率求得各已知力（矩）的等效力矩 $M_e$（逆时针"
            "为正），列成表。",
            f"In {count} equal positions of the driving link draw the velocity polygon; the powers give the equivalent "
            "moment $M_e$ of the given loads (counter-clockwise positive), which the table lists.",
        )
        + period.beginning
    )
    step = period.curve.period / count
    angles = column([period.degrees(step * k) for k in range(count)])
    moments = column([shown(one.moment) for one in period.read[:-1]])
    rows = tuple(zip(angles, moments, strict=True))
    board.tabulate(Listing(head=(Words.same("$φ$ /°"), Words.same("$M_e$ /(N·m)")), rows=rows))


def _rubs(name: str) -> NoMethodError:
    return NoMethodError(
        Words(
            f"{name} 是一个周期内的常数，而有摩擦：图解法只对无摩擦的机构画力矩线图；请在此位置求 M_b，或去掉摩擦，"
            "或用 vecpoly exact、vecpoly cycle",
            f"{name} is constant over the period and there is friction, and diagrams of moments are drawn without "
            "friction only; ask for M_b here, leave out the friction, or take 'vecpoly exact' or 'vecpoly cycle'",
        ),
        code="over-a-period",
    )
