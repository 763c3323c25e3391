"""A slider-crank from K and its stroke: A on the circle from which C₁C₂ is seen under θ, at the offset from the "
"guide."""

from __future__ import annotations

import numpy as np

from ...algebra.quantity import magnitude
from ...board.paper.marks import Role
from ...designs.quantities import AB, ALPHA_MAX, BC, GAMMA_MIN, OFFSET, STROKE, THETA
from ...designs.quantities import K as ADVANCE
from ...designs.slider_crank import SliderCrank
from ...designs.verdict import Verdict
from ...plane import Line, Points, foot, nominal, unit
from ...plane.geometry import dot
from ...words import Words
from .arc_middle import MIRROR, by_arc
from .draft import HALF_TURN, ONE, RIGHT, SHEET, TWO, Draft
from .eta import Eta, eta
from .linkage import drawn, pin, rejected
from .pressure import greatest_pressure
from .registry import design_method


@design_method(
    SliderCrank,
    title=Words(
        "按行程速比系数 K 设计偏置曲柄滑块机构", "Offset slider-crank from the coefficient K of its quick return"
    ),
    source="机械原理, synthesis by the coefficient of travel speed variation: inscribed angle over the stroke C1C2",
    example="8-16",
)
def draw_slider_crank(draft: Draft, design: SliderCrank) -> None:
    """θ, the stroke C₁C₂, the circle η, and A on it."""
    board = draft.board
    board.section(Words("极位夹角", "Angle between the limit positions"))
    board.step(
        Words("由行程速比系数 $K$ 求极位夹角：", "The angle between the limit positions, from the coefficient $K$:"),
        SHEET,
    )
    k = magnitude("K", board.given(design.K.si, "K"), "")
    theta = draft.worked(THETA, HALF_TURN * (k - ONE) / (k + ONE))
    draft.shared(ADVANCE, design.K.si)
    draft.shared(STROKE, design.H.si * 1e3)
    board.section(Words("$A$ 点所在的圆", "The circle of $A$"))
    board.step(
        Words(
            "选 $μ_l$，在导路上量取 $C_{1}C_{2} = H/μ_l$，得滑块的两极限位置。",
            "Choose $μ_l$ and lay off $C_{1}C_{2} = H/μ_l$ on the guide: the limit positions of the slider.",
        ),
        SHEET,
    )
    c1 = pin(draft, "C_1", 0j)
    c2 = pin(draft, "C_2", board.lay_off(c1, 1 + 0j, draft.mm(design.H.si), key="H"))
    board.join(SHEET, c1, c2, Role.CENTRE)
    _solution(draft, design, (c1, c2), eta(draft, (c1, c2), theta, 1))


def _solution(draft: Draft, design: SliderCrank, ends: tuple[Points, Points], circle: Eta) -> None:
    """A by what is given beside, and the linkage in both limits."""
    board, (c1, c2) = draft.board, ends
    board.section(Words("求 $A$ 点和各构件长度", "The point $A$ and the lengths"))
    if design.e is not None:
        at = _at_offset(draft, circle, c1, draft.mm(design.e.si))
    else:
        length, name = (design.AB, "AB") if design.AB is not None else (design.BC, "BC")
        assert length is not None
        at = next(by_arc(draft, ends, circle, 2 * draft.mm(length.si), name))
    a = pin(draft, draft.letter("A"), at)
    crank = (np.abs(c2 - a) - np.abs(c1 - a)) / 2
    coupler = (np.abs(c2 - a) + np.abs(c1 - a)) / 2
    base = foot(Line(c1, unit(c2 - c1)), a)
    offset = np.abs(a - base)
    b1: Points = a - unit(c1 - a) * crank
    b2: Points = a + unit(c2 - a) * crank
    verdict = Verdict.VALID if float(nominal(dot(c2 - c1, base - c1))) < 0 else Verdict.ACROSS
    drawn(draft, (a, b2, c2), (a, b1, c1), verdict=verdict)
    rejected(draft, verdict)
    if verdict is Verdict.VALID:
        b1, b2 = pin(draft, draft.letter("B1"), b1), pin(draft, draft.letter("B2"), b2)
        _read(draft, design, (a, base, c1, c2))
    draft.candidate(verdict, (crank, coupler, offset, a.real), A=a, B1=b1, C1=c1, B2=b2, C2=c2)


def _at_offset(draft: Draft, circle: Eta, c1: Points, offset: float) -> Points:
    """Where the parallel to the guide at the distance e meets the circle, on the left."""
    board = draft.board
    board.step(
        Words(
            "在导路上方作与导路相距 $e/μ_l$ 的平行线，与圆 $η$ 相交于 $A$。",
            "Draw the parallel to the guide at the distance $e/μ_l$ above it; it meets the circle $η$ in $A$.",
        ),
        SHEET,
    )
    line = board.parallel(board.lay_off(c1, 1j, offset, key="e"), 1 + 0j, key="A")
    right, left = board.arc_on_line(line, circle.centre, circle.radius, Words("求 $A$", "finding $A$"))
    board.rule(SHEET, Line(right, -line.along), left)
    board.remark(MIRROR)
    return left


def _read(draft: Draft, design: SliderCrank, pins: tuple[Points, Points, Points, Points]) -> None:
    """l_AB, l_BC by half the difference and half the sum; the offset; the greatest pressure angle."""
    board, (a, base, c1, c2) = draft.board, pins
    far, near = board.measure(a, c2, "A C_2"), board.measure(a, c1, "A C_1")
    crank = draft.length(draft.of_this(AB), (far - near) / TWO, "A B")
    coupler = draft.length(draft.of_this(BC), (far + near) / TWO, "B C")
    if design.e is None:
        offset = draft.length(draft.of_this(OFFSET), board.measure(a, base, "A N"), "A N")
    else:
        offset = draft.shared(OFFSET, design.e.si * 1e3)
    alpha = greatest_pressure(draft, crank, coupler, offset)
    found = draft.stated(draft.of_this(ALPHA_MAX), alpha)
    draft.worked(draft.of_this(GAMMA_MIN), RIGHT - found)
