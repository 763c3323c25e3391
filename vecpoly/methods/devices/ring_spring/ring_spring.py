"""A ring-spring buffer: the side wedge first, then wedge 1; the polygons of pushing and releasing."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Of, Quantity, magnitude
from ....board.construction import View
from ....devices.ring_spring import (
    BY_SINES,
    DRIVE,
    ETA,
    ETA_BACK,
    HOLD,
    HOLD_BY_SINES,
    IDEAL,
    PHI,
    REACTIONS,
    RingSpring,
)
from ....names import Named, reaction
from ....plane import Points, nominal
from ....words import Words
from ..bench import Bench
from ..equilibrium import drawn, driven, given, letter, signed, sought
from ..inclined import angle, friction_angle, leaned
from ..registry import device_method
from ..sketches.ring_spring import Faces, apart_one, apart_two, faces, sketch
from ..strokes import Corners, Stroke, strokes
from .limits import limits

R21, R42 = REACTIONS
R12, R31, SPRING = reaction("1", "2"), reaction("3", "1"), Named("Q", "Q", "N")
PUSH, SMOOTH, RELEASE = strokes(DRIVE, IDEAL, HOLD, Words("压缩", "compression"), Words("回弹", "release"))
VERTICAL = Words("竖直", "vertical")


@device_method(
    RingSpring,
    title=Words("环形弹簧缓冲器的力分析", "Forces in a ring-spring buffer"),
    source="机械原理, friction of inclined faces: both ways, efficiency, self-locking",
    example="5-4",
)
def draw_ring_spring(bench: Bench, device: RingSpring) -> None:
    """Sketch, friction angle, pushing, without friction, releasing, the limits."""
    board, it = bench.board, faces(device.alpha.si)
    board.section(Words("简图与摩擦角", "Sketch and friction angle"))
    board.step(
        Words(
            "画出简图（长度不按比例）：$F$ 压楔块 1 向下，两侧楔块 2、3 克服弹簧力 $Q$ 向外移动，4 为机架；"
            "各斜面的法线与 $F$ 成 $α$ 角。",
            "Sketch, lengths not to scale: $F$ pushes wedge 1 down, and the side wedges 2 and 3 move "
            "out against the spring forces $Q$; 4 is the frame. The normals of all faces make the "
            "angle $α$ with $F$.",
        ),
        View.MECHANISM,
    )
    sketch(bench, it)
    board.step(Words("求摩擦角：", "The friction angle is:"))
    phi = friction_angle(bench, PHI, device.f)
    alpha, load = angle("α", device.alpha.si), magnitude("Q", device.Q.si, "N")
    drive = _push(bench, device, it, phi)
    bench.worked(BY_SINES, load / Of("tan", alpha - phi))
    ideal = _ideal(bench, device, it, drive)
    board.compute("η", Of("tan", alpha - phi) / Of("tan", alpha), "")
    _release(bench, device, it, phi, ideal)
    bench.worked(HOLD_BY_SINES, load / Of("tan", alpha + phi))
    board.compute("η'", Of("tan", alpha) / Of("tan", alpha + phi), "")
    limits(bench, device, phi)


def _lines(it: Faces, phi: float, sense: int) -> tuple[Points, Points]:
    """Directions of R_12 and R_42 while 1 is pushed in (sense 1) or comes back (−1)."""
    return leaned(it.over, sense * it.slides_over, phi), leaned(it.under, sense * it.slides_under, phi)


def _push(bench: Bench, device: RingSpring, it: Faces, phi: Quantity) -> Quantity:
    """The polygon of compression, measured after both wedges are drawn apart."""
    board, along = bench.board, _lines(it, float(nominal(phi.value)), 1)
    board.section(Words("压缩行程：$F$ 为驱动力", "Compression: $F$ drives"))
    _wedges_apart(bench, it, *along)
    ends = _polygon(bench, device, along, PUSH, Words.same(""))
    board.step(
        Words(
            "量各边，乘以 $μ_F$。用正弦定理核对：等腰三角形 $abc$ 的两腰与 $F$ 成 $α − φ$，故 $Q = 2R_21 sin(α − "
            "φ)$；同理 $F = 2R_21 cos(α − φ)$，即 $F = Q cot(α − φ)$。",
            "Measure the sides and multiply by $μ_F$. Check by the sine rule: the equal sides of "
            "the triangle $abc$ make $α − φ$ with $F$, so that $Q = 2R_21 sin(α − φ)$, and "
            "likewise $F = 2R_21 cos(α − φ)$; hence $F = Q cot(α − φ)$.",
        ),
        ends.place,
    )
    bench.measured(R21, ends.place, ends.c, ends.b, "c b")
    bench.measured(R42, ends.place, ends.c, ends.a, "c a")
    return bench.measured(DRIVE, ends.place, ends.d, ends.c, "d c")


def _wedges_apart(bench: Bench, it: Faces, r12: Points, r42: Points) -> None:
    """Wedge 2, on which two magnitudes are unknown, then wedge 1."""
    board = bench.board
    two = board.open_pane(View.BODY, "2", Words("楔块 2 受力图（压缩）", "Free body of wedge 2, compression"))
    board.step(
        Words(
            "先取楔块 2 为分离体：$Q$ 已知，$R_12$、$R_42$ 只有大小未知，可解（楔块 1 上三力的大小都未知）。"
            "2 相对 1 沿斜面向外上方滑动（$v_21$），相对 4 沿斜面向外下方滑动（$v_24$），故 $R_12$、"
            "$R_42$ 各自法线 $n$ 逆滑动方向偏转 $φ$；三力汇交于一点。",
            "Take wedge 2 first: $Q$ is known, and of $R_12$ and $R_42$ only the magnitudes are "
            "unknown, whereas on wedge 1 the magnitudes of all three forces are. Wedge 2 slides "
            "outward and up on 1 ($v_21$), outward and down on 4 ($v_24$), so $R_12$ and $R_42$ "
            "are turned from the normals $n$ by $φ$ against the sliding; the three forces are "
            "concurrent.",
        ),
        two,
    )
    apart_two(bench, two, it, r12, r42)
    one = board.open_pane(View.BODY, "1", Words("楔块 1 受力图（压缩）", "Free body of wedge 1, compression"))
    board.step(
        Words(
            "再取楔块 1 为分离体：$R_21 = −R_12$ 已求得；由对称，$R_31$ 与 $R_21$ 关于 $F$ 的作用线对称。$R_31$、"
            "$F$ 的大小待求。",
            "Then wedge 1: $R_21 = −R_12$ has been found, and by symmetry $R_31$ is its mirror "
            "image in the line of $F$. The magnitudes of $R_31$ and $F$ are sought.",
        ),
        one,
    )
    apart_one(bench, one, it, -r12)


def _ideal(bench: Bench, device: RingSpring, it: Faces, drive: Quantity) -> Quantity:
    bench.board.section(Words("效率", "Efficiency"))
    lead = Words(
        "设各面无摩擦，反力都沿法线，同样作力多边形。",
        "Without friction the reactions lie along the normals; the polygons are drawn in the same way. ",
    )
    ends = _polygon(bench, device, (it.over, it.under), SMOOTH, lead)
    bench.board.step(
        Words(
            "量得 $F_0$。压缩行程的效率等于理想驱动力与实际驱动力之比；由 $F_0 = Q cot α$ 可用公式核对。",
            "Measure $F_0$. The efficiency of compression is the ratio of the ideal to the "
            "actual driving force; $F_0 = Q cot α$ gives a formula for it.",
        ),
        ends.place,
    )
    ideal = bench.measured(IDEAL, ends.place, ends.d, ends.c, "d_0 c_0")
    bench.worked(ETA, ideal / drive)
    return ideal


def _release(bench: Bench, device: RingSpring, it: Faces, phi: Quantity, ideal: Quantity) -> None:
    board = bench.board
    board.section(Words("回弹行程：$Q$ 为驱动力", "Release: $Q$ drives"))
    lead = Words(
        "回弹时各相对滑动反向，反力都偏到法线的另一侧。",
        "On release all sliding is reversed, and the reactions are turned to the other side of the normals. ",
    )
    ends = _polygon(bench, device, _lines(it, float(nominal(phi.value)), -1), RELEASE, lead)
    board.step(
        Words(
            "量得 $F'$。回弹时 $F'$ 为阻力，效率等于实际阻力与理想阻力之比；以 $−φ$ 代 $φ$ 得 $F' = Q cot(α + φ)$，"
            "用以核对。",
            "Measure $F'$. On release $F'$ is the resistance, and the efficiency is the ratio of "
            "the actual to the ideal resistance; with $−φ$ for $φ$ follows $F' = Q cot(α + φ)$ as "
            "a check.",
        ),
        ends.place,
    )
    hold = signed(bench, HOLD, ends.place, (ends.d, ends.c), -1j, "d' c'")
    bench.worked(ETA_BACK, hold / ideal)
    if float(nominal(hold.value)) <= 1e-9 * device.Q.si:
        board.remark(
            Words(
                "$F' ≤ 0$，$η' ≤ 0$：回弹行程自锁，弹簧不能把楔块 1 顶回。",
                " With $F' ≤ 0$ and $η' ≤ 0$ the release is self-locking: the springs do not push wedge 1 back.",
            )
        )


def _polygon(bench: Bench, device: RingSpring, along: tuple[Points, Points], stroke: Stroke, lead: Words) -> Corners:
    """Q = ab, R_12 = bc, R_42 = ca; R_31 = bd, F = dc: Q, R_12, R_42 close on wedge 2; −R_12, R_31 and the force on
    wedge 1 are joined to them at the common side."""
    board, place = bench.board, bench.board.open_pane(View.FORCE, stroke.drive.key, stroke.title)
    by_1, by_4, on_1, by_3 = (stroke.force(force) for force in (R12, R42, R21, R31))
    drive, lean, tips, (r12, r42) = stroke.drive, stroke.lean, stroke.corners(), along
    board.step(
        lead
        + Words(
            f"按 $μ_F$ 作楔块 2 的力多边形：$ab$ 代表 $Q$，过 $b$ 作 ${by_1.symbol}$ 的方向线，"
            f"过 $a$ 作 ${by_4.symbol}$ 的方向线，交于 ${tips[0]}$。",
            "Draw the force polygon of wedge 2 to the scale $μ_F$: $ab$ stands for $Q$; "
            f"the direction of ${by_1.symbol}$ through $b$ and that of ${by_4.symbol}$ "
            f"through $a$ meet at ${tips[0]}$.",
        ),
        place,
    )
    terms = given(bench, place, SPRING, device.Q.si, -1 + 0j, "b"), sought(by_1, r12, lean), sought(by_4, r42, lean)
    b, c = driven(bench, place, 0j, terms, device.locked).ends[by_1.key]
    board.step(
        Words(
            f"楔块 1 的力多边形：${tips[0]}$$b$ 即 ${on_1.symbol}$；过 $b$ 作 ${by_3.symbol}$ 的方向线，"
            f"过 ${tips[0]}$ 作 ${drive.symbol}$ 的方向线，交于 ${tips[1]}$。",
            f"In the polygon of wedge 1 ${tips[0]}$$b$ is ${on_1.symbol}$; the direction of "
            f"${by_3.symbol}$ through $b$ and that of ${drive.symbol}$ through ${tips[0]}$ meet at "
            f"${tips[1]}$.",
        ),
        place,
    )
    terms = drawn(on_1, b - c), sought(by_3, np.conj(r12), lean), sought(drive, -1j, VERTICAL)
    _, d = driven(bench, place, c, terms, device.locked, must_press=stroke is PUSH).ends[by_3.key]
    letter(bench, place, {"a": 0j, tips[0]: c, tips[1]: d})
    return Corners(place, 0j, b, c, d)
