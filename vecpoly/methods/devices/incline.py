"""A block on an inclined plane: up, down and without friction on one polygon; self-locking as geometry and as η' ≤
0."""

from __future__ import annotations

import numpy as np

from ...algebra.formula import sym
from ...algebra.quantity import Of, Quantity, magnitude, number
from ...board.construction import Pane, View
from ...board.paper.marks import FixedGuide, LinkNumber
from ...devices.incline import BY_SINES, DRIVE, ETA, ETA_BACK, HOLD, IDEAL, LIMIT, PHI, REACTION, Incline
from ...names import Named
from ...plane import Points, nominal
from ...vector.equation import Term
from ...words import Words
from .bench import Bench
from .inclined import (
    ALONG_N,
    OFF_N,
    Press,
    angle,
    between,
    body,
    concur,
    cone,
    drawn,
    driven,
    friction_angle,
    frictionless,
    gauged,
    given,
    haul,
    leaned,
    letter,
    points_along,
    press,
    pull,
    ray,
    reversed_way,
    row_of,
    signed,
    sought,
)
from .registry import device_method

WEIGHT = Named("Q", "Q", "N")
PLANE, LONG, HIGH = 72.0, 24.0, 13.0  # mm: the plane; the block
ARM, STEEP = 24.0, 0.2  # mm: the arrow of F; sine of its angle over the plane from which it is drawn as a pull
ALONG_F = Words("与水平成 $β$", "$β$ to horizontal")


@device_method(
    Incline,
    title=Words("斜面上滑块的力分析", "Forces on a block on an inclined plane"),
    source="机械原理, friction on an inclined plane: total reaction, friction cone, self-locking",
    example="5-1",
)
def draw_incline(bench: Bench, device: Incline) -> None:
    """Sketch, friction angle, limit slope, the block apart, up, without friction, down."""
    board = bench.board
    board.section(Words("简图与摩擦角", "Sketch and friction angle"))
    board.step(
        Words(
            "画出简图（长度不按比例）：滑块 1 在斜面 2 上，受重力 $Q$ 和与水平成 $β$ 角的力 $F$。求摩擦角：",
            "Sketch, lengths not to scale: block 1 on the plane 2 under its weight $Q$ and the "
            "force $F$ at $β$ to the horizontal. The friction angle:",
        ),
        View.MECHANISM,
    )
    phi = friction_angle(bench, PHI, device.f)
    alpha = angle("α", device.alpha.si) if device.alpha else Quantity(sym("α"), phi.value, "deg")
    along, force = np.exp(1j * np.radians(alpha.value)), np.exp(1j * device.beta.si)
    _sketch(bench, along, force)
    _limit(bench, phi)
    _apart(bench, along, force, phi, device.alpha is None)
    _polygon(bench, device, alpha, phi, along, force)


def _block(along: Points, foot: Points) -> tuple[Points, ...]:
    """Corners of a block whose base lies along the plane, its middle at `foot`."""
    low = foot - along * LONG / 2
    return low, low + along * LONG, low + along * (LONG + 1j * HIGH), low + along * 1j * HIGH


def _on_plane(bench: Bench, place: View | Pane, along: Points, label: str) -> Points:
    """The plane with its angle, and a block on it; gives the middle of the block."""
    end, foot = complex(nominal(along * PLANE)), along * PLANE * 0.62
    bench.board.mark(place, FixedGuide(a=0j, b=end))
    ray(bench, place, 0j, 1 + 0j, PLANE * 0.62)
    between(bench, place, 0j, 1 + 0j, along, 30.0, label)
    body(bench, place, *_block(along, foot))
    return foot + 0.5j * along * HIGH


def _sketch(bench: Bench, along: Points, force: Points) -> None:
    view = View.MECHANISM
    middle = _on_plane(bench, view, along, "α")
    side = _drive(bench, view, middle, along, force)
    haul(bench, view, middle, -1j, "Q", 20.0)
    ray(bench, view, middle, side, 24.0)
    at = complex(nominal(along * (PLANE - 4))) - 4j
    for number_at, name in ((complex(nominal(middle - along * 0.32 * LONG)), "1"), (at, "2")):
        bench.board.mark(view, LinkNumber(a=number_at, b=number_at, number=name))
    between(bench, view, middle, side, side * force, 15.0, "β")


