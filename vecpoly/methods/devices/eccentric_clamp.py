"""An eccentric clamp: three forces through one point, the pin's reaction tangent to its friction circle; self-locking as geometry."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...board.construction import LineOfAction, Pane, Scale, View
from ...board.marks import Role, Segment
from ...devices.eccentric_clamp import (
    ARM,
    E_LIMIT,
    ETA,
    FORCE,
    IDEAL,
    PHI,
    R21,
    R31,
    SELF_LOCKING,
    EccentricClamp,
)
from ...errors import DeadPointError, EquilibriumError, LockedError
from ...names import Named
from ...plane import Line, Points, Reals, foot, nominal, unit
from ...quantity import Of, Quantity, magnitude, number
from ...vector.close import Closed
from ...words import Words
from .bench import Bench
from .eccentric_clamp_sketch import Clamp, draw_released, free_body, sketch
from .inclined import (
    balance,
    friction_angle,
    given,
    leaned,
    letter,
    points_along,
    signed,
    sought,
)
from .registry import device_method

_SENSES = (Words("逆时针", "counter-clockwise"), Words("顺时针", "clockwise"))
TALL = 85.0  # mm: radius of the disc in the figure about its pin
_SOURCE = "机械原理, eccentric clamp: friction circle and friction angle"


@device_method(EccentricClamp, title=Words("偏心夹紧机构", "Eccentric clamp"), source=_SOURCE, example="5-3")
def draw_eccentric_clamp(bench: Bench, device: EccentricClamp) -> None:
    """F + R_21 + R_31 = 0 through one point; F removed: self-locking where R_21 passes within ρ of A."""
    board = bench.board
    clamp = sketch(bench, device)
    board.section(Words("夹紧时的受力", "Forces while the clamp closes"))
    size = _contact(bench, device, clamp)
    force = _closing(bench, device, clamp, size)
    ideal = _frictionless(bench, device, clamp)
    board.step(Words("夹紧时的效率为理想驱动力与实际驱动力之比：", "The efficiency of clamping is the ideal force over the actual one:"))
    bench.worked(ETA, ideal / force)
    _released(bench, device, clamp)


def _contact(bench: Bench, device: EccentricClamp, clamp: Clamp) -> float:
    """φ, and R_21 = Q / cos φ: its normal part clamps (N)."""
    board, closing = bench.board, device.turn > 0
    turning, side = _SENSES[not closing], (Words("右", "right") if closing else Words("左", "left"))
    board.step(Words(f"圆盘 1 {turning.zh}转动，在 $K$ 点相对工件 2 向{side.zh}滑动，故 $R_{{21}}$ 逆着滑动方向自法线偏 $φ$，其法向分力为 $Q$：",
                     f"Disc 1 turns {turning.en} and slides at $K$ to the {side.en} on the work 2: $R_{{21}}$ leans by $φ$ from the normal against the sliding; its normal part is $Q$:"))
    phi = friction_angle(bench, PHI, device.f)
    clamp.phi = float(nominal(phi.value))
    return float(nominal(board.compute("R_{21}", magnitude("Q", device.Q.si, "N") / Of("cos", phi), "N").value))


def _closing(bench: Bench, device: EccentricClamp, clamp: Clamp, size: float) -> Quantity:
    """F + R_21 + R_31 = 0 with friction: F and R_31 measured."""
    board, turn = bench.board, device.turn
    apart = board.open_pane(View.BODY, "disc", Words("圆盘 1 的受力", "Forces on disc 1"))
    plan = board.open_pane(View.FORCE, "disc", Words("圆盘 1 的力多边形", "Force polygon of disc 1"))
    turning, against = _SENSES if turn > 0 else _SENSES[::-1]
    board.step(Words(f"三力必汇交于 $F$ 与 $R_{{21}}$ 两作用线的交点 $X$。$R_{{31}}$ 过 $X$ 并与摩擦圆相切；构件 1 相对机架 3 {turning.zh}转动，故 $R_{{31}}$ 对 $A$ 的力矩为{against.zh}。作力多边形。",
                     f"Three forces meet in one point: $X$, where the lines of $F$ and $R_{{21}}$ cross. $R_{{31}}$ passes through $X$ and touches the friction circle; "
                     f"link 1 turns {turning.en} in the frame 3, so the moment of $R_{{31}}$ about $A$ is {against.en}. Draw the force polygon."), plan)
    up = leaned(1j, complex(turn), clamp.phi)
    meet, u31, closed = _three(bench, plan, clamp, size, up, clamp.rho, -turn, (R21, FORCE, R31))
    touch = -1j * u31 * -turn * clamp.rho
    free_body(bench, apart, clamp, meet, up, u31, touch)
    per_mm = board.scale_of(apart).value
    acts = (LineOfAction(point=complex(nominal(clamp.k)) * per_mm), LineOfAction(point=complex(nominal(touch)) * per_mm, tangent=against_sense(device)))
    ends = closed.ends
    letter(bench, plan, {"a": ends[R21.key][0], "b": ends[R21.key][1], "c": ends[FORCE.key][1]})
    bench.measured(R21, plan, *ends[R21.key], "a b", acts=acts[0])
    force = bench.measured(FORCE, plan, *ends[FORCE.key], "b c")
    bench.measured(R31, plan, *ends[R31.key], "c a", acts=acts[1])
    return force


def against_sense(device: EccentricClamp) -> str:
    """The sense of the moment of R_31 about A, against the turning; none without a friction circle."""
    return ("cw" if device.turn > 0 else "ccw") if device.radius else ""


def _three(bench: Bench, plan: Pane, clamp: Clamp, size: float, up: Points, rho: Reals, moment: float,
           names: tuple[Named, Named, Named]) -> tuple[Points, Points, Closed]:
    """The point where three forces meet, the direction of the pin's reaction through it, and the polygon."""
    board = bench.board
    try:
        meet = board.meet(Line(clamp.k, up), Line(clamp.h, clamp.pull), "F and R_21")
    except DeadPointError:
        raise EquilibriumError("F and R_21 act along parallel lines, so the three forces meet in no point of any sheet; turn the direction of F a little") from None
    along = board.tangent_from(meet, 0j, rho, moment, -(clamp.pull + up))
    press_on, push, hold = names
    force = sought(push, clamp.pull, Words("✓", "✓"))
    closed = balance(bench, plan, 0j, given(bench, plan, press_on, size, up), force,
                     sought(hold, along, Words("切于摩擦圆", "touches the circle") if float(nominal(rho)) else Words("过 $A$", "through $A$")))
    if not points_along(closed, force):
        raise LockedError("the polygon closes only with F reversed: with this friction no force on the handle keeps the clamp closing; "
                          "lengthen the handle, or lower f or rho")
    return meet, along, closed


