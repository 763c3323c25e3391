"""The Zhukovsky lever (速度多边形杠杆法):
all forces on the velocity polygon turned by 90°, their moments about the pole sum to zero.

The polygon is turned clockwise, so that the moment of a force about the pole is its power divided by μ_v. A couple M
becomes two opposite forces M / l, square to the line of two points of its link and applied at their tips.
"""

from __future__ import annotations

import numpy as np

from ....algebra.formula import sym
from ....algebra.quantity import Expr, Quantity, Sum, magnitude
from ....board.board import NO_LENGTH
from ....board.construction import Pane, View
from ....board.paper.marks import Dot, Role
from ....errors import EquilibriumError
from ....mechanism.asked.forces import balanced_by, load_named
from ....mechanism.loads import Force, Load, Moment
from ....names import At, Named
from ....plane import Reals, nominal, unit
from ....words import Words
from ...desk import POLE
from ...registry import Stage, method
from ..lines.letters import pair_symbol
from ..lines.pairs import Pair, pair_of
from ..readings import keep_nothing, keep_value
from ..senses import TURN
from ..state import Statics
from .lever_arms import Arm, Tips, draw_pair, force_arm, pair_arm, thrust_arm

_SOURCE = "机械原理, Zhukovsky's lever"


@method(
    stage=Stage.FORCE,
    group="lever",
    source=_SOURCE,
    example="slider-crank-dynamic",
    title=Words("速度多边形杠杆法求平衡力（矩）", "Balancing load by the Zhukovsky lever"),
)
def balancing_by_lever(st: Statics, load: Load | None) -> None:
    """Σ M_p = 0 about the pole of the turned velocity polygon gives the balancing load (N, or N·m), friction left out.

    Raises EquilibriumError where the balancing load has no arm,
    NoMethodError where a couple's link has one lettered point only.
    """
    load = load or st.unknown
    pane = st.board.open_pane(
        View.VELOCITY, "lever", Words("速度多边形杠杆", "Zhukovsky lever (rotated velocity polygon)"), aside=True
    )
    st.board.step(
        Words(
            "速度多边形杠杆法（不计摩擦）：将速度多边形绕极点 $p$ 顺时针转过 90°，各力平移至其作用点的速度影像点。",
            "Zhukovsky's lever (without friction): turn the velocity polygon by 90° clockwise "
            "about $p$; move every force to the velocity tip of its point.",
        ),
        pane,
    )
    tips: Tips = {}
    moments = [m for m in _given(st, pane, tips) if nominal(m.value)]
    _balance(st, pane, tips, load, moments)
    _draw_polygon(st, pane, tips)


def _given(st: Statics, pane: Pane, tips: Tips) -> list[Sum]:
    """Signed moments about the pole of all that is given."""
    found: list[Sum] = []
    for load in st.loads.all:
        if load.size is not None:
            known = st.size_of(load)
            found += _term(st, pane, tips, load, np.abs(known), int(np.sign(nominal(known))))
    for mass in st.loads.masses:
        for acting in st.inertia.get(mass.link, []):
            size = magnitude(acting.named.symbol, np.abs(acting.vector) * st.scale.value, "N")
            found += _moment(
                size, force_arm(st, pane, tips, At(mass.centre, mass.link), unit(acting.vector), acting.named)
            )
        couple = st.board.found.get(f"M_I{mass.link}", 0.0)
        if nominal(couple):
            inertia = Moment(name=f"M_I{mass.link}", link=mass.link)
            found += _term(st, pane, tips, inertia, np.abs(couple), int(np.sign(nominal(couple))))
    return found


def _term(st: Statics, pane: Pane, tips: Tips, load: Load, size: Reals, sense: int) -> list[Sum]:
    """The moment of a force, or of the pair of forces that stands for a couple."""
    named = load_named(load)
    if isinstance(load, Force) and load.against:
        return _moment(magnitude(named.symbol, size, "N"), thrust_arm(st, pane, tips, load, sense))
    if isinstance(load, Force):
        along = sense * st.along(load)
        return _moment(
            magnitude(named.symbol, size, "N"), force_arm(st, pane, tips, At(load.point, load.link), along, named)
        )
    pair = pair_of(st, load.link)
    if pair is None:
        return []
    _say_pair(st, pair, named)
    force = st.board.compute(
        pair_symbol(named.symbol), magnitude(named.symbol, size, "N·m") / st.desk.length(pair.p, pair.q), "N"
    )
    draw_pair(st, pane, tips, pair, sense, named)
    return _moment(force, pair_arm(st, tips, pair, sense))


