"""Mechanical efficiency from the balancing load with and without friction: η = F_0 / F (driving) or M / M_0 (resisting)."""

from __future__ import annotations

import numpy as np

from ...errors import LockedError
from ...names import Named
from ...plane import Reals, nominal
from ...quantity import magnitude
from ...words import Words
from .readings import keep_value
from .state import Statics
from .virtual_power import powers

NOTHING = 1e-9  # of the balancing load with friction: a frictionless one below it is none
ETA = Named("eta", "η", "")


def read_efficiency(st: Statics) -> None:
    """Keep η; 1 without friction. With several loads: η = P_out / P_in of all of them.

    Raises LockedError where it is not in (0, 1].
    """
    if not st.rubbing or st.ideal is None:
        keep_value(st, ETA, 1.0, magnitude("η", 1.0, ""))
        return
    ideal, real = st.ideal.unknown_named, st.unknown_named
    zero, actual = magnitude(ideal.symbol, np.abs(st.ideal.balance), ideal.unit), magnitude(real.symbol, np.abs(st.balance), real.unit)
    if abs(float(nominal(st.ideal.balance))) <= NOTHING * abs(float(nominal(st.balance))):
        st.board.step(Words("此位置外力不作功（极限位置），平衡力全部用于克服摩擦，$η$ = 0。",
                            "No load does work in this position (a limit position): the balancing load only overcomes friction, $η$ = 0."))
        keep_value(st, ETA, 0.0, magnitude("η", 0.0, ""))
        return
    given = powers(st.ideal)
    into = sum((p for p in given.values() if nominal(p) > 0), 0.0)
    out = -sum((p for p in given.values() if nominal(p) < 0), 0.0)
    drives = float(nominal(out)) > float(nominal(into))  # the balancing load makes up what is missing
    mixed = min(float(nominal(into)), float(nominal(out))) > 1e-12 * max(float(nominal(into)), float(nominal(out)))
    st.board.step(Words("机械效率：", "Efficiency:"))
    if mixed:
        _of_powers(st, into, out, drives)
        return
    ratio = zero / actual if drives else actual / zero
    value = st.board.compute("η", ratio, "")
    _refuse(float(nominal(value.value)), st.unknown.name)
    keep_value(st, ETA, value.value, ratio)


def _of_powers(st: Statics, into: Reals, out: Reals, drives: bool) -> None:
    """η = P_out / P_in with the power of the balancing load on its side."""
    assert st.ideal is not None
    own = np.abs(out - into) * np.abs(st.balance) / np.abs(st.ideal.balance)
    p_in = magnitude("P_{in}", into + own if drives else into, "W")
    p_out = magnitude("P_{out}", out if drives else out + own, "W")
    st.board.remark(Words("将全部外力（含惯性力）的功率按正负分为输入与输出：", " sort the powers of all external and inertia forces into input and output:"))
    value = st.board.compute("η", p_out / p_in, "")
    _refuse(float(nominal(value.value)), st.unknown.name)
    keep_value(st, ETA, value.value, p_out / p_in)


def _refuse(eta: float, name: str) -> None:
    if not 0.0 < eta <= 1.0 + 1e-9:
        raise LockedError(f"the efficiency would be {eta:.4g}, outside (0, 1]: with this friction the mechanism is self-locking for {name}; lower f or ρ")
