"""An eccentric clamp with F removed: it locks where the line of R_21 passes within ρ of A; the largest e that holds."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Quantity, number
from ....board.construction import Pane, Scale, View
from ....board.paper.marks import Dot, Role
from ....devices.eccentric_clamp import ARM, E_LIMIT, SELF_LOCKING, EccentricClamp
from ....foundation.slotted import replace
from ....plane import Line, Points, foot, nominal, unit
from ....words import Words
from ..bench import Bench
from ..equilibrium import signed
from ..inclined import leaned
from ..sketches.eccentric_clamp import Clamp, draw_released

TALL = 85.0  # mm: radius of the disc in the figure about its pin


def judge_released(bench: Bench, device: EccentricClamp, clamp: Clamp) -> None:
    """F removed: the sliding would be reversed; the disc rests where the line of R_21 then passes within ρ of A."""
    board, turn = bench.board, device.turn
    board.section(Words("自锁条件（去掉 $F$）", "Self-locking: $F$ removed"))
    title = Words("去掉 $F$ 后 $R′_{21}$ 的作用线", "Line of $R′_{21}$ with $F$ removed")
    place = board.open_pane(View.MECHANISM, "released", title, _finer(bench, clamp))
    large = _enlarged(clamp, board.scale_of(View.MECHANISM).value / board.scale_of(place).value)
    _reasoned(bench, place)
    back = board.turn(leaned(1j, complex(-turn), clamp.phi))
    line, opening = Line(large.k, back), 1j * back * turn
    near = foot(line, 0j)
    draw_released(bench, place, large, back, near)
    _judged(bench, device, signed(bench, ARM, place, (0j, near), opening, "A C"))
    if device.limited:
        _limit(bench, large, line, opening, place)


def _enlarged(clamp: Clamp, times: float) -> Clamp:
    """The same clamp on a figure of another scale."""
    o, k, h = (at * times for at in (clamp.o, clamp.k, clamp.h))
    return replace(clamp, o=o, k=k, h=h, rho=clamp.rho * times, mm_r=clamp.mm_r * times)


def _reasoned(bench: Bench, place: Pane) -> None:
    """Why the disc rests: without F two forces act on it, in one line."""
    bench.board.step(
        Words(
            "去掉 $F$ 后圆盘有反转松开的趋势，$K$ 点的摩擦力反向，$R′_{21}$ 偏到法线 $n$ 的另一侧。"
            "此时圆盘只受 $R′_{21}$ 和销轴的反力 $R′_{31}$，二力须共线，而 $R′_{31}$ 的作用线离 $A$ 不能远于 $ρ$。"
            "故 $R′_{21}$ 与摩擦圆相割或相切（或从使机构夹紧的一侧通过）时，无论 $R′_{21}$ 多大圆盘都不会松开，"
            "机构自锁。由 $A$ 向 $R′_{21}$ 作垂线 $AC$，量得力臂 $h$（使机构松开者为正），与 $ρ$ 比较。",
            "With $F$ removed the disc tends to turn back: friction at $K$ is reversed and "
            "$R′_{21}$ is turned to the other side of the normal $n$. Only $R′_{21}$ and the "
            "reaction $R′_{31}$ of the pin act on the disc; they must be collinear, and $R′_{31}$ "
            "passes $A$ at $ρ$ at most. So where $R′_{21}$ cuts or touches the friction circle "
            "(or passes on the closing side) the disc does not turn back however large $R′_{21}$ "
            "is: it is self-locking. Drop the perpendicular $AC$ from $A$ and compare the arm $h$ "
            "(positive where it opens the clamp) with $ρ$.",
        ),
        place,
    )


def _judged(bench: Bench, device: EccentricClamp, arm: Quantity) -> None:
    """Self-locking where h ≤ ρ."""
    locks = np.asarray(arm.value) <= device.radius * (1 + 1e-9)
    sign, zh, en = (
        ("≤", "$R′_{21}$ 穿过摩擦圆，机构自锁", "$R′_{21}$ cuts the friction circle and the clamp is self-locking")
        if bool(nominal(locks))
        else (
            ">",
            "$R′_{21}$ 在摩擦圆之外，机构不自锁",
            "$R′_{21}$ passes outside the friction circle and the clamp is not self-locking",
        )
    )
    text = f"$h {sign} ρ$ = {number(1e3 * device.radius)} mm"  # the number of h stands in its line
    if float(nominal(arm.value)) < 0:
        bench.board.remark(
            Words(
                "$h$ 为负，$R′_{21}$ 之矩使机构夹紧。",
                " The arm $h$ is negative: the moment of $R′_{21}$ closes the clamp.",
            )
        )
    bench.judged(SELF_LOCKING, locks, Words(f"因 {text}，故 {zh}。", f" Since {text}, {en}."), arm.value)


def _finer(bench: Bench, clamp: Clamp) -> Scale:
    """The scale of the figure about A: as many times finer as the paper allows."""
    coarse = bench.board.scale_of(View.MECHANISM)
    times = next((k for k in (5, 4, 2.5, 2) if float(nominal(clamp.mm_r)) * k <= TALL), 1)
    return Scale(symbol="μ_l′", value=coarse.value / times, unit="m")


def _limit(bench: Bench, clamp: Clamp, line: Line, opening: Points, place: Pane) -> None:
    """The largest e that holds: R_21 touches the friction circle, and O keeps its distance from it."""
    board = bench.board
    board.step(
        Words(
            "求自锁的最大偏心距：只改变 $e$ 时，$O$ 沿直线 $AO$ 移动，$K$ 随 $O$ 平移，$R′_{21}$ 方向不变，"
            "$O$ 到 $R′_{21}$ 的距离 $R sin φ$ 也不变。极限时 $R′_{21}$ 切于摩擦圆：作平行于 $R′_{21}$ 的切线，"
            "再在 $O$ 的一侧作与它相距 $R sin φ$ 的平行线，交 $AO$ 的延长线于 $O′$，$AO′$ 即 $e_{max}$。",
            "The largest eccentricity that holds: when only $e$ changes, $O$ moves along $AO$ and "
            "$K$ with it; $R′_{21}$ keeps its direction and its distance $R sin φ$ from $O$. In "
            "the limit $R′_{21}$ touches the friction circle: draw the tangent parallel to "
            "$R′_{21}$, and on the side of $O$ the parallel at the distance $R sin φ$ from it; it "
            "meets the line $AO$ at $O′$, and $AO′$ is $e_{max}$.",
        ),
        place,
    )
    touch = opening * clamp.rho
    beside = touch + clamp.o - foot(line, clamp.o)
    largest = board.meet(Line(beside, line.along), Line(0j, unit(clamp.o)), Words("R_21 与 AO", "R_21 and AO"))
    board.join(place, touch - 12 * line.along, touch + 12 * line.along, Role.HIDDEN)
    board.join(place, beside, largest + unit(largest - beside) * 5, Role.HIDDEN)
    board.join(place, 0j, largest, Role.CONSTRUCTION)
    board.plot(place, largest, "O′")
    near = foot(line, clamp.o)
    board.join(place, clamp.o, near, Role.CONSTRUCTION)
    board.plot(place, (clamp.o + near) / 2, "R sin φ", Dot.NONE)
    bench.measured(E_LIMIT, place, 0j, largest, "A O′")
