"""Mechanical efficiency from the balancing load with and without friction: η = F_0 / F (driving) or M / M_0 (resisting)."""

from __future__ import annotations

import numpy as np

from ...errors import LockedError
from ...names import Named
from ...plane import Reals, nominal
from ...quantity import Quotient, magnitude
from ...words import Words
from .power_terms import rate_of
from .readings import keep_value
from .state import Statics
from .virtual_power import powers

NOTHING = 1e-9  # of the balancing load with friction: a frictionless one below it is none
ETA = Named("eta", "η", "")


def read_efficiency(st: Statics) -> None:
    """Keep η; 1 without friction. With several loads: η = P_out / P_in of all of them.

    Raises LockedError where it is not in (0, 1].
    """
    if st.ideal is None:
        keep_value(st, ETA, 1.0, magnitude("η", 1.0, ""))
        return
    given = powers(st.ideal)
    into = sum((p for p in given.values() if nominal(p) > 0), 0.0)
    out = -sum((p for p in given.values() if nominal(p) < 0), 0.0)
    if min(float(nominal(into)), float(nominal(out))) > NOTHING * max(float(nominal(into)), float(nominal(out))):
        _of_powers(st, into, out)
    elif abs(float(nominal(st.ideal.balance))) <= NOTHING * abs(float(nominal(st.balance))):
        st.board.step(Words("此位置外力不作功（极限位置），平衡力全部用于克服摩擦，$η$ = 0。",
                            "No load does work in this position (a limit position): the balancing load only overcomes friction, $η$ = 0."))
        keep_value(st, ETA, 0.0, magnitude("η", 0.0, ""))
    else:
        _of_loads(st, st.ideal, drives=float(nominal(out)) > float(nominal(into)))


def _of_loads(st: Statics, without: Statics, *, drives: bool) -> None:
    """η = F_0 / F where the balancing load drives, M / M_0 where it resists: the only other load has the same power in both."""
    ideal, real = without.unknown_named, st.unknown_named
    zero, actual = magnitude(ideal.symbol, np.abs(without.balance), ideal.unit), magnitude(real.symbol, np.abs(st.balance), real.unit)
    kind, kind_en = ("力矩", "moment") if real.unit == "N·m" else ("力", "force")
    st.board.step(Words(f"机械效率：克服同样的阻力，不计摩擦所需的驱动{kind}与实际所需的驱动{kind}之比。", f"Efficiency: against the same resistance, the driving {kind_en} without friction over the real one.")
                  if drives else
                  Words(f"机械效率：在同样的驱动下，实际能克服的阻{kind}与不计摩擦时的阻{kind}之比。", f"Efficiency: under the same drive, the resisting {kind_en} that is overcome over the one without friction."))
    _keep(st, zero / actual if drives else actual / zero)


def _of_powers(st: Statics, into: Reals, out: Reals) -> None:
    """η = P_out / P_in with the power of the balancing load on the side where it is."""
    rate = rate_of(st, st.unknown)
    own = st.balance * rate.sign * rate.expr.value
    p_in = magnitude("P_{in}", into + np.maximum(own, 0.0), "W")
    p_out = magnitude("P_{out}", out - np.minimum(own, 0.0), "W")
    st.board.step(Words("机械效率：将全部外力（含惯性力）的功率按正负分为输入与输出。", "Efficiency: the powers of all loads and inertia forces, sorted by sign into input and output."))
    _keep(st, p_out / p_in)


def _keep(st: Statics, ratio: Quotient) -> None:
    """Refused where it is not in (0, 1]."""
    value = st.board.compute("η", ratio, "")
    _refuse(float(nominal(value.value)), st.unknown.name)
    keep_value(st, ETA, value.value, ratio)


def _refuse(eta: float, name: str) -> None:
    if not 0.0 < eta <= 1.0 + 1e-9:
        raise LockedError(Words(
            f"效率将为 {eta:.4g}，不在 (0, 1] 内：在此摩擦下机构对 {name} 自锁；请减小 f 或 ρ",
            f"the efficiency would be {eta:.4g}, outside (0, 1]: with this friction the mechanism is self-locking for {name}; lower f or ρ"))
