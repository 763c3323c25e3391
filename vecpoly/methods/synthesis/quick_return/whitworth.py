"""Whitworth's quick return: the chord through C divides the circle of the crank pin in the ratio K."""

from __future__ import annotations

from math import pi

import numpy as np

from ....algebra.quantity import Quantity, magnitude
from ....board.paper.marks import Role
from ....designs.quantities import AB, AC, CD, THETA
from ....designs.quick_return import Whitworth
from ....designs.verdict import Verdict
from ....diagram.single import block
from ....plane import Line, Points, unit
from ....words import Words
from ..advance import theta_of
from ..angles import marked, valued
from ..draft import ONE, SHEET, TWO, WHOLE_TURN, Draft
from ..linkage import crank_circle, drawn, pin, pivot
from ..registry import design_method

DOWN = -1j
BACK = 25.0  # mm of the line of AB₁ beyond A


@design_method(
    Whitworth,
    title=Words("按 K 和行程设计转动导杆机构", "Whitworth's quick return from K and the stroke"),
    source="机械原理, rotating guide bar: the stroke line through C cuts the crank circle in the ratio K",
    example="whitworth-by-K",
)
def draw_whitworth(draft: Draft, design: Whitworth) -> None:
    """The sector of the quick stroke, its chord, C on it; the arm CD is half the stroke."""
    theta_of(draft, design.K.si)
    board = draft.board
    board.section(Words("曲柄圆的分割", "Dividing the crank circle"))
    board.step(
        Words(
            "滑块导路过 $C$ 且垂直于 $AC$，导杆与导路重合时滑块在极限位置，此时 $B$ 在导路上；快行程中曲柄转过：",
            "The slider runs on the line through $C$ perpendicular to $AC$. It is in its limit positions when the bar "
            "lies along that line, and $B$ is then on the line, too. During the quick stroke the crank turns through:",
        ),
        SHEET,
    )
    k = magnitude("K", board.given(design.K.si, "K"), "")
    beta = board.compute("β", WHOLE_TURN / (k + ONE), "deg")
    a, c, ends = _crank_circle(draft, design, beta)
    _arm(draft, design, c)
    _read(draft, design, a, c, ends[0])
    board.join(SHEET, *ends, Role.CENTRE)
    board.depict(SHEET, block("block", ends[1], 1 + 0j))
    drawn(draft, (a, ends[1]), (a, ends[0]), (c, ends[0]))
    drawn(draft, (c, ends[1]))
    marked(draft, a, ends, valued(draft, "β", beta.value))
    back = a + BACK * unit(a - ends[0])
    board.join(SHEET, a, back, Role.CONSTRUCTION)
    marked(draft, a, (ends[1], back), valued(draft, THETA.symbol, board.found[THETA.key]), key=THETA.key)
    order = np.abs(ends[0] - a), draft.mm(design.H.si) / 2, np.abs(a - c), a.real
    draft.candidate(Verdict.VALID, order, A=a, C=c, B1=ends[0], B2=ends[1])


def _crank_circle(draft: Draft, design: Whitworth, beta: Quantity) -> tuple[Points, Points, tuple[Points, Points]]:
    """A, C and B in both limits: the rays at β/2 to AC, as far as the circle of AB or the line through C."""
    board, half = draft.board, beta.value * pi / 360
    a, what = pivot(draft, "A", 0j), Words("求 $B$", "finding $B$")
    rays = [board.ray(a, DOWN, way * half, key=f"AB{i}") for i, way in ((1, -1), (2, 1))]
    if design.AB is not None:
        board.step(
            Words(
                "以 $A$ 为圆心、$l_AB/μ_l$ 为半径作曲柄圆，在竖直线两侧各作 $β/2$ 的半径 $AB_1$、$AB_2$；"
                "弦 $B_{1}B_2$ 即导路，与竖直线的交点即 $C$。",
                "Draw the crank circle about $A$ with the radius $l_AB/μ_l$ and its radii $AB_1$ and $AB_2$ at $β/2$ "
                "on "
                "either side of the vertical; the chord $B_{1}B_2$ is the line of the slider and meets the vertical "
                "at $C$.",
            ),
            SHEET,
        )
        b1, b2 = (
            pin(draft, f"B_{i}", board.lay_off(a, ray.along, draft.mm(design.AB.si), key=f"AB{i}"))
            for i, ray in enumerate(rays, 1)
        )
        axis = board.parallel(a, DOWN)
        c = pivot(draft, "C", board.meet(Line(b1, unit(b2 - b1)), axis, Words("求 $C$", "finding $C$")))
    else:
        assert design.AC is not None
        board.step(
            Words(
                "截取 $AC = l_AC/μ_l$，过 $C$ 作 $AC$ 的垂线为导路；在 $AC$ 两侧各作 $β/2$ 的射线，与导路相交于 "
                "$B_1$、$B_2$。",
                "Lay off $AC = l_AC/μ_l$; the line of the slider is perpendicular to $AC$ at $C$. The rays at $β/2$ on "
                "either side of $AC$ meet it at $B_1$ and $B_2$.",
            ),
            SHEET,
        )
        c = pivot(draft, "C", board.lay_off(a, DOWN, draft.mm(design.AC.si), key="AC"))
        line = board.parallel(c, 1 + 0j)
        b1, b2 = (pin(draft, f"B_{i}", board.meet(line, ray, what)) for i, ray in enumerate(rays, 1))
    crank_circle(draft, a, np.abs(b1 - a))
    board.join(SHEET, a, c, Role.CENTRE)
    return a, c, (b1, b2)


def _arm(draft: Draft, design: Whitworth, c: Points) -> None:
    """CD = H/2 on the line of the slider."""
    board = draft.board
    board.step(
        Words(
            "导杆转过 180° 滑块走完行程 $H$，$D$ 为导杆上与连杆铰接的点，故 $l_CD = H/2$：",
            "The slider moves through its stroke $H$ while the bar turns through 180°. Point $D$ is the point of the "
            "bar to which the connecting rod is pinned, so $l_CD = H/2$:",
        ),
        SHEET,
    )
    draft.worked(draft.of_this(CD), magnitude("H", design.H.si * 1e3, "mm") / TWO)
    d = pin(draft, "D", board.lay_off(c, 1 + 0j, draft.mm(design.H.si / 2)))
    board.join(SHEET, c, d, Role.LINK)


def _read(draft: Draft, design: Whitworth, a: Points, c: Points, b: Points) -> None:
    """The length that was not given."""
    if design.AB is not None:
        draft.shared(AB, design.AB.si * 1e3)
        draft.length(draft.of_this(AC), draft.board.measure(a, c, "A C"), "A C")
    else:
        assert design.AC is not None
        draft.shared(AC, design.AC.si * 1e3)
        draft.length(draft.of_this(AB), draft.board.measure(a, b, "A B_1"), "A B_1")
