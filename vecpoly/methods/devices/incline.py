"""A block on an inclined plane: up, down and without friction on one polygon; self-locking as geometry and as η' ≤ 0."""

from __future__ import annotations

import numpy as np

from ...board.construction import Pane, View
from ...board.marks import FixedGuide
from ...devices.incline import BY_SINES, DRIVE, ETA, ETA_BACK, HOLD, IDEAL, LIMIT, PHI, REACTION, Incline
from ...formula import sym
from ...names import Named
from ...plane import Points, nominal
from ...quantity import Of, Quantity, magnitude, number
from ...vector.equation import Term
from ...words import Words
from .bench import Bench
from .inclined import (
    Press,
    angle,
    between,
    body,
    concur,
    drawn,
    driven,
    friction_angle,
    gauged,
    given,
    haul,
    leaned,
    letter,
    points_along,
    press,
    pull,
    ray,
    row_of,
    signed,
    sought,
)
from .registry import device_method

WEIGHT = Named("Q", "Q", "N")
PLANE, LONG, HIGH = 72.0, 24.0, 13.0  # mm: the plane; the block
ARM, STEEP = 28.0, 0.2  # mm: the arrow of F; sine of its angle over the plane from which it is drawn as a pull
OFF_N, ALONG_N, ALONG_F = Words("与 $n$ 成 $φ$", "$φ$ off $n$"), Words("沿 $n$", "along $n$"), Words("与水平成 $β$", "$β$ to level")


@device_method(Incline, title=Words("斜面上滑块的力分析", "Forces on a block on an inclined plane"),
               source="机械原理, friction on an inclined plane: total reaction, friction cone, self-locking", example="5-1")
def draw_incline(bench: Bench, device: Incline) -> None:
    """Sketch, friction angle, limit slope, the block apart, up, without friction, down."""
    board = bench.board
    board.section(Words("准备", "Preparation"))
    board.step(Words("求摩擦角。", "Find the friction angle."))
    phi = friction_angle(bench, PHI, device.f)
    alpha = angle("α", device.alpha.si) if device.alpha else Quantity(sym("α"), phi.value, "deg")
    along, force = np.exp(1j * np.radians(alpha.value)), np.exp(1j * device.beta.si)
    board.step(Words("画出简图：滑块 1 在斜面 2 上，$F$ 与水平成 $β$，$Q$ 为重力；不按比例。", "Sketch, to no scale: block 1 on the plane 2, $F$ at $β$ to the "
                     "horizontal, the weight $Q$."), View.MECHANISM)
    _sketch(bench, along, force)
    _limit(bench, phi)
    _apart(bench, along, force, phi)
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
    haul(bench, view, middle, -1j, "Q", 24.0)
    ray(bench, view, middle, side, 24.0)
    between(bench, view, middle, side, side * force, 15.0, "β")


def _drive(bench: Bench, place: View | Pane, middle: Points, along: Points, force: Points) -> complex:
    """Draw F through the block as a pull, or as a push where a pull would point into the plane; gives the side of its arrow, 1 or −1."""
    pulls = float(nominal((force / along).imag)) > STEEP
    haul(bench, place, middle if pulls else middle - force * ARM, force, "F", ARM)
    return 1 + 0j if pulls else -1 + 0j


def _limit(bench: Bench, phi: Quantity) -> None:
    """The slope on which the reaction against the weight alone leans by just φ: normal and plane set out from the vertical."""
    board = bench.board
    board.section(Words("自锁条件：去掉 $F$", "Self-locking: $F$ taken away"))
    place = board.open_pane(View.BODY, "limit", Words("自锁极限", "Limit of self-locking"))
    normal = 1j * np.exp(1j * np.radians(phi.value))
    along = board.hand.tilt(-1j * normal)
    board.step(Words("只受 $Q$ 时，总反力 $R_21$ 与 $Q$ 共线，即竖直向上；它与法线的夹角等于 $α$，不能大于 $φ$。$Q$ 的作用线落在以法线为轴、顶角 $2φ$ 的摩擦锥内时，"
                     "无论 $Q$ 多大滑块都不动。极限位置：自竖直线量 $φ$ 得法线，作其垂线为斜面，量倾角。",
                     "Under $Q$ alone the total reaction $R_21$ lies in the line of $Q$, straight up; its angle with the normal is $α$ and cannot exceed $φ$. "
                     "While the line of $Q$ lies inside the friction cone (2φ about the normal) no weight moves the block. The limit: set off $φ$ from the "
                     "vertical for the normal, draw the plane perpendicular to it, read its slope."), place)
    middle = _on_plane(bench, place, along, LIMIT.symbol)
    foot = middle.real + 1j * (along * PLANE * 0.62).imag + 1j * (middle - along * PLANE * 0.62).real * np.tan(np.angle(along))
    haul(bench, place, middle, -1j, "Q", 26.0)
    haul(bench, place, foot, 1j, REACTION.symbol, 30.0)
    for turn, label in ((0.0, "n"), (1.0, "")):
        ray(bench, place, foot, normal * np.exp(1j * np.radians(phi.value) * turn), 34.0, label)
    between(bench, place, foot, 1j, normal, 26.0, "φ")
    between(bench, place, foot, normal, normal * normal / 1j, 26.0, "φ")
    slope = gauged(bench, 1 + 0j, along)
    bench.stated(LIMIT, slope, row_of(sym(LIMIT.symbol), f" = $φ$ = {number(float(nominal(slope)))}°"))
    board.remark(Words("自锁条件：$α ≤ φ$。", " Self-locking: $α ≤ φ$."))


