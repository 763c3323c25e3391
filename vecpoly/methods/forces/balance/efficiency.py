"""Mechanical efficiency from the balancing load with and without friction:
η = F_0 / F (driving) or M / M_0 (resisting)."""

from __future__ import annotations

from math import nan

import numpy as np

from ....algebra.quantity import Quotient, magnitude
from ....board.construction import Reading
from ....board.hand import EXACT
from ....errors import LockedError
from ....mechanism.loads import Force, Moment
from ....names import Named
from ....plane import Reals, nominal
from ....words import Words
from ..readings import keep_value
from ..state import Statics
from .power_terms import powers, rate_of

NOTHING = 1e-9  # of the balancing load with friction: a frictionless one below it is none
ETA = Named("eta", "η", "")


def read_efficiency(st: Statics) -> None:
    """Keep η; 1 without friction. With several loads: η = P_out / P_in of all of them.
    Where nothing does work it is 0/0, undefined.

    Raises LockedError where it is not in [0, 1].
    """
    given = powers(st.without_friction)
    into = sum((p for p in given.values() if nominal(p) > 0), 0.0)
    out = -sum((p for p in given.values() if nominal(p) < 0), 0.0)
    idle = max(float(nominal(into)), float(nominal(out))) <= NOTHING * largest(st) * st.speed
    if idle and _vanishes(st, st.balance):
        _undefined(st)
    elif st.ideal is None:
        keep_value(st, ETA, 1.0, magnitude("η", 1.0, ""))
    elif _turned(st, st.ideal) or min(float(nominal(into)), float(nominal(out))) > NOTHING * max(
        float(nominal(into)), float(nominal(out))
    ):
        _of_powers(st, into, out)
    elif _vanishes(st, st.ideal.balance):
        st.board.step(
            Words(
                "此位置外力不作功（极限位置），平衡力全部用于克服摩擦，$η$ = 0。",
                "No load does work in this position (a limit position): the balancing load "
                "only overcomes friction, $η$ = 0.",
            )
        )
        keep_value(st, ETA, 0.0, magnitude("η", 0.0, ""))
    else:
        _of_loads(st, st.ideal, drives=float(nominal(out)) > float(nominal(into)))


def largest(st: Statics) -> float:
    """The largest of the forces that act from outside, couples over the mechanism's size (N)."""
    found = [
        abs(load.size) / (1.0 if isinstance(load, Force) else st.mech.scale)
        for load in st.loads.all
        if load.size is not None
    ]
    found += [float(abs(nominal(force.vector))) * st.scale.value for forces in st.inertia.values() for force in forces]
    return max(found, default=0.0)


def _turned(st: Statics, ideal: Statics) -> bool:
    """Whether friction turned the balancing load round:
    inertia forces drive, and without friction it would have braked them."""
    return float(nominal(ideal.balance)) * float(nominal(st.balance)) < 0 and not _vanishes(st, ideal.balance)


def _vanishes(st: Statics, balance: Reals) -> bool:
    """Whether a balancing load is nothing but rounding beside the other loads."""
    arm = st.mech.scale if isinstance(st.unknown, Moment) else 1.0
    return abs(float(nominal(balance))) <= NOTHING * largest(st) * arm


def _undefined(st: Statics) -> None:
    """η = 0/0."""
    why = Words(
        "此位置各外力均不作功，$η$ = 0/0，无意义", "no load does work in this position, so $η$ = 0/0 is undefined"
    )
    if st.ideal is not None:
        st.board.step(Words(f"{why.zh}。", f"{why.en[0].upper()}{why.en[1:]}."))
    st.keep(Reading(key=ETA.key, symbol=ETA.symbol, unit=ETA.unit, scalar=nan, remark=why), nan)


def _of_loads(st: Statics, without: Statics, *, drives: bool) -> None:
    """η = F_0 / F where the balancing load drives, M / M_0 where it resists:
    the only other load has the same power in both."""
    ideal, real = without.unknown_named, st.unknown_named
    zero, actual = (
        magnitude(ideal.symbol, np.abs(without.balance), ideal.unit),
        magnitude(real.symbol, np.abs(st.balance), real.unit),
    )
    kind, kind_en = ("力矩", "moment") if real.unit == "N·m" else ("力", "force")
    st.board.step(
        Words(
            f"机械效率：阻力（矩）相同时，理想驱动{kind}与实际驱动{kind}之比。",
            f"The efficiency is the ratio of the ideal driving {kind_en} to the actual one, with the same resisting "
            "load.",
        )
        if drives
        else Words(
            f"机械效率：驱动力（矩）相同时，实际阻{kind}与理想阻{kind}之比。",
            f"The efficiency is the ratio of the actual resisting {kind_en} to the ideal one, with the same driving "
            "load.",
        )
    )
    _keep(st, zero / actual if drives else actual / zero)


def _of_powers(st: Statics, into: Reals, out: Reals) -> None:
    """η = P_out / P_in with the power of the balancing load on the side where it is."""
    rate = rate_of(st, st.unknown)
    own = st.balance * rate.sign * rate.expr.value
    p_in = magnitude("P_{in}", into + np.maximum(own, 0.0), "W")
    p_out = magnitude("P_{out}", out - np.minimum(own, 0.0), "W")
    st.board.step(
        Words(
            "机械效率：将全部外力（含惯性力）的功率按正负分为输入与输出。",
            "Efficiency: the powers of all loads and inertia forces, sorted by sign into input and output.",
        )
    )
    _keep(st, p_out / p_in)


def _keep(st: Statics, ratio: Quotient) -> None:
    """Refused where it is not in [0, 1] by a hand that reads exactly; another may read a little more than 1."""
    value = st.board.compute("η", ratio, "")
    eta = float(nominal(value.value))
    if st.board.hand.nominal == EXACT:
        _refuse(eta, st.unknown.name)
    elif eta > 1.0:
        st.board.remark(
            Words(
                f"读得 $η$ = {eta:.4g} 略大于 1，系作图误差：摩擦损失小于读数误差。",
                f" The efficiency read, $η$ = {eta:.4g}, is above 1 by the error of drawing: friction takes less than "
                "can be read.",
            )
        )
    keep_value(st, ETA, value.value, ratio)


def _refuse(eta: float, name: str) -> None:
    if not 0.0 <= eta <= 1.0 + 1e-9:
        raise LockedError(
            Words(
                f"效率将为 {eta:.4g}，不在 [0, 1] 内：在此摩擦下机构对 {name} 自锁；请减小 f 或 ρ",
                f"the efficiency would be {eta:.4g}, outside [0, 1]: with this friction the mechanism is "
                f"self-locking for {name}; lower f or ρ",
            )
        )
