"""Two wedges, 1 lifting 2: the wedge with two unknowns first, then the other;
both force polygons share the side R_12."""

from __future__ import annotations

from ....algebra.formula import Txt
from ....algebra.quantity import Of, Quantity, Sum, Times, magnitude
from ....board.construction import View
from ....devices.wedges import BY_SINES, ETA, ETA_BACK, FACES, HOLD, IDEAL, Wedges
from ....plane import nominal
from ....words import Words
from ..bench import Bench
from ..equilibrium import signed
from ..inclined import angle, friction_angle
from ..registry import device_method
from ..sketches.wedges import Shapes, shapes, sketch
from .lifting import lift
from .limits import limits
from .polygon import BACK, SMOOTH, Angles, lines_of, over, polygon


@device_method(
    Wedges,
    title=Words("斜面（楔块）机构的力分析", "Forces on a pair of wedges"),
    source="机械原理, friction in wedges: friction angle, force polygon, sine rule",
    example="4-2",
)
def draw_wedges(bench: Bench, device: Wedges) -> None:
    """Sketch, friction angles, wedge 2, wedge 1, sine rule; no friction, the return stroke, the limits."""
    phi, it = _prepared(bench, device)
    drive = lift(bench, device, it, phi)
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
    held = any(over(plain, lines_of(plain, phi, sense)) for sense in (1, -1))
    it = shapes(device.alpha.si, device.beta.si, held)
    sketch(bench, device, it)
    return phi, it


def _by_sines(bench: Bench, device: Wedges, it: Shapes, phi: Angles) -> None:
    """The same force by the sine rule in the two triangles of the polygon."""
    bench.board.step(
        Words(
            "用正弦定理核对：由三角形 $abc$ 求 $R_12$，由三角形 $acd$ 求 $F$。",
            "Check by the sine rule: the triangle $abc$ gives $R_12$, the triangle $acd$ gives $F$.",
        )
    )
    lines, one, two, right = lines_of(it, phi, 1), *_given_angles(device), Quantity(Txt("90°"), 90.0, "deg")
    high = nominal((lines.n32 * -1).real) > 0
    low = not over(it, lines)
    load = magnitude("Q", device.Q.si, "N")
    top = bench.board.compute(
        "R_12", load * Of("sin", right + phi["23"]) / Of("sin", _less(two, phi["12"], phi["23"], high)), "N"
    )
    sides = _less(one + two, phi["12"], phi["13"], low)
    bench.worked(BY_SINES, top * Of("sin", sides) / Of("sin", right - phi["13"]))


def _given_angles(device: Wedges) -> tuple[Quantity, Quantity]:
    return angle("α", device.alpha.si), angle("β", device.beta.si)


def _less(whole: Quantity | Sum, one: Quantity, other: Quantity, also: bool) -> Quantity | Sum:
    """An angle less both friction angles: less 2φ where they are the same;
    where a guide presses from its other face, the second is added."""
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
    ends = polygon(bench, device, it, lines_of(it, dict.fromkeys(FACES, angle("φ", 0.0)), 1), SMOOTH, lead)
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
    """Return stroke: Q drives, F' holds; every reaction leans to the other side."""
    board = bench.board
    board.section(Words("反行程：$Q$ 为驱动力", "Return stroke: $Q$ drives"))
    lead = Words(
        "反行程各相对滑动反向，三个总反力都偏到法线的另一侧。",
        "On the return stroke all sliding is reversed: the three reactions are turned to the other side of their "
        "normals. ",
    )
    ends = polygon(bench, device, it, lines_of(it, phi, -1), BACK, lead)
    board.step(
        Words(
            "量得 $F'$，即使楔块 2 匀速下降所需的阻力。反行程效率等于实际阻力与理想阻力之比。",
            "Measure $F'$, the resistance with which wedge 2 sinks uniformly. The efficiency is "
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
                " With $F' ≤ 0$ and $η' ≤ 0$ the return stroke is self-locking: without $F$ wedge 2 does not sink; "
                "wedge 1 must be pulled out.",
            )
        )
