"""Two wedges, 1 lifting 2: the wedge with two unknowns first, then the other; both force polygons share the side
R_12."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ...algebra.formula import Txt
from ...algebra.quantity import Of, Quantity, Sum, Times, magnitude
from ...board.construction import View
from ...devices.wedges import BY_SINES, DRIVE, ETA, ETA_BACK, FACES, HOLD, IDEAL, REACTIONS, Wedges
from ...names import Named, reaction
from ...plane import Points, nominal
from ...words import Words
from .bench import Bench
from .inclined import (
    Press,
    angle,
    balance,
    drawn,
    driven,
    facing,
    friction_angle,
    given,
    leaned,
    letter,
    signed,
    sought,
)
from .registry import device_method
from .sketches.wedges import Shapes, apart_one, apart_two, shapes, sketch
from .strokes import Corners, Stroke, strokes
from .wedges_limits import limits

R12, R32, R31 = REACTIONS
LOAD, R21 = Named("Q", "Q", "N"), reaction("2", "1")
LIFT, SMOOTH, BACK = strokes(DRIVE, IDEAL, HOLD, Words("正行程", "lifting"), Words("反行程", "way back"))
Angles = Mapping[str, Quantity]  # friction angles in degrees, by face


@dataclass(frozen=True, slots=True)
class Lines:
    """Unit vectors: the reactions on 2, 2 and 1, and the normals of the guides they lean from."""

    r12: Points
    r32: Points
    r31: Points
    n32: Points
    n31: Points


@device_method(
    Wedges,
    title=Words("斜面（楔块）机构的力分析", "Forces on a pair of wedges"),
    source="机械原理, friction in wedges: friction angle, force polygon, sine rule",
    example="4-2",
)
def draw_wedges(bench: Bench, device: Wedges) -> None:
    """Sketch, friction angles, wedge 2, wedge 1, sine rule; no friction, the way back, the limits."""
    phi, it = _prepared(bench, device)
    drive = _direct(bench, device, it, phi)
    _by_sines(bench, device, it, phi)
    ideal = _ideal(bench, device, it, drive)
    _back(bench, device, it, phi, ideal)
    limits(bench, it, {face: float(nominal(angle.value)) for face, angle in phi.items()})


def _prepared(bench: Bench, device: Wedges) -> tuple[Angles, Shapes]:
    """The friction angles, then the sketch."""
    board = bench.board
    board.section(Words("摩擦角与简图", "Friction angle and sketch"))
    board.step(
        Words(
            "求摩擦角。总反力与法线成摩擦角，偏向与相对滑动相反的一侧：",
            "The friction angle: a total reaction makes this angle with the normal, turned from "
            "it against the relative sliding:",
        )
    )
    found = {
        device.angle(face).key: friction_angle(
            bench, device.angle(face), device.friction(face), "f" if device.f else f"f_{{{face}}}"
        )
        for face in FACES[: 1 if device.f else 3]
    }
    phi = {face: found[device.angle(face).key] for face in FACES}
    board.step(
        Words(
            "画出机构简图：$F$ 推动楔块 1 沿斜导路前进，使楔块 2 克服 $Q$ 上升，3 为机架。各构件只作平动，"
            "简图只需角度准确，长度不按比例。",
            "Sketch: pushed by $F$, wedge 1 moves up its inclined guide and lifts wedge 2 against "
            "$Q$; 3 is the frame. The bodies only translate, so only the angles of the sketch "
            "matter.",
        ),
        View.MECHANISM,
    )
    plain = shapes(device.alpha.si, device.beta.si, False)
    held = any(_over(plain, _lines(plain, phi, sense)) for sense in (1, -1))
    it = shapes(device.alpha.si, device.beta.si, held)
    sketch(bench, device, it)
    return phi, it


def _over(it: Shapes, lines: Lines) -> bool:
    """Whether wedge 1 is pressed against the upper side of its guide."""
    return float(nominal((lines.n31 / (1j * it.guide)).real)) < 0


def _lines(it: Shapes, phi: Angles, sense: int) -> Lines:
    """Where the reactions point when 2 rises (sense +1) or sinks (−1)."""
    r12 = leaned(it.normal, sense * it.face, phi["12"].value)
    n32, n31 = facing(-1 + 0j, r12), facing(1j * it.guide, -r12)
    return Lines(
        r12, leaned(n32, sense * 1j, phi["23"].value), leaned(n31, sense * it.guide, phi["13"].value), n32, n31
    )


def _direct(bench: Bench, device: Wedges, it: Shapes, phi: Angles) -> Quantity:
    """Both wedges drawn apart, and the polygon of the lifting way."""
    board, lines = bench.board, _lines(it, phi, 1)
    sign = {face: device.angle(face).symbol for face in FACES}
    board.section(Words("正行程：$F$ 为驱动力", "Lifting: $F$ drives"))
    two = board.open_pane(View.BODY, "2", Words("楔块 2 受力图（正行程）", "Free body of wedge 2, lifting"))
    board.step(
        Words(
            "先取楔块 2 为分离体：$Q$ 全知，$R_12$、$R_32$ 只有大小未知，可解（楔块 1 上三力的大小都未知）。"
            f"2 相对 1 沿接触面向上滑动（$v_21$），故 $R_12$ 自法线 $n$ 逆滑动方向偏转 ${sign['12']}$；"
            f"2 相对 3 向上滑动（$v_23$），故 $R_32$ 自法线向下偏转 ${sign['23']}$；三力汇交于一点。",
            "Take wedge 2 first: $Q$ is known, and of $R_12$ and $R_32$ only the magnitudes are "
            "unknown, whereas on wedge 1 the magnitudes of all three forces are. Wedge 2 slides "
            f"up the face of 1 ($v_21$), so $R_12$ is turned from the normal $n$ by ${sign['12']}$ "
            "against that sliding; it slides up along 3 ($v_23$), so $R_32$ is turned down by "
            f"${sign['23']}$; the three forces meet in one point.",
        ),
        two,
    )
    apart_two(
        bench,
        two,
        it,
        Press(
            symbol=R12.symbol,
            at=0j,
            normal=it.normal,
            along=lines.r12,
            angle=sign["12"],
            slides=it.face,
            speed="v_{21}",
        ),
        Press(symbol=R32.symbol, at=0j, normal=lines.n32, along=lines.r32, angle=sign["23"], slides=1j, speed="v_{23}"),
    )
    one = board.open_pane(View.BODY, "1", Words("楔块 1 受力图（正行程）", "Free body of wedge 1, lifting"))
    board.step(
        Words(
            "再取楔块 1 为分离体：$R_21 = −R_12$ 已求得；1 沿导路向前滑动（$v_13$），故 $R_31$ 自法线向后偏转 "
            f"${sign['13']}$；$F$ 沿导路。$R_31$、$F$ 的大小待求。",
            "Then wedge 1: $R_21 = −R_12$ has been found; 1 slides forward along its guide "
            f"($v_13$), so $R_31$ is turned back by ${sign['13']}$; $F$ acts along the guide. The "
            "magnitudes of $R_31$ and $F$ are sought.",
        ),
        one,
    )
    apart_one(
        bench,
        one,
        it,
        Press(
            symbol=R21.symbol,
            at=0j,
            normal=-it.normal,
            along=-lines.r12,
            angle=sign["12"],
            slides=-it.face,
            speed="v_{12}",
        ),
        Press(
            symbol=R31.symbol,
            at=0j,
            normal=lines.n31,
            along=lines.r31,
            angle=sign["13"],
            slides=it.guide,
            speed="v_{13}",
        ),
    )
    if _over(it, lines):
        board.remark(
            Words(
                "这里 $R_21$ 把楔块 1 压向导路的上侧面，$R_31$ 由上侧面作用。",
                " Here $R_21$ presses wedge 1 against the upper side of its guide, from which $R_31$ acts.",
            )
        )
    ends = _polygon(bench, device, it, lines, LIFT, Words.same(""))
    board.step(Words("量各边，乘以 $μ_F$。", "Measure the sides and multiply by $μ_F$."), ends.place)
    bench.measured(R32, ends.place, ends.b, ends.c, "b c")
    bench.measured(R12, ends.place, ends.c, ends.a, "c a")
    bench.measured(R31, ends.place, ends.c, ends.d, "c d")
    return bench.measured(DRIVE, ends.place, ends.d, ends.a, "d a")


def _by_sines(bench: Bench, device: Wedges, it: Shapes, phi: Angles) -> None:
    """The same force by the sine rule in the two triangles of the polygon."""
    bench.board.step(
        Words(
            "用正弦定理核对：由三角形 $abc$ 求 $R_12$，由三角形 $acd$ 求 $F$。",
            "Check by the sine rule: the triangle $abc$ gives $R_12$, the triangle $acd$ gives $F$.",
        )
    )
    lines, one, two, right = _lines(it, phi, 1), *_given_angles(device), Quantity(Txt("90°"), 90.0, "deg")
    high = nominal((lines.n32 * -1).real) > 0
    low = not _over(it, lines)
    load = magnitude("Q", device.Q.si, "N")
    top = bench.board.compute(
        "R_12", load * Of("sin", right + phi["23"]) / Of("sin", _less(two, phi["12"], phi["23"], high)), "N"
    )
    sides = _less(one + two, phi["12"], phi["13"], low)
    bench.worked(BY_SINES, top * Of("sin", sides) / Of("sin", right - phi["13"]))


def _given_angles(device: Wedges) -> tuple[Quantity, Quantity]:
    return angle("α", device.alpha.si), angle("β", device.beta.si)


def _less(whole: Quantity | Sum, one: Quantity, other: Quantity, also: bool) -> Quantity | Sum:
    """An angle less both friction angles: less 2φ where they are the same; where a guide presses from its other face,
    the second is added."""
    if one.node != other.node:
        return whole - one - other if also else whole - one + other
    return whole - Times(2, one) if also else whole


def _ideal(bench: Bench, device: Wedges, it: Shapes, drive: Quantity) -> Quantity:
    """The polygon without friction, and the efficiency."""
    bench.board.section(Words("效率", "Efficiency"))
    lead = Words(
        "设各面无摩擦，反力都沿法线，同样作力多边形。",
        "Without friction the reactions lie along the normals; the polygons are drawn in the same way. ",
    )
    ends = _polygon(bench, device, it, _lines(it, dict.fromkeys(FACES, angle("φ", 0.0)), 1), SMOOTH, lead)
    bench.board.step(
        Words(
            "量得理想驱动力 $F_0$；正行程效率等于理想驱动力与实际驱动力之比。",
            "Measure the ideal driving force $F_0$; the efficiency of lifting is the ratio "
            "of the ideal to the actual driving force.",
        ),
        ends.place,
    )
    ideal = bench.measured(IDEAL, ends.place, ends.d, ends.a, "d_0 a")
    bench.worked(ETA, ideal / drive)
    return ideal


def _back(bench: Bench, device: Wedges, it: Shapes, phi: Angles, ideal: Quantity) -> None:
    """The way back: Q drives, F' holds; every reaction leans to the other side."""
    board = bench.board
    board.section(Words("反行程：$Q$ 为驱动力", "The way back: $Q$ drives"))
    lead = Words(
        "反行程各相对滑动反向，三个总反力都偏到法线的另一侧。",
        "On the way back all sliding is reversed: the three reactions are turned to the other side of their normals. ",
    )
    ends = _polygon(bench, device, it, _lines(it, phi, -1), BACK, lead)
    board.step(
        Words(
            "量得 $F'$，即使楔块 2 匀速下降所需的阻力。反行程效率等于实际阻力与理想阻力之比。",
            "Measure $F'$, the resistance with which wedge 2 sinks steadily. The efficiency is "
            "the ratio of the actual to the ideal resistance.",
        ),
        ends.place,
    )
    hold = signed(bench, HOLD, ends.place, (ends.d, ends.a), it.guide, "d' a")
    bench.worked(ETA_BACK, hold / ideal)
    if float(nominal(hold.value)) <= 0:
        board.remark(
            Words(
                "$F' ≤ 0$，$η' ≤ 0$：去掉 $F$ 后楔块 2 不会下滑，反行程自锁；要退回须反向拉动楔块 1。",
                " $F' ≤ 0$ and $η' ≤ 0$: without $F$ wedge 2 does not sink, the way back is "
                "self-locking; wedge 1 must be pulled out.",
            )
        )