def _drive(bench: Bench, place: View | Pane, middle: Points, along: Points, force: Points) -> complex:
    """Draw F through the block as a pull, or as a push where a pull would point into the plane; gives the side of its
    arrow, 1 or −1."""
    pulls = float(nominal((force / along).imag)) > STEEP
    haul(bench, place, middle if pulls else middle - force * ARM, force, "F", ARM)
    return 1 + 0j if pulls else -1 + 0j


def _limit(bench: Bench, phi: Quantity) -> None:
    """The slope on which the reaction against the weight alone leans by just φ: normal and plane set out from the
    vertical."""
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
    middle = _on_plane(bench, place, along, LIMIT.symbol)
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


def _apart(bench: Bench, along: Points, force: Points, phi: Quantity, limit: bool) -> None:
    board = bench.board
    at = "，$α = φ$" if limit else "", ", $α = φ$" if limit else ""
    board.section(Words(f"正行程与反行程{at[0]}", f"Driving up and sliding down{at[1]}"))
    place = board.open_pane(View.BODY, "up", Words("滑块受力图（正行程）", "Free body of the block, driven up"))
    board.step(
        Words(
            "取滑块为分离体。滑块相对斜面的速度 $v_12$ 沿斜面向上，摩擦力沿斜面向下，故 $R_21$ 自法线 $n$ 向下滑一"
            "侧偏转 $φ$，与 $v_12$ 成 $90° + φ$。$Q$ 全知，$F$、$R_21$ 方向已知，只有两个未知的大小；"
            "三力汇交于一点。",
            "Take the block as a free body. It slides up the plane ($v_12$), so friction acts "
            "down the plane and $R_21$ is turned from the normal $n$ by $φ$ down the slope: it "
            "makes $90° + φ$ with $v_12$. $Q$ is known, $F$ and $R_21$ in direction, so that two "
            "magnitudes are unknown; the three forces meet in one point.",
        ),
        place,
    )
    normal = 1j * along
    reaction = leaned(normal, along, phi.value)
    body(bench, place, *_block(along, 0j))
    middle = 0.5 * HIGH * normal
    foot = middle - reaction * (0.5 * HIGH / (reaction * np.conj(normal)).real)
    press(
        bench,
        place,
        Press(symbol=REACTION.symbol, at=foot, normal=normal, along=reaction, slides=along, speed="v_{12}"),
    )
    top = middle + 1j * (0.5 * HIGH / normal.imag)
    _drive(bench, place, middle, along, force)
    pull(bench, place, top, -1j, "Q")
    concur(bench, place, middle, foot, top)


def _polygon(bench: Bench, device: Incline, alpha: Quantity, phi: Quantity, along: Points, force: Points) -> None:
    """Q = ab for all three; F, F_0, F' from b on one line, and the reactions back to a."""
    board, normal = bench.board, 1j * along
    place = board.open_pane(View.FORCE, "", Words("力多边形", "Force polygon"))
    board.step(
        Words(
            "按 $μ_F$ 作力多边形：$ab$ 代表 $Q$，过 $b$ 作 $F$ 的方向线，过 $a$ 作 $R_21$ 的方向线，交于 $c$。",
            "Draw the force polygon to the scale $μ_F$: $ab$ stands for $Q$; the direction of $F$ "
            "through $b$ and that of $R_21$ through $a$ meet at $c$.",
        ),
        place,
    )
    weight = given(bench, place, WEIGHT, device.Q.si, -1j, "b")
    up = leaned(normal, along, phi.value)
    b, c = _closed(bench, device, place, weight, DRIVE, force, REACTION, up, "c", drives=True)
    drive = bench.measured(DRIVE, place, b, c, "b c")
    bench.measured(REACTION, place, c, 0j, "c a")
    _by_sines(bench, device, alpha, phi)
    board.step(
        Words(
            "设无摩擦，反力沿法线：过 $a$ 作平行于 $n$ 的直线，交 $F$ 的方向线于 $c_0$。正行程效率等于理想驱动力与"
            "实际驱动力之比；",
            "Without friction the reaction is normal: the parallel to $n$ through $a$ meets the "
            "line of $F$ at $c_0$. The efficiency is the ratio of the ideal to the actual driving "
            "force; ",
        ),
        place,
    )
    _, c0 = _closed(
        bench, device, place, drawn(WEIGHT, b), IDEAL, force, frictionless(REACTION), normal, "c_0", drives=True
    )
    ideal = bench.measured(IDEAL, place, b, c0, "b c_0")
    bench.worked(ETA, ideal / drive)
    _eta_by_formula(bench, device, alpha, phi)
    board.step(
        Words(
            "反行程：$Q$ 为驱动力，滑块下滑，$R'_21$ 偏到法线的另一侧，过 $a$ 作其方向线，交 $F$ 的方向线于 $c'$；"
            "$F'$ 为使滑块匀速下滑所需的阻力。反行程效率等于实际阻力与理想阻力之比。",
            "The way back: $Q$ drives and $R'_21$ is turned to the other side of the normal; its "
            "direction through $a$ meets the line of $F$ at $c'$. $F'$ is the resistance with "
            "which the block slides down steadily; the efficiency is the ratio of the actual to "
            "the ideal resistance.",
        ),
        place,
    )
    down = leaned(normal, -along, phi.value)
    _, c1 = _closed(
        bench, device, place, drawn(WEIGHT, b), HOLD, force, reversed_way(REACTION), down, "c'", drives=False
    )
    between(bench, place, 0j, -normal, -up, 30.0, "φ")
    between(bench, place, 0j, -normal, -down, 30.0, "φ")
    hold = signed(bench, HOLD, place, (b, c1), force, "b c'")
    bench.worked(ETA_BACK, hold / ideal)
    _told_back(bench, device, float(nominal(hold.value)))