def _say_pair(st: Statics, pair: Pair, named: Named) -> None:
    """A couple has no point of its own: two opposite forces at two points of its link stand for it."""
    symbol, bar = pair_symbol(named.symbol), st.desk.bar(pair.link, pair.p, pair.q)
    st.board.remark(
        Words(
            f"力偶矩 ${named.symbol}$ 化为作用于 ${pair.p}$、${pair.q}$ 两点、垂直于 ${bar}$ 的一对力 ${symbol}$。",
            f" The couple ${named.symbol}$ becomes a pair of forces ${symbol}$ at ${pair.p}$ "
            f"and ${pair.q}$, perpendicular to ${bar}$.",
        )
    )


def _moment(size: Quantity, arm: Arm) -> list[Sum]:
    return [Sum((size * arm.mm,), (arm.way,))] if arm.way else []


def _balance(st: Statics, pane: Pane, tips: Tips, load: Load, moments: list[Sum]) -> None:
    """The balancing force, or the pair of forces of the balancing moment, from Σ M_p = 0."""
    if isinstance(load, Moment):
        _balance_pair(st, pane, tips, load, moments)
        return
    named, plain = balanced_by("lever", st.loads), load_named(load)
    if load.against:
        arm = thrust_arm(st, pane, tips, load, 1)
    else:
        arm = force_arm(st, pane, tips, At(load.point, load.link), complex(np.exp(1j * load.direction)), plain)
    if not arm.way:
        raise _idle(load)
    _say_sum(st, Words.same(""))
    if not moments:
        keep_nothing(st, named)
        return
    _result(st, named, _against(moments, arm.way) / arm.mm)


def _balance_pair(st: Statics, pane: Pane, tips: Tips, load: Moment, moments: list[Sum]) -> None:
    """The pair is drawn as it turns, so that its size is positive and the moment has its sense."""
    named, plain, pair = balanced_by("lever", st.loads), load_named(load), pair_of(st, load.link)
    arm = pair_arm(st, tips, pair, 1) if pair is not None else None
    if pair is None or arm is None or not arm.way:
        raise _idle(load)
    _say_pair(st, pair, plain)
    if not moments:
        _say_sum(st, Words.same(""))
        keep_nothing(st, named)
        return
    sense = -1 if nominal(_against(moments, arm.way).value) < 0 else 1
    draw_pair(st, pane, tips, pair, sense, plain)
    number, symbol = st.mech.number(load.link), pair_symbol(plain.symbol)
    _say_sum(
        st,
        Words(
            f" ${symbol}$，其使构件 {number} {TURN[sense].zh}转动，故 ${named.symbol}$ 为{TURN[sense].zh}方向",
            f" ${symbol}$, which turns link {number} {TURN[sense].en}; so does ${named.symbol}$",
        ),
    )
    force = st.board.compute(symbol, _against(moments, sense * arm.way) / arm.mm, "N")
    _result(st, named, force * st.desk.length(pair.p, pair.q), sense)


def _against(moments: list[Sum], way: int) -> Sum:
    """What balances the moments about the pole, counted this way round."""
    return Sum(tuple(m.terms[0] for m in moments), tuple(-way * m.signs[0] for m in moments))


def _say_sum(st: Statics, found: Words) -> None:
    st.board.remark(
        Words(
            f"量各力对极点 $p$ 的力臂，由 $Σ M_p$ = 0（逆时针为正）得{found.zh}：",
            f" Measure the arms about $p$; $Σ M_p$ = 0 (counter-clockwise positive) gives{found.en}:",
        )
    )


def _idle(load: Load) -> EquilibriumError:
    return EquilibriumError(
        Words(
            f"平衡载荷 {load.name} 对速度多边形极点的力臂为零，在此位置不作功；请另取原动件位置或另选平衡载荷",
            f"the balancing load {load.name} has no arm about the pole of the velocity polygon: it does no "
            "work in this position; choose another input position or another balancing load",
        )
    )


def _result(st: Statics, named: Named, expr: Expr, sense: int = 1) -> None:
    """sense: how a moment turns, whose line has its size alone."""
    st.board.write_worked(sym(named.symbol), expr, named.unit)
    keep_value(st, named, sense * expr.value, expr)


def _draw_polygon(st: Statics, pane: Pane, tips: Tips) -> None:
    """The turned polygon: pole, rays, letters."""
    st.board.plot(pane, 0j, POLE[View.VELOCITY], Dot.POLE)
    for at, tip in tips.items():
        if abs(complex(nominal(tip))) > NO_LENGTH:
            st.board.arrow(pane, 0j, tip, Role.GIVEN)
            st.board.plot(pane, tip, st.desk.tip_label(View.VELOCITY, at))
