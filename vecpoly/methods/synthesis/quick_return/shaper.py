"""The shaper: its lever swings by θ, its ram's guide lies at the middle of the height of D's arc."""

from __future__ import annotations

from math import pi

import numpy as np

from ....algebra.quantity import Quantity
from ....board.paper.marks import Dot, Role
from ....board.strokes import spot
from ....designs.quantities import AB, AC, ALPHA_MAX, CD, HEIGHT, THETA
from ....designs.quick_return import Shaper
from ....designs.verdict import Verdict
from ....diagram.single import block
from ....plane import Line, Points, foot, nominal, unit
from ....words import Words
from ..advance import theta_of
from ..angles import marked, valued
from ..draft import SHEET, TWO, Draft
from ..linkage import crank_circle, drawn, pin, pivot, point, slider
from ..registry import design_method

UP = 1j
FAR = 40.0  # mm along a bar
ASIDE, PAST = 9.0, 1.5  # mm: the dimension of the guide beside the lever; how far its lines run on


@design_method(
    Shaper,
    title=Words("按 K 和行程设计牛头刨床的导杆机构", "The shaper's crank and lever from K and the stroke"),
    source="机械原理, crank-shaper: the swing of the lever is the angle between the limit positions",
    example="8-17",
)
def draw_shaper(draft: Draft, design: Shaper) -> None:
    """The limit positions of the lever; A; D at both ends of the stroke; the height of the guide."""
    theta = theta_of(draft, design.K.si)
    c, bars = _limits(draft, theta)
    a, b = _crank(draft, design, c, bars)
    ends = _ends(draft, design, c, bars)
    lever = draft.length(draft.of_this(CD), draft.board.measure(c, ends[0], "C D_1"), "C D_1")
    _height(draft, design, c, ends)
    crank_circle(draft, a, np.abs(b[0] - a))
    draft.board.depict(SHEET, block("block", b[1], spot(bars[1].along)))
    for foot_, bar in zip(b, bars, strict=True):
        draft.board.right_angle(SHEET, foot_, unit(a - foot_), bar.along)
    drawn(draft, (a, b[1]), (a, b[0]))
    drawn(draft, (c, ends[1]), (c, ends[0]))
    crank, frame = np.abs(b[0] - a), np.abs(a - c)
    pins = {"A": a, "C": c, "B1": b[0], "B2": b[1], "D1": ends[0], "D2": ends[1]}
    draft.candidate(Verdict.VALID, (crank, lever.value, frame, a.real), **pins)


def _limits(draft: Draft, theta: Quantity) -> tuple[Points, tuple[Line, Line]]:
    board = draft.board
    board.section(Words("导杆的极限位置", "Limit positions of the lever"))
    board.step(
        Words(
            "导杆机构中导杆的摆角等于极位夹角 $θ$。选 $μ_l$，取导杆的摆动中心 $C$，在竖直线两侧各作 $θ/2$ 的射线，"
            "即导杆的两极限位置。",
            "The swing of the lever equals the angle $θ$. Choose $μ_l$ and the pivot $C$ of the lever, and draw a ray "
            "at $θ/2$ on either side of the vertical: the limit positions of the lever.",
        ),
        SHEET,
    )
    c, half = pivot(draft, "C", 0j), theta.value * pi / 360
    bars = board.ray(c, UP, half, key="CD1"), board.ray(c, UP, -half, key="CD2")
    rays = tuple(c + FAR * bar.along for bar in bars)
    marked(draft, c, (rays[0], rays[1]), valued(draft, THETA.symbol, theta.value), key=THETA.key)
    return c, bars


def _crank(draft: Draft, design: Shaper, c: Points, bars: tuple[Line, Line]) -> tuple[Points, tuple[Points, Points]]:
    """A above C, its crank square to the lever in both limits."""
    board = draft.board
    board.section(Words("求曲柄和机架", "Crank and frame"))
    if design.AC is not None:
        board.step(
            Words(
                "在竖直线上截取 $CA = l_AC/μ_l$；自 $A$ 作两极限位置的垂线，垂足 $B_1$、$B_2$，$AB_1$ 即曲柄。",
                "Lay off $CA = l_AC/μ_l$ on the vertical. The perpendiculars from $A$ to the limit positions end at "
                "$B_1$ and $B_2$; $AB_1$ is the crank.",
            ),
            SHEET,
        )
        a = pivot(draft, "A", board.lay_off(c, UP, draft.mm(design.AC.si), key="AC"))
        draft.shared(AC, design.AC.si * 1e3)
    else:
        assert design.AB is not None
        board.step(
            Words(
                "极限位置时曲柄垂直于导杆：作与左极限位置相距 $l_AB/μ_l$ 的平行线，与竖直线相交于 $A$；"
                "自 $A$ 作两极限位置的垂线，垂足 $B_1$、$B_2$。",
                "In its limit positions the lever is perpendicular to the crank: the parallel to its left limit "
                "position at the distance $l_AB/μ_l$ meets the vertical at $A$. The perpendiculars from $A$ to the "
                "limit positions end at $B_1$ and $B_2$.",
            ),
            SHEET,
        )
        side = board.lay_off(c, -1j * bars[0].along, draft.mm(design.AB.si))
        line, axis = board.parallel(side, bars[0].along), board.parallel(c, UP)
        a = pivot(draft, "A", board.meet(line, axis, Words("求 $A$", "finding $A$")))
        board.rule(SHEET, line, a)
        draft.shared(AB, design.AB.si * 1e3)
        draft.length(draft.of_this(AC), board.measure(c, a, "A C"), "A C")
    b1, b2 = (pin(draft, f"B_{i}", _foot(draft, a, bar)) for i, bar in enumerate(bars, 1))
    if design.AC is not None:
        draft.length(draft.of_this(AB), board.measure(a, b1, "A B_1"), "A B_1")
    return a, (b1, b2)


