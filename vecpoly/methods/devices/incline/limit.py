"""The limit of self-locking of a block on an inclined plane: the slope on which its reaction leans by just φ."""

from __future__ import annotations

import numpy as np

from ....algebra.formula import sym
from ....algebra.quantity import Quantity, number
from ....board.construction import View
from ....devices.incline import LIMIT, REACTION
from ....plane import nominal
from ....words import Words
from ..bench import Bench
from ..inclined import cone, gauged, haul, row_of
from .sketch import PLANE, on_plane


def limit_slope(bench: Bench, phi: Quantity) -> None:
    """The slope on which the reaction against the weight alone leans by just φ:
    normal and plane set out from the vertical."""
    board = bench.board
    board.section(Words("自锁条件（去掉 $F$）", "Self-locking: $F$ removed"))
    place = board.open_pane(View.BODY, "limit", Words("自锁极限", "Limit of self-locking"))
    normal = 1j * np.exp(1j * np.radians(phi.value))
    along = board.turn(-1j * normal)
    board.step(
        Words(
            "去掉 $F$ 后滑块只受 $Q$ 和总反力 $R_21$，静止时二力共线，$R_21$ 竖直向上，与法线 $n$ 的夹角等于 $α$；"
            "而此夹角不能大于 $φ$。故 $α ≤ φ$，即 $Q$ 的作用线落在以 $n$ 为轴、顶角为 $2φ$ 的摩擦锥内时，"
            "无论 $Q$ 多大滑块都不会下滑，即自锁。作极限位置：自竖直线量 $φ$ 得法线 $n$，作其垂线为斜面，量其倾角：",
            "Without $F$ only $Q$ and the total reaction $R_21$ act on the block. At rest they "
            "are collinear: $R_21$ is vertical and makes the angle $α$ with the normal $n$, and "
            "this angle cannot exceed $φ$. So where $α ≤ φ$, that is, where the line of $Q$ lies "
            "within the friction cone of $2φ$ about $n$, the block does not slide down however "
            "large $Q$ is: it is self-locking. The limit: set off $φ$ from the vertical to get "
            "$n$, draw the plane perpendicular to it and read its slope:",
        ),
        place,
    )
    middle = on_plane(bench, place, along, LIMIT.symbol)
    foot = (
        middle.real
        + 1j * (along * PLANE * 0.62).imag
        + 1j * (middle - along * PLANE * 0.62).real * np.tan(np.angle(along))
    )
    haul(bench, place, middle, -1j, "Q", 26.0)
    haul(bench, place, foot, 1j, REACTION.symbol, 30.0)
    cone(bench, place, foot, normal, phi.value, 38.0, "n")
    slope = gauged(bench, 1 + 0j, along)
    bench.stated(LIMIT, slope, row_of(sym(LIMIT.symbol), f" = $φ$ = {number(float(nominal(slope)))}°"))
