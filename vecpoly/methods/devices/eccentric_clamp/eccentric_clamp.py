"""An eccentric clamp: three forces through one point, the pin's reaction tangent to its friction circle;
self-locking as geometry."""

from __future__ import annotations

from ....algebra.quantity import Expr, Of, Quantity, magnitude
from ....board.construction import LineOfAction, View
from ....board.said.sides import side_of
from ....devices.eccentric_clamp import ETA, FORCE, IDEAL, PHI, R21, R31, EccentricClamp
from ....plane import Points, nominal
from ....words import Words
from ..bench import Bench
from ..equilibrium import frictionless, letter
from ..inclined import friction_angle, leaned
from ..registry import device_method
from ..sketches.eccentric_clamp import Clamp, free_body, sketch, without_friction
from .released import judge_released
from .three_forces import balance_three

APART = Words("圆盘 1 受力图（夹紧）", "Free body of disc 1, clamping")
_SENSES = (Words("逆时针", "counter-clockwise"), Words("顺时针", "clockwise"))
_SOURCE = "机械原理, eccentric clamp: friction circle and friction angle"


@device_method(EccentricClamp, title=Words("偏心夹紧机构", "Eccentric clamp"), source=_SOURCE, example="5-3")
def draw_eccentric_clamp(bench: Bench, device: EccentricClamp) -> None:
    """F + R_21 + R_31 = 0 through one point; F removed: self-locking where R_21 passes within ρ of A."""
    board = bench.board
    clamp = sketch(bench, device)
    board.section(Words("夹紧行程", "Clamping"))
    pressed = _contact(bench, device, clamp)
    force = _closing(bench, device, clamp, pressed)
    ideal = _frictionless(bench, device, clamp)
    bench.worked(ETA, ideal / force)
    judge_released(bench, device, clamp)


def _contact(bench: Bench, device: EccentricClamp, clamp: Clamp) -> Expr:
    """φ, and R_21 = Q / cos φ: its normal part clamps (N)."""
    board, closing = bench.board, device.turn > 0
    turning, side = _SENSES[not closing], (Words("右", "right") if closing else Words("左", "left"))
    board.step(
        Words(
            f"圆盘 1 {turning.zh}转动，在 $K$ 点相对工件 2 向{side.zh}滑动，故 $R_{{21}}$ 过 $K$ 点，"
            "自法线 $n$ 逆滑动方向偏转 $φ$；其法向分力等于 $Q$：",
            f"Disc 1 turns {turning.en} and slides at $K$ to the {side.en} on workpiece 2, so "
            "$R_{21}$ passes through $K$, turned from the normal $n$ by $φ$ against the "
            "sliding; its normal component is $Q$:",
        )
    )
    phi = friction_angle(bench, PHI, device.f)
    clamp.phi = float(nominal(phi.value))
    pressed = magnitude("Q", device.Q.si, "N") / Of("cos", phi)
    board.compute(R21.symbol, pressed, "N")
    return pressed


def _closing(bench: Bench, device: EccentricClamp, clamp: Clamp, pressed: Expr) -> Quantity:
    """F + R_21 + R_31 = 0 with friction: F and R_31 measured."""
    board, turn = bench.board, device.turn
    apart = board.open_pane(View.BODY, "disc", APART)
    plan = board.open_pane(View.FORCE, "disc", Words("力多边形（夹紧）", "Force polygon, clamping"))
    board.step(_concurrent(turn), plan)
    up = leaned(1j, complex(turn), clamp.phi)
    size = float(nominal(pressed.value))
    meet, u31, closed = balance_three(bench, plan, clamp, size, up, clamp.rho, -turn, (R21, FORCE, R31))
    touch = -1j * u31 * -turn * clamp.rho
    free_body(bench, apart, clamp, meet, up, u31, touch)
    if device.radius:
        board.remark(_side(touch))
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
    bench.laid(R21, pressed, ends[R21.key], "a b", acts[0])
    force = bench.measured(FORCE, plan, *ends[FORCE.key], "b c")
    bench.measured(R31, plan, *ends[R31.key], "c a", acts=acts[1])
    return force


def _concurrent(turn: float) -> Words:
    """Through which point the pin's reaction passes, and which way it turns."""
    turning, against = _SENSES if turn > 0 else _SENSES[::-1]
    return Words(
        "圆盘 1 受三力平衡，三力汇交于 $F$ 与 $R_{21}$ 作用线的交点 $X$，故 $R_{31}$ 过 $X$ 且切于 $A$ "
        f"处的摩擦圆；构件 1 相对机架 3 {turning.zh}转动，$R_{{31}}$ 对 $A$ 之矩与之相反，为{against.zh}。"
        "按 $μ_F$ 作力多边形：$ab$ 代表 $R_{21}$，过 $b$ 作 $F$ 的方向线，"
        "过 $a$ 作 $R_{31}$ 的方向线，交于 $c$。",
        "The three forces on disc 1 are concurrent at $X$, where the lines of $F$ and "
        "$R_{21}$ cross. So $R_{31}$ passes through $X$ and touches the friction circle "
        f"at $A$; link 1 turns {turning.en} in the frame 3, the moment of $R_{{31}}$ about $A$ "
        f"opposes that and is {against.en}. Draw the force "
        "polygon to the scale $μ_F$: $ab$ stands for $R_{21}$; the direction of $F$ through "
        "$b$ and that of $R_{31}$ through $a$ meet at $c$.",
    )


def _side(touch: Points) -> Words:
    """On which side of the friction circle the pin's reaction touches it."""
    side = side_of(complex(nominal(touch)))
    return Words(
        f"$R_{{31}}$ 切于 $A$ 处摩擦圆{side.zh}侧。",
        f" The reaction $R_{{31}}$ is tangent to the friction circle at $A$ on its {side.en} side.",
    )


def against_sense(device: EccentricClamp) -> str:
    """The sense of the moment of R_31 about A, against the turning; none without a friction circle."""
    return ("cw" if device.turn > 0 else "ccw") if device.radius else ""


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
    meet, _, closed = balance_three(bench, plan, clamp, device.Q.si, 1j, 0.0, 0.0, names)
    without_friction(bench, board.open_pane(View.BODY, "disc", APART), clamp, meet, (names[0], names[2]))
    ends = closed.ends[IDEAL.key]
    letter(bench, plan, {"a'": closed.ends[names[0].key][0], "b'": ends[0], "c'": ends[1]})
    return bench.measured(IDEAL, plan, *ends, "b' c'")