def _foot(draft: Draft, a: Points, bar: Line) -> Points:
    """The foot of the perpendicular from A, by set square."""
    normal = draft.board.parallel(a, unit(foot(bar, a) - a))
    return draft.board.meet(normal, bar, Words("求垂足", "the foot of the perpendicular"))


def _ends(draft: Draft, design: Shaper, c: Points, bars: tuple[Line, Line]) -> tuple[Points, Points]:
    """D in both limits, half the stroke on either side of the vertical."""
    board = draft.board
    board.section(Words("求导杆长", "The lever"))
    board.step(
        Words(
            "在竖直线两侧相距 $H/(2μ_l)$ 作竖直线，与导杆两极限位置相交于 $D_1$、$D_2$，则 $D_{1}D_2 = H/μ_l$。",
            "Draw the verticals at $H/(2μ_l)$ on either side; they meet the limit positions of the lever at $D_1$ and "
            "$D_2$, so that $D_{1}D_2 = H/μ_l$.",
        ),
        SHEET,
    )
    half, found = draft.mm(design.H.si) / 2, []
    for i, (bar, way) in enumerate(zip(bars, (-1, 1), strict=True), 1):
        aside = board.parallel(board.lay_off(c, way + 0j, half, key=f"H{i}" if i == 1 else ""), UP)
        d = pin(draft, f"D_{i}", board.meet(aside, bar, Words(f"求 $D_{i}$", f"finding $D_{i}$")))
        board.rule(SHEET, aside, d)
        found.append(d)
    return found[0], found[1]


def _height(draft: Draft, design: Shaper, c: Points, ends: tuple[Points, Points]) -> None:
    """h = (CM + CN) / 2, N the top of D's arc and M the middle of its chord."""
    board = draft.board
    board.section(Words("滑枕导路的位置", "The guide of the ram"))
    board.step(
        Words(
            "以 $C$ 为圆心作 $D$ 的圆弧，与竖直线交于 $N$；$D_{1}D_2$ 与竖直线交于 $M$。"
            "导路过 $MN$ 的中点时，滑枕的压力角最小。",
            "Draw the arc of $D$ about $C$; it meets the vertical at $N$, and the chord $D_{1}D_2$ meets it at $M$. "
            "With the guide through the middle of $MN$ the pressure angle at the ram is least.",
        ),
        SHEET,
    )
    axis = board.parallel(c, UP)
    top, _ = board.arc_on_line(axis, c, np.abs(ends[0] - c), Words("求 $N$", "finding $N$"))
    board.arc(SHEET, c, np.abs(ends[0] - c), ends[1], ends[0])
    n = point(draft, "N", board.either(top))
    chord = Line(ends[0], unit(ends[1] - ends[0]))
    m = point(draft, "M", board.meet(chord, axis, Words("求 $M$", "finding $M$")))
    board.join(SHEET, *ends, Role.CONSTRUCTION)
    board.rule(SHEET, axis, n)
    upper, lower = board.measure(c, n, "C N"), board.measure(c, m, "C M")
    height = draft.length(draft.of_this(HEIGHT), (upper + lower) / TWO, "h")
    at = board.lay_off(c, UP, height.value * 1e-3 / board.scale_of(SHEET).value)
    _told_height(draft, c, at, ends[0])
    if design.DE is not None:
        _pressure(draft, design.DE.si, at, n)


def _told_height(draft: Draft, c: Points, at: Points, left: Points) -> None:
    """h from C to the guide, on a line of its own beside the lever's left limit."""
    board, aside = draft.board, complex(nominal(left - c)).real - ASIDE
    foot_, top = c + aside, at + aside
    for inner, outer in ((c, foot_), (at, top)):
        board.join(SHEET, inner, outer - PAST, Role.CONSTRUCTION)
    board.arrow(SHEET, foot_, top, Role.CONSTRUCTION)
    board.arrow(SHEET, top, foot_, Role.CONSTRUCTION)
    board.plot(SHEET, (foot_ + top) / 2, HEIGHT.symbol, Dot.NONE)


def _pressure(draft: Draft, rod: float, at: Points, n: Points) -> None:
    """α_max: the rod from N to the guide."""
    board = draft.board
    board.step(
        Words(
            "$D$ 在 $N$ 处时作连杆 $DE$，量它与导路的夹角，即最大压力角。",
            "With $D$ in $N$ draw the rod $DE$ and read its angle to the guide: the maximum pressure angle.",
        ),
        SHEET,
    )
    guide = board.parallel(at, 1 + 0j)
    e, _ = board.arc_on_line(guide, n, draft.mm(rod), Words("求 $E$", "finding $E$"))
    e = pin(draft, "E", board.either(e), Dot.JOINT)
    board.rule(SHEET, guide, e)
    board.join(SHEET, n, e, Role.CONSTRUCTION)
    slider(draft, (e,), 1 + 0j)
    alpha = draft.stated(draft.of_this(ALPHA_MAX), draft.angle(e, at, n))
    marked(draft, e, (at, n), valued(draft, ALPHA_MAX.symbol, alpha.value), key=ALPHA_MAX.key)