ALONG_GUIDE = Words("∥导路", "∥ guide")


def _polygon(bench: Bench, device: Wedges, it: Shapes, lines: Lines, stroke: Stroke, lead: Words) -> Corners:
    """Q = ab, R_32 = bc, R_12 = ca; R_31 = cd, F = da: Q, R_32, R_12 close on wedge 2; −R_12, R_31 and the force on
    wedge 1 are joined to them at the common side."""
    board, place = bench.board, bench.board.open_pane(View.FORCE, stroke.drive.key, stroke.title)
    by_1, by_3, on_1, under = (stroke.force(force) for force in (R12, R32, R21, R31))
    drive, lean, tips = stroke.drive, stroke.lean, stroke.corners()
    board.step(
        lead
        + Words(
            f"按 $μ_F$ 作楔块 2 的力多边形：$ab$ 代表 $Q$，过 $b$ 作 ${by_3.symbol}$ 的方向线，"
            f"过 $a$ 作 ${by_1.symbol}$ 的方向线，交于 ${tips[0]}$。",
            "Draw the force polygon of wedge 2 to the scale $μ_F$: $ab$ stands for "
            f"$Q$; the direction of ${by_3.symbol}$ through $b$ and that of "
            f"${by_1.symbol}$ through $a$ meet at ${tips[0]}$.",
        ),
        place,
    )
    terms = (
        given(bench, place, LOAD, device.Q.si, -1j, "b"),
        sought(by_3, lines.r32, lean),
        sought(by_1, lines.r12, lean),
    )
    refusal = sum(float(np.degrees(np.arctan(device.friction(face).si))) for face in ("12", "23"))
    b, c = driven(bench, place, 0j, terms, lambda: device.locked(refusal)).ends[by_3.key]
    board.step(
        Words(
            f"楔块 1 的力多边形：$a$${tips[0]}$ 即 ${on_1.symbol}$；过 ${tips[0]}$ 作 ${under.symbol}$ 的方向线，"
            f"过 $a$ 作 ${drive.symbol}$ 的方向线，交于 ${tips[1]}$。",
            f"The polygon of wedge 1: $a$${tips[0]}$ is ${on_1.symbol}$; the direction of "
            f"${under.symbol}$ through ${tips[0]}$ and that of ${drive.symbol}$ through $a$ meet "
            f"at ${tips[1]}$.",
        ),
        place,
    )
    _, d = balance(
        bench, place, 0j, drawn(on_1, c), sought(under, lines.r31, lean), sought(drive, it.guide, ALONG_GUIDE)
    ).ends[under.key]
    letter(bench, place, {"a": 0j, tips[0]: c, tips[1]: d})
    return Corners(place, 0j, b, c, d)
