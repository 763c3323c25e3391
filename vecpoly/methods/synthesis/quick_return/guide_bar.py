"""Limit positions of an oscillating guide bar: its line touches the circle of the crank pin, and the circle of e."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Quantity
from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....board.strokes import spot
from ....designs.limits_found import GuideBarLimits
from ....designs.quantities import AB, AC, ALPHA_MAX, GAMMA_MIN, OFFSET, SWING, THETA
from ....designs.quantities import K as ADVANCE
from ....designs.verdict import Verdict
from ....diagram.single import block
from ....diagram.single import pivot as ground
from ....plane import Line, Points, Reals, unit
from ....words import Words
from ..angles import marked, valued
from ..draft import HALF_TURN, RIGHT, SHEET, Draft
from ..linkage import crank_circle, drawn, pin, pivot
from ..registry import design_method

UP = 1j
EVEN = 1e-6  # mm: a radius shorter than this is none
BEYOND = 12.0  # mm that the bar goes on beyond B


@design_method(
    GuideBarLimits,
    title=Words("摆动导杆机构的极限位置和急回特性", "Limit positions and quick return of an oscillating guide bar"),
    source="机械原理, limit positions: the crank is square to the guide bar",
    sheet=Words("极限位置", "Limit positions"),
    example="8-3c",
)
def draw_guide_bar_limits(draft: Draft, design: GuideBarLimits) -> None:
    """Tangents to the circle of B and to the circle of e, on opposite sides and on the same; θ, K, α_max."""
    board = draft.board
    for named, value in ((AB, design.AB.si), (AC, design.AC.si), (OFFSET, design.offset)):
        draft.shared(named, value * 1e3)
    crank, offset = draft.mm(design.AB.si), draft.mm(design.offset)
    board.section(Words("极限位置", "Limit positions"))
    board.step(_circles(design), SHEET)
    c = pivot(draft, "C", 0j)
    a = pivot(draft, "A", board.lay_off(c, UP, draft.mm(design.AC.si), key="AC"))
    crank_circle(draft, a, crank)
    if offset:
        board.circle(SHEET, c, offset)
    board.step(_tangents(design), SHEET)
    board.circle(SHEET, (a + c) / 2, np.abs(a - c) / 2)
    one = _limit(draft, (a, c), 1, (crank, crank + offset))
    two = _limit(draft, (a, c), 2, (crank, crank - offset))
    theta = _advance(draft, c, (one, two))
    draft.worked(draft.of_this(SWING), theta)
    _pressure(draft, (crank, offset), np.abs(a - c))
    draft.candidate(Verdict.VALID, (crank, offset, np.abs(a - c), 0.0), A=a, C=c, B1=one[1], B2=two[1])


def _circles(design: GuideBarLimits) -> Words:
    words = Words(
        "选 $μ_l$，画 $A$、$C$，以 $A$ 为圆心、$l_AB/μ_l$ 为半径作 $B$ 的轨迹圆",
        "Choose $μ_l$, draw $A$ and $C$ and the circle of $B$ about $A$ with the radius $l_AB/μ_l$",
    )
    beside = Words(
        "，以 $C$ 为圆心、$e/μ_l$ 为半径作偏距圆，导杆的导路始终与它相切。",
        "; about $C$ the circle with the radius $e/μ_l$, which the line of the guide bar always touches.",
    )
    return words + (beside if design.offset else Words("。", "."))


def _tangents(design: GuideBarLimits) -> Words:
    if not design.offset:
        return Words(
            "极限位置时曲柄垂直于导杆，导杆与 $B$ 的轨迹圆相切：以 $AC$ 为直径作圆，与轨迹圆相交于切点 $B_1$、$B_2$。",
            "In its limits the bar is normal to the crank and touches the circle of $B$: the circle on the diameter "
            "$AC$ meets it in the points of contact $B_1$ and $B_2$.",
        )
    return Words(
        "极限位置时曲柄垂直于导杆，导路是两圆的公切线（一内一外）：以 $AC$ 为直径作圆，以 $A$ 为圆心、"
        "$(l_AB ± e)/μ_l$ 为半径作弧，与该圆相交于 $G_1$、$G_2$；$AG_1$、$AG_2$ 上的 $B_1$、$B_2$ 为切点，"
        "过切点作 $CG_1$、$CG_2$ 的平行线，即导路的两极限位置。",
        "In its limits the bar is normal to the crank, and its line is a common tangent of both circles, once between "
        "them and once beside them: arcs about $A$ with the radii $(l_AB ± e)/μ_l$ meet the circle on the diameter "
        "$AC$ at $G_1$ and $G_2$; on $AG_1$ and $AG_2$ lie the points of contact $B_1$ and $B_2$, and the parallels "
        "through them to $CG_1$ and $CG_2$ are the limit positions of the line.",
    )


def _limit(
    draft: Draft, frame: tuple[Points, Points], number: int, radii: tuple[float, float]
) -> tuple[Points, Points]:
    """G, as far from A as the circles say, and B on AG. radii: of the crank; of the arc, below 0 beyond A."""
    board, (a, c), (crank, arc) = draft.board, frame, radii
    side = (-1 if number == 1 else 1) * (1 if arc >= 0 else -1)  # of CA on which G lies: +1 right
    g: Points = a
    way: Points = np.complex128(1)  # the circles are of one size: the bar is parallel to CA
    if abs(arc) > EVEN:
        both = board.arcs(a, abs(arc), (a + c) / 2, np.abs(a - c) / 2, Words("求切点", "the points of contact"))
        g = board.either(both[0] if side > 0 else both[1])
        board.swing(SHEET, a, abs(arc), g)
        way = unit(g - a) * (1 if arc > 0 else -1)
    b = pin(draft, f"B_{number}", a + way * crank)
    along = board.parallel(b, unit(g - c)).along
    if abs(arc - crank) > EVEN:
        pin(draft, f"G_{number}", g, Dot.POINT)
        board.join(SHEET, c, g, Role.CONSTRUCTION)
        board.join(SHEET, a, g, Role.CONSTRUCTION)
    foot = c + 1j * along * (np.conj(along) * (b - c) * -1j).real
    role = Role.LINK if number == 1 else Role.OTHER
    board.join(SHEET, foot, b + along * BEYOND, role)
    if abs(arc - crank) > EVEN:
        board.join(SHEET, c, foot, role)
    drawn(draft, (a, b)) if number == 1 else drawn(draft, (), (a, b))
    if number == 1:
        board.depict(SHEET, block("block", b, spot(along)))
    return g, b


def _advance(draft: Draft, c: Points, limits: tuple[tuple[Points, Points], tuple[Points, Points]]) -> Quantity:
    """θ = ψ = ∠G₁CG₂ by protractor, K = (180° + θ) / (180° − θ)."""
    draft.board.step(
        Words(
            "导杆的摆角等于极位夹角 $θ$，量两极限位置的夹角得：",
            "The swing of the bar equals the angle $θ$; the angle between both limits is read:",
        ),
        SHEET,
    )
    (g1, _), (g2, _) = limits
    theta = draft.stated(draft.of_this(THETA), draft.angle(c, g1, g2))
    marked(draft, c, (g1, g2), valued(draft, f"{THETA.symbol} = {SWING.symbol}", theta.value), key=THETA.key)
    draft.worked(draft.of_this(ADVANCE), (HALF_TURN + theta) / (HALF_TURN - theta))
    return theta


def _pressure(draft: Draft, radii: tuple[float, float], frame: Reals) -> None:
    """α_max with B nearest to C: between the line of the bar and CB, for v of the bar's point is square to CB."""
    board, (_, offset) = draft.board, radii
    if not offset:
        board.step(
            Words(
                "导路过 $C$，导杆所受的力始终垂直于导杆，与受力点的速度同向：",
                "The line passes through $C$: the force on the bar is always normal to it, as is the velocity:",
            )
        )
        draft.worked(draft.of_this(GAMMA_MIN), RIGHT - draft.stated(draft.of_this(ALPHA_MAX), 0.0 * frame))
        return
    _nearest(draft, radii, frame)


