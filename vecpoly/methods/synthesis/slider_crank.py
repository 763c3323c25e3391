"""A slider-crank from K and its stroke: A on the circle from which C₁C₂ is seen under θ, at the offset from the "
"guide."""

from __future__ import annotations

import numpy as np

from ...board.paper.marks import Role
from ...designs.quantities import AB, ALPHA_MAX, BC, GAMMA_MIN, OFFSET, STROKE
from ...designs.slider_crank import SliderCrank
from ...designs.verdict import Verdict
from ...plane import Line, Points, foot, nominal, unit
from ...plane.geometry import dot
from ...words import Words
from .advance import theta_of
from .arc_middle import MIRROR, by_arc
from .draft import RIGHT, SHEET, TWO, Draft
from .eta import Eta, eta
from .limits import Limits, limits_of
from .linkage import drawn, pin, pivot, rejected
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
    theta = theta_of(draft, design.K.si)
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
    a = pivot(draft, draft.letter("A"), at)
    base = foot(Line(c1, unit(c2 - c1)), a)
    along = float(nominal(dot(c2 - c1, base - c1) / np.square(np.abs(c2 - c1))))
    verdict = Verdict.ACROSS if 0 <= along <= 1 else Verdict.VALID
    letters = ("A", "C_1", "C_2")
    _settled(draft, design, limits_of(a, base, c1, c2, letters), verdict)


def _settled(draft: Draft, design: SliderCrank, limits: Limits, verdict: Verdict) -> None:
    """The linkage in both limits; of a valid one its lengths. The foot of A on the guide stands in the place of D."""
    a, near, far = limits.a, limits.folded, limits.extended
    crank = (np.abs(far - a) - np.abs(near - a)) / 2
    of_near: Points = a - unit(near - a) * crank
    of_far: Points = a + unit(far - a) * crank
    drawn(draft, (a, of_far, far), (a, of_near, near), verdict=verdict)
    rejected(draft, verdict)
    if verdict is Verdict.VALID:
        numbers = "12" if limits.first else "21"
        of_near, of_far = (
            pin(draft, draft.letter(f"B{i}"), b) for i, b in zip(numbers, (of_near, of_far), strict=True)
        )
        _read(draft, design, limits)
    order = crank, (np.abs(far - a) + np.abs(near - a)) / 2, np.abs(a - limits.d), a.real
    draft.candidate(verdict, order, A=a, B1=of_near, C1=near, B2=of_far, C2=far)


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
    return board.either(left)


def _read(draft: Draft, design: SliderCrank, limits: Limits) -> None:
    """l_AB, l_BC by half the difference and half the sum; the offset; the greatest pressure angle."""
    board, (_, of_near, of_far) = draft.board, limits.letters
    far = board.measure(limits.a, limits.extended, f"A {of_far}")
    near = board.measure(limits.a, limits.folded, f"A {of_near}")
    crank = draft.length(draft.of_this(AB), (far - near) / TWO, "A B")
    coupler = draft.length(draft.of_this(BC), (far + near) / TWO, "B C")
    if design.e is None:
        offset = draft.length(draft.of_this(OFFSET), board.measure(limits.a, limits.d, "A N"), "A N")
    else:
        offset = draft.shared(OFFSET, design.e.si * 1e3)
    found = draft.stated(draft.of_this(ALPHA_MAX), greatest_pressure(draft, crank, coupler, offset))
    draft.worked(draft.of_this(GAMMA_MIN), RIGHT - found)
