"""An eccentric clamp: three forces through one point, the pin's reaction tangent to its friction circle; self-locking
as geometry."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...algebra.quantity import Of, Quantity, magnitude, number
from ...board.construction import LineOfAction, Pane, Scale, View
from ...board.paper.marks import Role, Segment
from ...devices.eccentric_clamp import ARM, E_LIMIT, ETA, FORCE, IDEAL, PHI, R21, R31, SELF_LOCKING, EccentricClamp
from ...errors import DeadPointError, EquilibriumError, LockedError
from ...names import Named
from ...plane import Line, Points, Reals, foot, nominal, unit
from ...vector.close import Closed
from ...words import Words
from .bench import Bench
from .inclined import balance, friction_angle, frictionless, given, leaned, letter, points_along, signed, sought
from .registry import device_method
from .sketches.eccentric_clamp import Clamp, draw_released, free_body, sketch

_SENSES = (Words("逆时针", "counter-clockwise"), Words("顺时针", "clockwise"))
TALL = 85.0  # mm: radius of the disc in the figure about its pin
_SOURCE = "机械原理, eccentric clamp: friction circle and friction angle"


@device_method(EccentricClamp, title=Words("偏心夹紧机构", "Eccentric clamp"), source=_SOURCE, example="5-3")
def draw_eccentric_clamp(bench: Bench, device: EccentricClamp) -> None:
    """F + R_21 + R_31 = 0 through one point; F removed: self-locking where R_21 passes within ρ of A."""
    board = bench.board
    clamp = sketch(bench, device)
    board.section(Words("夹紧行程", "Clamping"))
    size = _contact(bench, device, clamp)
    force = _closing(bench, device, clamp, size)
    ideal = _frictionless(bench, device, clamp)
    bench.worked(ETA, ideal / force)
    _released(bench, device, clamp)


def _contact(bench: Bench, device: EccentricClamp, clamp: Clamp) -> float:
    """φ, and R_21 = Q / cos φ: its normal part clamps (N)."""
    board, closing = bench.board, device.turn > 0
    turning, side = _SENSES[not closing], (Words("右", "right") if closing else Words("左", "left"))
    board.step(
        Words(
            f"圆盘 1 {turning.zh}转动，在 $K$ 点相对工件 2 向{side.zh}滑动，故 $R_{{21}}$ 过 $K$ 点，"
            "自法线 $n$ 逆滑动方向偏转 $φ$；其法向分力等于 $Q$：",
            f"Disc 1 turns {turning.en} and slides at $K$ to the {side.en} on the work 2, so "
            "$R_{21}$ passes through $K$, turned from the normal $n$ by $φ$ against the "
            "sliding; its normal component is $Q$:",
        )
    )
    phi = friction_angle(bench, PHI, device.f)
    clamp.phi = float(nominal(phi.value))
    return float(nominal(board.compute("R_{21}", magnitude("Q", device.Q.si, "N") / Of("cos", phi), "N").value))


def _closing(bench: Bench, device: EccentricClamp, clamp: Clamp, size: float) -> Quantity:
    """F + R_21 + R_31 = 0 with friction: F and R_31 measured."""
    board, turn = bench.board, device.turn
    apart = board.open_pane(View.BODY, "disc", Words("圆盘 1 受力图（夹紧）", "Free body of disc 1, clamping"))
    plan = board.open_pane(View.FORCE, "disc", Words("力多边形（夹紧）", "Force polygon, clamping"))
    turning, against = _SENSES if turn > 0 else _SENSES[::-1]
    board.step(
        Words(
            "圆盘 1 受三力平衡，三力汇交于 $F$ 与 $R_{21}$ 作用线的交点 $X$，故 $R_{31}$ 过 $X$ 且切于 $A$ "
            f"处的摩擦圆；构件 1 相对机架 3 {turning.zh}转动，$R_{{31}}$ 对 $A$ 之矩与之相反，为{against.zh}，"
            "由此定出是哪一条切线。按 $μ_F$ 作力多边形：$ab$ 代表 $R_{21}$，过 $b$ 作 $F$ 的方向线，"
            "过 $a$ 作 $R_{31}$ 的方向线，交于 $c$。",
            "The three forces on disc 1 meet in one point: $X$, where the lines of $F$ and "
            "$R_{21}$ cross. So $R_{31}$ passes through $X$ and touches the friction circle "
            f"at $A$; link 1 turns {turning.en} in the frame 3, the moment of $R_{{31}}$ about $A$ "
            f"opposes that and is {against.en}: this tells which tangent it is. Draw the force "
            "polygon to the scale $μ_F$: $ab$ stands for $R_{21}$; the direction of $F$ through "
            "$b$ and that of $R_{31}$ through $a$ meet at $c$.",
        ),
        plan,
    )
    up = leaned(1j, complex(turn), clamp.phi)
    meet, u31, closed = _three(bench, plan, clamp, size, up, clamp.rho, -turn, (R21, FORCE, R31))
    touch = -1j * u31 * -turn * clamp.rho
    free_body(bench, apart, clamp, meet, up, u31, touch)
    per_mm = board.scale_of(apart).value
    acts = (
        LineOfAction(
            point=complex(nominal(clamp.k)) * per_mm,
            told=Words("过接触点 $K$，偏离法线 $φ$", "through the contact $K$, inclined to the normal by $φ$"),
        ),
        LineOfAction(point=complex(nominal(touch)) * per_mm, tangent=against_sense(device)),
    )
    ends = closed.ends
    letter(bench, plan, {"a": ends[R21.key][0], "b": ends[R21.key][1], "c": ends[FORCE.key][1]})
    bench.measured(R21, plan, *ends[R21.key], "a b", acts=acts[0], told=False)
    force = bench.measured(FORCE, plan, *ends[FORCE.key], "b c")
    bench.measured(R31, plan, *ends[R31.key], "c a", acts=acts[1])
    return force


def against_sense(device: EccentricClamp) -> str:
    """The sense of the moment of R_31 about A, against the turning; none without a friction circle."""
    return ("cw" if device.turn > 0 else "ccw") if device.radius else ""


def _three(
    bench: Bench,
    plan: Pane,
    clamp: Clamp,
    size: float,
    up: Points,
    rho: Reals,
    moment: float,
    names: tuple[Named, Named, Named],
) -> tuple[Points, Points, Closed]:
    """The point where three forces meet, the direction of the pin's reaction through it, and the polygon."""
    board = bench.board
    try:
        meet = board.meet(Line(clamp.k, up), Line(clamp.h, clamp.pull), Words("F 与 R_21", "F and R_21"))
    except DeadPointError:
        raise EquilibriumError(
            Words(
                "F 与 R_21 的作用线平行，三力在图上不能汇交；请略微改变 F 的方向",
                "F and R_21 act along parallel lines, so the three forces meet in no point of any sheet; turn "
                "the direction of F a little",
            )
        ) from None
    along = board.tangent_from(meet, 0j, rho, moment, -(clamp.pull + up), key=names[2].key)
    press_on, push, hold = names
    force = sought(push, clamp.pull, Words("✓", "✓"))
    closed = balance(
        bench,
        plan,
        0j,
        given(bench, plan, press_on, size, up),
        force,
        sought(
            hold,
            along,
            Words("切于摩擦圆", "touches the circle") if float(nominal(rho)) else Words("过 $A$", "through $A$"),
        ),
    )
    if not points_along(closed, force):
        raise LockedError(
            Words(
                "力多边形只有在 F 反向时才闭合：在此摩擦下手柄上的力不能使夹具继续夹紧；请加长手柄，或减小 f 或 rho",
                "the polygon closes only with F reversed: with this friction no force on the handle keeps the "
                "clamp closing; lengthen the handle, or lower f or rho",
            )
        )
    return meet, along, closed


