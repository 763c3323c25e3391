"""Which kind of unbalance a rotor has: none, static, couple, quasi-static (and where on its axis), dynamic."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ....algebra.quantity import number
from ....devices.balancing.asked import DYNAMIC, STATIC
from ....devices.balancing.rotor import Rotor
from ....plane import cross, dot, nominal
from ....words import Words
from ..bench import Bench
from .polygon import Polygon

NONE = Words("转子已动平衡。", "The rotor is in dynamic balance.")
COUPLE = Words(
    "转子静平衡而不动平衡，为力偶不平衡：两平面内所需的质径积等值反向。",
    "The rotor is in static but not in dynamic balance: this is a couple unbalance. The mass-radius products that the "
    "two planes need are equal and opposite.",
)
BOTH = Words(
    "转子静、动都不平衡，且两平面内的矢量不共线，为动不平衡。",
    "The rotor is in neither static nor dynamic balance, and the vectors of the two planes are not parallel: this is a "
    "dynamic unbalance.",
)


def told_kind(bench: Bench, rotor: Rotor, whole: Polygon, polygons: Mapping[str, Polygon]) -> None:
    """Answer whether it is in static and in dynamic balance, and say which kind of unbalance it has."""
    board, least = bench.board, whole.least
    board.section(Words("不平衡的类型", "The kind of unbalance"))
    board.step(
        Words(
            f"封闭边不超过各质径积总长的 0.5 %（{number(least, 2)} mm）即视为多边形封闭。",
            f"A polygon counts as closed where its closing side is not longer than 0.5 % of all products, "
            f"{number(least, 2)} mm.",
        )
    )
    one, other = (polygon.tip for polygon in polygons.values())
    closed = np.maximum(least, board.hand.slacks)
    static = np.abs(whole.tip) <= closed
    dynamic = (np.abs(one) <= closed) & (np.abs(other) <= closed)
    yes, no = (
        Words("和为零，转子静平衡。", "The sum is zero: the rotor is in static balance."),
        Words("和不为零，转子静不平衡。", "The sum is not zero: the rotor is statically unbalanced."),
    )
    is_static, is_dynamic = bool(nominal(static)), bool(nominal(dynamic))
    bench.judged(STATIC, static, yes if is_static else no, whole.tip)
    kind = _kind(rotor, complex(nominal(one)), complex(nominal(other)), is_static, is_dynamic, least)
    bench.judged(DYNAMIC, dynamic, kind, one, other)


def _kind(rotor: Rotor, one: complex, other: complex, static: bool, dynamic: bool, least: float) -> Words:
    gap = Words("", " ")
    if dynamic:
        return gap + NONE
    if static:
        return gap + COUPLE
    if abs(float(cross(one, other))) > least * max(abs(one), abs(other)):
        return gap + BOTH
    first, second = rotor.correct.values()
    total = one + other
    share = float(dot(other, total)) / abs(total) ** 2
    at = 1e3 * (first.at + share * (second.at - first.at))
    return gap + Words(
        f"两平面内的矢量共线：准静不平衡，相当于 $z$ = {number(at)} mm 处的一个质径积"
        "（若质心正在此处，即为静不平衡），在该平面内用一个质量即可平衡。",
        f"The vectors of the two planes are parallel: a quasi-static unbalance, one product at $z$ = {number(at)} mm "
        "(a static one, if the centre of mass lies there); one weight in that plane balances it.",
    )