def _frictionless(bench: Bench, device: EccentricClamp, clamp: Clamp) -> Quantity:
    """The same without friction: R_21 is normal, R_31 passes through A."""
    board = bench.board
    plan = board.open_pane(View.FORCE, "ideal", Words("不计摩擦时的力多边形", "Polygon without friction"))
    board.step(Words("不计摩擦时，$R_{21}$ 沿法线且等于 $Q$，$R_{31}$ 过 $A$ 点，同法求得理想驱动力 $F_0$。",
                     "Without friction $R_{21}$ is normal and equal to $Q$, and $R_{31}$ passes through $A$; in the same way find the ideal force $F_0$."), plan)
    names = (Named("R_21_0", "R_{21,0}", "N"), IDEAL, Named("R_31_0", "R_{31,0}", "N"))
    _, _, closed = _three(bench, plan, clamp, device.Q.si, 1j, 0.0, 0.0, names)
    ends = closed.ends[IDEAL.key]
    letter(bench, plan, {"a'": closed.ends["R_21_0"][0], "b'": ends[0], "c'": ends[1]})
    return bench.measured(IDEAL, plan, *ends, "b' c'")


def _released(bench: Bench, device: EccentricClamp, clamp: Clamp) -> None:
    """F removed: the sliding would be reversed; the disc rests where the line of R_21 then passes within ρ of A."""
    board, turn = bench.board, device.turn
    board.section(Words("去掉 $F$ 后是否自锁", "Does it hold when $F$ is removed?"))
    place = board.open_pane(View.MECHANISM, "released", Words("去掉 $F$ 后圆盘的受力", "The disc when $F$ is removed"), _finer(bench, clamp))
    times = board.scale_of(View.MECHANISM).value / board.scale_of(place).value
    large = replace(clamp, o=clamp.o * times, k=clamp.k * times, h=clamp.h * times, rho=clamp.rho * times, mm_r=clamp.mm_r * times)
    board.step(Words("去掉 $F$ 后圆盘有反转松开的趋势，$K$ 点的摩擦力反向，$R′_{21}$ 偏向法线的另一侧。此时圆盘为二力构件：只有当 $R′_{21}$ 与摩擦圆相割或相切时（或从夹紧一侧通过时），机构才能保持不动。由 $A$ 向 $R′_{21}$ 作垂线 $AC$，其长为力臂 $h$（使机构松开者为正）。",
                     "With $F$ gone the disc tends to turn back; friction at $K$ is reversed and $R′_{21}$ leans to the other side of the normal. The disc is now a two-force body: "
                     "it stays at rest only where the line of $R′_{21}$ cuts or touches the friction circle (or passes on its closing side). Drop the perpendicular $AC$ on it: the arm $h$ (positive where it opens the clamp)."), place)
    back = board.hand.tilt(leaned(1j, complex(-turn), clamp.phi))
    line, opening = Line(large.k, back), 1j * back * turn
    near = foot(line, 0j)
    draw_released(bench, place, large, back, near)
    arm = signed(bench, ARM, place, (0j, near), opening, "A C")
    board.step(Words("比较力臂与摩擦圆半径：", "Compare the arm with the radius of the friction circle:"))
    locks = np.asarray(arm.value) <= device.radius * (1 + 1e-9)
    sign, zh, en = ("≤", "机构自锁", "it locks itself") if bool(nominal(locks)) else (">", "机构不自锁", "it does not lock itself")
    text = f"$h$ = {number(1e3 * float(nominal(arm.value)))} mm {sign} $ρ$ = {number(1e3 * device.radius)} mm"
    if float(nominal(arm.value)) < 0:
        board.remark(Words("$h$ 为负，$R′_{21}$ 的力矩趋于夹紧。", " $h$ is negative: the moment of $R′_{21}$ tends to close the clamp."))
    bench.judged(SELF_LOCKING, locks, Words(f"{text}，{zh}。", f" {text}: {en}."))
    if device.limited:
        _limit(bench, large, line, opening, place)