def _nearest(draft: Draft, radii: tuple[float, float], frame: Reals) -> None:
    """The position with B nearest to C, in a figure of its own."""
    board, (crank, offset) = draft.board, radii
    place = board.open_pane(View.MECHANISM, "alpha", Words("最大压力角", "Maximum pressure angle"))
    board.step(
        Words(
            "$B$ 离 $C$ 最近时压力角最大。作此位置：自 $B′$ 作半径为 $e$ 的偏距圆的切线 $B′T$"
            "（以 $CB′$ 为直径作圆求切点 $T$），导杆受力沿其法线，$B′$ 处的速度垂直于 $CB′$，"
            "故 $α$ 等于 $∠CB′T$，量得：",
            "The pressure angle is greatest with $B$ nearest to $C$. Draw this position: the tangent $B′T$ to the "
            "circle of $e$ (its point of contact $T$ lies on the circle on the diameter $CB′$). The force is normal to "
            "the line and the velocity of the bar's point normal to $CB′$, so that $α$ equals $∠CB′T$; it is read:",
        ),
        place,
    )
    c, a = board.locate(place, "C", 0j), board.locate(place, "A", board.lay_off(0j, UP, frame))
    b = board.locate(place, "B′", board.lay_off(a, -UP, crank, key="AB′"))
    board.circle(place, c, offset)
    crank_circle(draft, a, crank, place)
    board.circle(place, (b + c) / 2, np.abs(b - c) / 2)
    touching = board.arcs(c, offset, (b + c) / 2, np.abs(b - c) / 2, Words("求切点 $T$", "the point of contact $T$"))
    t = board.locate(place, "T", board.either(touching[0]))
    line = Line(t, unit(b - t))
    board.join(place, a, b, Role.LINK)
    board.join(place, t, b + line.along * BEYOND, Role.LINK)
    board.join(place, c, t, Role.LINK)
    board.join(place, c, b, Role.CONSTRUCTION)
    board.depict(place, ground(c), ground(a), block("block", b, spot(line.along)))
    for letter, at, dot in (("C", c, Dot.JOINT), ("A", a, Dot.JOINT), ("B′", b, Dot.JOINT), ("T", t, Dot.POINT)):
        board.plot(place, at, letter, dot)
    alpha = draft.stated(draft.of_this(ALPHA_MAX), draft.angle(b, c, t))
    marked(draft, b, (c, t), valued(draft, ALPHA_MAX.symbol, alpha.value), key=ALPHA_MAX.key, place=place)
    draft.worked(draft.of_this(GAMMA_MIN), RIGHT - alpha)
