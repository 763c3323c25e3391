"""A ring-spring buffer: the side wedge first, then wedge 1; the polygons of pushing and releasing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...board.construction import Pane, View
from ...devices.ring_spring import (
    BY_SINES,
    DRIVE,
    ETA,
    ETA_BACK,
    GREATEST,
    HOLD,
    HOLD_BY_SINES,
    IDEAL,
    LEAST,
    PHI,
    REACTIONS,
    RingSpring,
)
from ...formula import sym
from ...names import Named, reaction
from ...plane import Points, nominal
from ...quantity import Of, Quantity, magnitude, number
from ...words import Words
from .bench import Bench
from .inclined import (
    angle,
    between,
    drawn,
    driven,
    friction_angle,
    gauged,
    given,
    leaned,
    letter,
    ray,
    row_of,
    signed,
    sought,
)
from .registry import device_method
from .ring_spring_sketch import Faces, apart_one, apart_two, faces, sketch

R21, R42 = REACTIONS
R12, R31, SPRING = reaction("1", "2"), reaction("3", "1"), Named("Q", "Q", "N")
TITLES = {"push": Words("力多边形（压缩）", "Force polygon, pushing"), "ideal": Words("力多边形（无摩擦）", "Force polygon, no friction"),
          "release": Words("力多边形（回弹）", "Force polygon, releasing")}
OFF_N, ALONG_N, UPRIGHT = Words("与 $n$ 成 $φ$", "$φ$ off $n$"), Words("沿 $n$", "along $n$"), Words("竖直", "upright")


@dataclass(frozen=True, slots=True)
class Corners:
    """The joined polygon: Q = ab, R_12 = bc, R_42 = ca; R_31 = bd, F = dc."""

    place: Pane
    a: Points
    b: Points
    c: Points
    d: Points


@device_method(RingSpring, title=Words("环形弹簧缓冲器的力分析", "Forces in a ring-spring buffer"),
               source="机械原理, friction of inclined faces: both ways, efficiency, self-locking", example="5-4")
def draw_ring_spring(bench: Bench, device: RingSpring) -> None:
    """Sketch, friction angle, pushing, without friction, releasing, the limits."""
    board, it = bench.board, faces(device.alpha.si)
    board.section(Words("准备", "Preparation"))
    board.step(Words("画出简图：$F$ 压楔块 1 向下，两侧楔块 2、3 克服弹簧力 $Q$ 向外移动，4 固定。各面法线与 $F$ 成 $α$；不按比例。",
                     "Sketch, to no scale: $F$ pushes wedge 1 down, the side wedges 2 and 3 move out against the spring forces $Q$, 4 is fixed. The normals of all "
                     "faces make $α$ with $F$."), View.MECHANISM)
    sketch(bench, it)
    board.step(Words("求摩擦角。", "Find the friction angle."))
    phi = friction_angle(bench, PHI, device.f)
    alpha, load = angle("α", device.alpha.si), magnitude("Q", device.Q.si, "N")
    drive = _push(bench, device, it, phi)
    bench.worked(BY_SINES, load / Of("tan", alpha - phi))
    ideal = _ideal(bench, device, it, drive)
    _release(bench, device, it, phi, ideal)
    bench.worked(HOLD_BY_SINES, load / Of("tan", alpha + phi))
    _limits(bench, phi)


def _lines(it: Faces, phi: float, sense: int) -> tuple[Points, Points]:
    """Directions of R_12 and R_42 while 1 is pushed in (sense 1) or comes back (−1)."""
    return leaned(it.over, sense * it.slides_over, phi), leaned(it.under, sense * it.slides_under, phi)


def _push(bench: Bench, device: RingSpring, it: Faces, phi: Quantity) -> Quantity:
    board, (r12, r42) = bench.board, _lines(it, float(phi.value), 1)
    board.section(Words("压缩行程：$F$ 为驱动力", "Pushing: $F$ drives"))
    two = board.open_pane(View.BODY, "2", Words("楔块 2 受力图", "Wedge 2 apart"))
    board.step(Words("先取楔块 2：$Q$ 已知，$R_12$、$R_42$ 只有大小未知（楔块 1 上三力大小全未知）。2 相对 1 沿面向外上方滑（$v_21$），相对 4 沿面向外下方滑（$v_24$），"
                     "两反力都自法线偏 $φ$，与滑动相反。",
                     "Take wedge 2 first: $Q$ is known, of $R_12$ and $R_42$ only the sizes are unknown (of wedge 1 all three are). 2 slides outward and up on 1 "
                     "($v_21$), outward and down on 4 ($v_24$); both reactions lean by $φ$ from the normals against the sliding."), two)
    apart_two(bench, two, it, r12, r42)
    one = board.open_pane(View.BODY, "1", Words("楔块 1 受力图", "Wedge 1 apart"))
    board.step(Words("再取楔块 1：$R_21 = −R_12$ 已知，$R_31$ 与它对称，求 $F$。", "Then wedge 1: $R_21 = −R_12$ is known, $R_31$ is its mirror image; $F$ follows."), one)
    apart_one(bench, one, it, -r12)
    ends = _polygon(bench, device, (r12, r42), "push", DRIVE, Words.same(""))
    board.step(Words("量各边，乘以 $μ_F$；再用正弦定理核对（三角形 $abc$ 等腰，底边 $Q$）。",
                     "Measure the sides and multiply by $μ_F$; check by the sine rule (the triangle $abc$ on the base $Q$ has equal sides)."), ends.place)
    bench.measured(R21, ends.place, ends.c, ends.b, "c b")
    bench.measured(R42, ends.place, ends.c, ends.a, "c a")
    return bench.measured(DRIVE, ends.place, ends.d, ends.c, "d c")


def _ideal(bench: Bench, device: RingSpring, it: Faces, drive: Quantity) -> Quantity:
    bench.board.section(Words("效率", "Efficiency"))
    lead = Words("设各面无摩擦，反力沿法线，同样作力多边形。", "Without friction the reactions lie along the normals; the same polygon follows. ")
    ends = _polygon(bench, device, (it.over, it.under), "ideal", IDEAL, lead)
    bench.board.step(Words("量 $F_0$；压缩行程效率为 $F_0$ 与 $F$ 之比。", "Measure $F_0$; the efficiency of pushing is $F_0$ over $F$."), ends.place)
    ideal = bench.measured(IDEAL, ends.place, ends.d, ends.c, "d c")
    bench.worked(ETA, ideal / drive)
    return ideal


def _release(bench: Bench, device: RingSpring, it: Faces, phi: Quantity, ideal: Quantity) -> None:
    board = bench.board
    board.section(Words("回弹行程：$Q$ 为驱动力", "Releasing: $Q$ drives"))
    lead = Words("回弹时各滑动反向，反力偏到法线另一侧。", "Releasing, all sliding is reversed and the reactions lean to the other side. ")
    ends = _polygon(bench, device, _lines(it, float(phi.value), -1), "release", HOLD, lead)
    board.step(Words("量 $F'$；回弹行程效率为 $F'$ 与 $F_0$ 之比。再用公式核对。", "Measure $F'$; the efficiency of releasing is $F'$ over $F_0$. Check by the formula."), ends.place)
    hold = signed(bench, HOLD, ends.place, (ends.d, ends.c), -1j, "d c")
    bench.worked(ETA_BACK, hold / ideal)
    if float(nominal(hold.value)) <= 1e-9 * device.Q.si:
        board.remark(Words("$F' ≤ 0$：回弹自锁，弹簧不能把楔块 1 顶回。", " $F' ≤ 0$: the way back is self-locking, the springs do not push wedge 1 out."))


def _polygon(bench: Bench, device: RingSpring, along: tuple[Points, Points], name: str, drive: Named, lead: Words) -> Corners:
    """Q, R_12, R_42 close on wedge 2; −R_12, R_31 and the force on wedge 1 are joined to them at the common side."""
    board, place = bench.board, bench.board.open_pane(View.FORCE, name, TITLES[name])
    lean, (r12, r42) = ALONG_N if drive is IDEAL else OFF_N, along
    board.step(lead + Words("按 $μ_F$ 作楔块 2 的力多边形：$ab$ 代表 $Q$，过 $b$、$a$ 分别作 $R_12$、$R_42$ 的方向线，交于 $c$。",
                            "To the scale $μ_F$ draw the polygon of wedge 2: $ab$ is $Q$; the directions of $R_12$ through $b$ and of $R_42$ through $a$ meet at $c$."), place)
    terms = given(bench, place, SPRING, device.Q.si, -1 + 0j, "b"), sought(R12, r12, lean), sought(R42, r42, lean)
    closed = driven(bench, place, 0j, terms, device.locked)
    b, c = closed.ends[R12.key]
    board.step(Words(f"楔块 1：公共边 $cb$ 即 $R_21$；过 $b$ 作 $R_31$ 的方向线，过 $c$ 作 ${drive.symbol}$ 的方向线，交于 $d$。",
                     f"Wedge 1: the common side $cb$ is $R_21$; the direction of $R_31$ through $b$ and that of ${drive.symbol}$ through $c$ meet at $d$."), place)
    mirror = np.conj(r12)
    terms = drawn(R21, b - c), sought(R31, mirror, lean), sought(drive, -1j, UPRIGHT)
    closed = driven(bench, place, c, terms, device.locked, must_press=name == "push")
    _, d = closed.ends[R31.key]
    letter(bench, place, {"a": 0j, "c": c, "d": d})
    return Corners(place, 0j, b, c, d)


def _limits(bench: Bench, phi: Quantity) -> None:
    """Pushing: the reactions stand upright, none of them against Q. Releasing: they lie level, none of them against F."""
    board = bench.board
    board.section(Words("自锁极限", "Limits of self-locking"))
    place = board.open_pane(View.BODY, "limits", Words("自锁极限", "Limits of self-locking"))
    turn = np.exp(1j * np.radians(phi.value))
    push, release = board.hand.tilt(1j / turn), board.hand.tilt(turn)
    board.step(Words("压缩：总反力竖直（与 $F$ 平行）时没有与 $Q$ 平衡的分力，多大的 $F$ 也压不动；自竖直线量 $φ$ 得法线，它与 $F$ 的夹角为 $α$ 的下限。",
                     "Pushing: once the reactions stand upright, along $F$, they have no part against $Q$ and no $F$ moves the wedges. Set off $φ$ from the upright line: "
                     "the normal; its angle with $F$ is the least $α$."), place)
    for along, label in ((1j, "R_{42}"), (push, "n"), (release, "n'"), (1 + 0j, "R'_{42}")):
        ray(bench, place, 0j, along, 40.0, label)
    between(bench, place, 0j, push, 1j, 30.0, LEAST.symbol)
    least = gauged(bench, push, 1j)
    bench.stated(LEAST, least, row_of(sym(LEAST.symbol), f" = $φ$ = {number(float(nominal(least)))}°"))
    board.step(Words("回弹：总反力水平（与 $Q$ 平行）时没有推回楔块 1 的分力；自水平线量 $φ$ 得法线，它与 $F$ 的夹角为 $α$ 的上限。",
                     "Releasing: once the reactions lie level, along $Q$, no part of them pushes wedge 1 back. Set off $φ$ from the level line: the normal; its angle "
                     "with $F$ is the greatest $α$."), place)
    between(bench, place, 0j, release, 1j, 18.0, GREATEST.symbol)
    between(bench, place, 0j, 1 + 0j, release, 30.0, "φ")
    greatest = gauged(bench, release, 1j)
    bench.stated(GREATEST, greatest, row_of(sym(GREATEST.symbol), f" = 90° − $φ$ = {number(float(nominal(greatest)))}°"))