def _finer(bench: Bench, clamp: Clamp) -> Scale:
    """The scale of the figure about A: as many times finer as the paper allows."""
    coarse = bench.board.scale_of(View.MECHANISM)
    times = next((k for k in (5, 4, 2.5, 2) if float(nominal(clamp.mm_r)) * k <= TALL), 1)
    return Scale(symbol="μ_l′", value=coarse.value / times, unit="m")


def _limit(bench: Bench, clamp: Clamp, line: Line, opening: Points, place: Pane) -> None:
    """The largest e that holds: R_21 touches the friction circle, and O keeps its distance from it."""
    board = bench.board
    board.step(Words("求自锁的极限偏心距：作平行于 $R′_{21}$ 且切于摩擦圆的直线，再作与它相距等于 $O$ 到 $R′_{21}$ 距离的平行线，交 $AO$ 方向于 $O′$，则 $AO′$ 即 $e_{max}$。",
                     "The largest eccentricity that holds: draw the line parallel to $R′_{21}$ that touches the friction circle, then its parallel at the distance of $O$ from $R′_{21}$; "
                     "it meets the ray $AO$ at $O′$, and $AO′$ is $e_{max}$."), place)
    touch = opening * clamp.rho
    beside = touch + clamp.o - foot(line, clamp.o)
    largest = board.meet(Line(beside, line.along), Line(0j, unit(clamp.o)), "R_21 and AO")
    at, t, b, along = (complex(nominal(z)) for z in (largest, touch, beside, line.along))
    board.mark(place, Segment(a=t - 12 * along, b=t + 12 * along, role=Role.HIDDEN), Segment(a=b, b=at + (at - b) / abs(at - b) * 5, role=Role.HIDDEN),
               Segment(a=0j, b=at, role=Role.CONSTRUCTION))
    board.plot(place, at, "O′")
    bench.measured(E_LIMIT, place, 0j, largest, "A O′")
