"""The minimum number of teeth as a whole number: how well it is read, and what is taken."""

from __future__ import annotations

from math import ceil, sin

import numpy as np

from ....algebra.quantity import number
from ....devices.gears.generation import UNDERCUT, Z_MIN, GearGeneration
from ....plane import Reals, nominal
from ....words import Words
from ..bench import Bench

TENTH = 0.1  # mm: what a rule is read to
SLIGHT = 0.1  # of a tooth: the undercut of so much is neglected, 17.1 → 17


def whole_teeth(gear: GearGeneration, read: Reals, depth: Reals) -> Words:
    """How far a tenth of a millimetre moves z_min, read from PQ (depth, mm on paper), and the whole number taken."""
    formula = 2 * gear.ha.si / sin(gear.alpha.si) ** 2
    taken, off, by = ceil(formula - SLIGHT), number(float(nominal(read * TENTH / depth)), 1), number(formula, 3)
    symbol = f"${Z_MIN.symbol}$"
    return Words(
        f"$PQ$ 的读数每差 0.1 mm，{symbol} 相差 {off}；按公式 2$h_a^{{*}}$/sin²$α$ 得 {by}，"
        f"取整数 {symbol} = {taken}。",
        f"Each 0.1 mm in the reading of $PQ$ changes {symbol} by {off}; "
        f"the formula 2$h_a^{{*}}$/sin²$α$ gives {by}, "
        f"and the whole number taken is {symbol} = {taken}.",
    )


def judge_undercut(bench: Bench, gear: GearGeneration, least: Reals) -> None:
    """Whether the teeth are undercut."""
    cut = gear.x < np.asarray(least)
    low = number(float(nominal(least)))
    said = (
        Words(
            f"$x$ = {number(gear.x)} < $x_min$，齿根被切去一部分，发生根切；变位系数应不小于 {low}。",
            f" since $x$ = {number(gear.x)} < $x_min$, the root is undercut; the shift should be at least {low}.",
        )
        if bool(nominal(cut))
        else Words(
            f"$x$ = {number(gear.x)} ≥ $x_min$，不根切。",
            f" since $x$ = {number(gear.x)} ≥ $x_min$, there is no undercut.",
        )
    )
    bench.board.remark(Words("检查根切：", " Check for undercut:"))
    bench.judged(UNDERCUT, cut, said, least)
