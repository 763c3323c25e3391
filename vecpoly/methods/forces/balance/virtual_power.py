"""The balancing load by virtual power: Σ F·v + Σ M ω = 0, velocities measured on the drawn velocity polygon;
no reaction appears."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ....algebra.formula import sym
from ....algebra.quantity import Quantity, Sum, magnitude
from ....board.construction import View
from ....mechanism.asked.forces import balanced_by
from ....mechanism.loads import Load, Moment
from ....names import Named
from ....plane import Reals, nominal
from ....words import Words
from ...registry import Stage, method
from ..lines.letters import power_symbol
from ..readings import keep_nothing, keep_value
from ..senses import told_by_powers
from ..state import Statics
from .power_terms import Rate, Work, draw_rate, idle, rate_of, works

_SOURCE = "机械原理, principle of virtual power: the powers of all given forces, inertia included, sum to zero"


@method(
    stage=Stage.FORCE,
    group="virtual power",
    source=_SOURCE,
    example="slider-crank-dynamic",
    title=Words("用虚功率求平衡力（矩）", "Balancing load by virtual power"),
)
def balancing_by_power(st: Statics, load: Load | None) -> None:
    """M_1 = −Σ P / ω_1 (N·m), or F_b = −Σ P / v_b (N), friction left out; `load` is the balancing one.

    Raises EquilibriumError where the balancing load does no work in this position.
    """
    load = load or st.unknown
    named = balanced_by("power", st.loads)
    st.board.step(
        Words(
            "由虚功率原理：不计摩擦时，全部外力与惯性力的功率之和 $Σ$ $F v$ + $Σ$ $M ω$ = 0；"
            "各力作用点的速度沿力方向的分量由速度多边形量得：自 $p$ 作力的方向线，量至速度矢端在其上的垂足。"
            "$M$ 与 $ω$ 同向时功率为正。",
            "By virtual power: without friction the powers of all loads and inertia forces sum "
            "to zero, $Σ$ $F v$ + $Σ$ $M ω$ = 0; each velocity is the component along the "
            "force: project the tip of the velocity on the line of the force through $p$, and measure from $p$. "
            "The power of $M$ is positive if $M$ has the sense of $ω$.",
        ),
        View.VELOCITY,
    )
    parts = [written_power(st, work) for work in works(st)]
    rate = rate_of(st, load)
    if not rate.way:
        raise idle(load)
    draw_rate(st, rate)
    moving = [part for part in parts if nominal(part.value)]
    value = -total_of(parts) / (rate.sign * rate.expr.value)
    if not moving:
        keep_nothing(st, named, value)
        return
    way = _told(st, load, named, rate, value) if isinstance(load, Moment) else rate.way
    expr = Sum(tuple(moving), (-way,) * len(moving)) / rate.expr
    st.board.write_worked(sym(named.symbol), expr, named.unit)
    keep_value(st, named, value, expr)


def _told(st: Statics, load: Moment, named: Named, rate: Rate, value: Reals) -> int:
    """How the moment turns, told: its line has its size alone. +1 where it turns with ω, whose power it then adds."""
    sense, turns = int(np.sign(nominal(value))), f"ω_{st.mech.number(load.link)}"
    driving = sense == rate.way
    if not sense:  # the powers cancel out
        return rate.way
    powers = Words("各已知功率", "The known powers")
    st.board.remark(told_by_powers(powers, not driving, (named.symbol, turns), sense, along=driving))
    return 1 if driving else -1


def total_of(powers: Sequence[Quantity]) -> Reals:
    """Σ P (W) by every hand: also of what works by other hands than this."""
    return sum((power.value for power in powers), np.zeros(()))


def written_power(st: Statics, work: Work) -> Quantity:
    """P = ± F v in the step; zero where its point does not move along it."""
    named = Named(f"P_{work.named.key}", power_symbol(work.named.symbol), "W")
    quantity = magnitude(named.symbol, work.value, "W")
    draw_rate(st, work.rate)
    way = int(nominal(work.sign))
    if way:
        st.board.write_worked(quantity.node, Sum((work.expr,), (way,)), "W")
    else:
        what = "moment" if work.named.unit == "N·m" else "force"
        st.board.remark(Words(f" ${work.named.symbol}$ 不作功。", f" The {what} ${work.named.symbol}$ does no work."))
    return quantity