def _closed(
    bench: Bench,
    device: Incline,
    place: Pane,
    weight: Term,
    drive: Named,
    force: Points,
    reaction: Named,
    along: Points,
    corner: str,
    drives: bool,
) -> tuple[Points, Points]:
    """Q + F + R = 0; gives the corners b and c. Raises LockedError where the reaction, or a driving force, would have
    to pull."""
    terms = (weight, sought(drive, force, ALONG_F), sought(reaction, along, ALONG_N if drive is IDEAL else OFF_N))
    refusal = device.locked if drives else device.stuck
    closed = driven(bench, place, 0j, terms, refusal, must_press=drives)
    if not points_along(closed, terms[2]):
        raise refusal()
    b, c = closed.ends[drive.key]
    letter(bench, place, {"a": 0j, corner: c})
    return b, c


def _by_sines(bench: Bench, device: Incline, alpha: Quantity, phi: Quantity) -> None:
    beta = angle("β", device.beta.si)
    bench.board.step(
        Words(
            "用正弦定理核对：三角形 $abc$ 中，$∠a = α + φ$，$∠c = 90° + β − α − φ$，故",
            "Check by the sine rule: in the triangle $abc$ the angles are $∠a = α + φ$ and "
            "$∠c = 90° + β − α − φ$, so that",
        )
    )
    bench.worked(BY_SINES, magnitude("Q", device.Q.si, "N") * Of("sin", alpha + phi) / Of("cos", beta - alpha - phi))


def _eta_by_formula(bench: Bench, device: Incline, alpha: Quantity, phi: Quantity) -> None:
    """F_0 is F at φ = 0: η = sin α cos(β − α − φ) / (sin(α + φ) cos(β − α))."""
    beta = angle("β", device.beta.si)
    bench.board.remark(
        Words("在 $F$ 的公式中令 $φ$ = 0 得 $F_0$，用公式核对。", "the formula for $F$ with $φ$ = 0 gives a check.")
    )
    bench.board.compute(
        "η", Of("sin", alpha) * Of("cos", beta - alpha - phi) / (Of("sin", alpha + phi) * Of("cos", beta - alpha)), ""
    )


def _told_back(bench: Bench, device: Incline, hold: float) -> None:
    """Whether the way back is self-locking, from the sign of F'."""
    nothing = 1e-9 * device.Q.si
    if abs(hold) <= nothing:
        bench.board.remark(
            Words("本题 $F'$ = 0，$η'$ = 0，恰为自锁的极限。", " Here $F'$ = $η'$ = 0: the limit of self-locking.")
        )
    elif hold < 0:
        bench.board.remark(
            Words(
                "本题 $F'$ < 0，$η'$ < 0：反行程自锁，须反向施力才能使滑块下滑，与 $α < φ$ 一致。",
                " Here $F'$ < 0 and $η'$ < 0: the way back is self-locking, the block "
                "must be pulled down, as $α < φ$ says.",
            )
        )
    else:
        bench.board.remark(
            Words(
                "本题 $F'$ > 0，$η'$ > 0：反行程不自锁，与 $α > φ$ 一致。",
                " Here $F'$ > 0 and $η'$ > 0: the way back is not self-locking, as $α > φ$ says.",
            )
        )