def _frictionless(bench: Bench, device: EccentricClamp, clamp: Clamp) -> Quantity:
    """The same without friction: R_21 is normal, R_31 passes through A."""
    board = bench.board
    plan = board.open_pane(View.FORCE, "ideal", Words("力多边形（无摩擦）", "Force polygon, no friction"))
    board.step(
        Words(
            "不计摩擦时，$R_{21,0} = Q$ 沿法线，$R_{31,0}$ 过 $A$ 点，同法求得理想驱动力 $F_0$；效率等于 $F_0$ 与 "
            "$F$ 之比：",
            "Without friction $R_{21,0} = Q$ is normal, and $R_{31,0}$ passes through $A$; in the "
            "same way find the ideal driving force $F_0$. The efficiency is the ratio of $F_0$ to "
            "$F$:",
        ),
        plan,
    )
    names = (frictionless(R21), IDEAL, frictionless(R31))
    _, _, closed = _three(bench, plan, clamp, device.Q.si, 1j, 0.0, 0.0, names)
    ends = closed.ends[IDEAL.key]
    letter(bench, plan, {"a'": closed.ends[names[0].key][0], "b'": ends[0], "c'": ends[1]})
    return bench.measured(IDEAL, plan, *ends, "b' c'")


def _released(bench: Bench, device: EccentricClamp, clamp: Clamp) -> None:
    """F removed: the sliding would be reversed; the disc rests where the line of R_21 then passes within ρ of A."""
    board, turn = bench.board, device.turn
    board.section(Words("自锁条件（去掉 $F$）", "Self-locking: $F$ removed"))
    place = board.open_pane(
        View.MECHANISM,
        "released",
        Words("去掉 $F$ 后 $R′_{21}$ 的作用线", "Line of $R′_{21}$ with $F$ removed"),
        _finer(bench, clamp),
    )
    times = board.scale_of(View.MECHANISM).value / board.scale_of(place).value
    large = replace(
        clamp, o=clamp.o * times, k=clamp.k * times, h=clamp.h * times, rho=clamp.rho * times, mm_r=clamp.mm_r * times
    )
    board.step(
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
    back = board.turn(leaned(1j, complex(-turn), clamp.phi))
    line, opening = Line(large.k, back), 1j * back * turn
    near = foot(line, 0j)
    draw_released(bench, place, large, back, near)
    arm = signed(bench, ARM, place, (0j, near), opening, "A C")
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
    text = f"$h$ = {number(1e3 * float(nominal(arm.value)))} mm {sign} $ρ$ = {number(1e3 * device.radius)} mm"
    if float(nominal(arm.value)) < 0:
        board.remark(
            Words("$h$ 为负，$R′_{21}$ 之矩使机构夹紧。", " $h$ is negative: the moment of $R′_{21}$ closes the clamp.")
        )
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
    at, t, b, along = (complex(nominal(z)) for z in (largest, touch, beside, line.along))
    board.mark(
        place,
        Segment(a=t - 12 * along, b=t + 12 * along, role=Role.HIDDEN),
        Segment(a=b, b=at + (at - b) / abs(at - b) * 5, role=Role.HIDDEN),
        Segment(a=0j, b=at, role=Role.CONSTRUCTION),
    )
    board.plot(place, at, "O′")
    bench.measured(E_LIMIT, place, 0j, largest, "A O′")