def _apart(bench: Bench, along: Points, force: Points, phi: Quantity) -> None:
    board = bench.board
    board.section(Words("正行程与反行程", "Up and down"))
    place = board.open_pane(View.BODY, "up", Words("滑块受力图（上行）", "The block apart, going up"))
    board.step(Words("取滑块：$Q$ 已知，$F$、$R_21$ 方向已知，两个未知大小。滑块相对斜面上滑（$v_12$），$R_21$ 自法线偏 $φ$，指向下方一侧。",
                     "Take the block: $Q$ is known, $F$ and $R_21$ in direction only: two unknown sizes. The block slides up ($v_12$), so $R_21$ leans by "
                     "$φ$ from the normal, down the slope."), place)
    normal = 1j * along
    reaction = leaned(normal, along, phi.value)
    body(bench, place, *_block(along, 0j))
    middle = 0.5 * HIGH * normal
    foot = middle - reaction * (0.5 * HIGH / (reaction * np.conj(normal)).real)
    press(bench, place, Press(symbol=REACTION.symbol, at=foot, normal=normal, along=reaction, slides=along, speed="v_{12}"))
    top = middle + 1j * (0.5 * HIGH / normal.imag)
    _drive(bench, place, middle, along, force)
    pull(bench, place, top, -1j, "Q")
    concur(bench, place, middle, foot, top)


def _polygon(bench: Bench, device: Incline, alpha: Quantity, phi: Quantity, along: Points, force: Points) -> None:
    """Q = ab for all three; F, F_0, F' from b on one line, and the reactions back to a."""
    board, normal = bench.board, 1j * along
    place = board.open_pane(View.FORCE, "", Words("力多边形", "Force polygon"))
    board.step(Words("按 $μ_F$ 作力多边形：$ab$ 代表 $Q$，过 $b$ 作 $F$ 的方向线，过 $a$ 作 $R_21$ 的方向线，交于 $c$。",
                     "To the scale $μ_F$: $ab$ is $Q$; the direction of $F$ through $b$ and that of $R_21$ through $a$ meet at $c$."), place)
    weight = given(bench, place, WEIGHT, device.Q.si, -1j, "b")
    up = leaned(normal, along, phi.value)
    b, c = _closed(bench, device, place, weight, DRIVE, force, REACTION, up, "c", drives=True)
    drive = bench.measured(DRIVE, place, b, c, "b c")
    bench.measured(REACTION, place, c, 0j, "c a")
    _by_sines(bench, device, alpha, phi)
    board.step(Words("设无摩擦，反力沿法线，$F$ 的方向线上得 $c_0$；正行程效率为理想驱动力与实际驱动力之比。",
                     "Without friction the reaction lies along the normal: $c_0$ on the line of $F$. The efficiency upwards is the ideal driving force over the real one."), place)
    _, c0 = _closed(bench, device, place, drawn(WEIGHT, b), IDEAL, force, Named("R_21_0", "R_{21,0}", "N", True), normal, "c_0", drives=True)
    ideal = bench.measured(IDEAL, place, b, c0, "b c_0")
    bench.worked(ETA, ideal / drive)
    board.step(Words("反行程滑块下滑，反力偏到法线另一侧，得 $c'$；$F'$ 为维持匀速下滑之力，反行程以 $Q$ 驱动，效率为 $F'$ 与 $F_0$ 之比。",
                     "Going down, the reaction leans to the other side of the normal: $c'$. $F'$ lets the block slide down steadily; here $Q$ drives, and the "
                     "efficiency is $F'$ over $F_0$."), place)
    down = leaned(normal, -along, phi.value)
    _, c1 = _closed(bench, device, place, drawn(WEIGHT, b), HOLD, force, Named("R_21_r", "R'_{21}", "N", True), down, "c'", drives=False)
    between(bench, place, 0j, -normal, -up, 30.0, "φ")
    between(bench, place, 0j, -normal, -down, 30.0, "φ")
    hold = signed(bench, HOLD, place, (b, c1), force, "b c'")
    bench.worked(ETA_BACK, hold / ideal)
    if float(nominal(hold.value)) <= 1e-9 * device.Q.si:
        board.remark(Words("$F' ≤ 0$，故 $η' ≤ 0$：反行程自锁，与 $α ≤ φ$ 一致。", " $F' ≤ 0$, so $η' ≤ 0$: the way down is self-locking, as $α ≤ φ$ says."))


def _closed(bench: Bench, device: Incline, place: Pane, weight: Term, drive: Named, force: Points, reaction: Named, along: Points, corner: str,
            drives: bool) -> tuple[Points, Points]:
    """Q + F + R = 0; gives the corners b and c. Raises LockedError where the reaction, or a driving force, would have to pull."""
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
    bench.board.step(Words("用正弦定理核对：三角形 $abc$ 中", "Check by the sine rule in the triangle $abc$:"))
    bench.worked(BY_SINES, magnitude("Q", device.Q.si, "N") * Of("sin", alpha + phi) / Of("cos", beta - alpha - phi))
