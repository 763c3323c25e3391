"""A slider-crank from K and its stroke: A on the circle from which C₁C₂ is seen under θ, at the offset from the "
"guide."""

from __future__ import annotations

from functools import partial

import numpy as np

from ...algebra.quantity import Quantity
from ...board.paper.marks import Role
from ...designs.quantities import ALPHA_MAX, GAMMA_MIN, OFFSET, STROKE
from ...designs.slider_crank import SliderCrank
from ...designs.verdict import Verdict
from ...plane import Line, Points, foot, nominal, unit
from ...plane.geometry import dot
from ...words import Words
from ..devices.sketches.dimensions import dimension
from .advance import theta_of
from .arc_middle import MIRROR, by_arc
from .dimensions import OVER, UNDER, stroke
from .draft import RIGHT, SHEET, Draft
from .eta import Eta, eta
from .limits.judged import Limits, crank_and_coupler, limits_of, settled
from .linkage import pin, pivot, point, slider
from .pressure import greatest_pressure
from .registry import design_method

CORNER = 3.0  # mm: a right angle has room
_PIVOT = Words("求 $A$ 点和各构件长度", "The point $A$ and the lengths")
_MIDDLE = Words("求 $M$", "finding $M$")
BEYOND, BELOW = 7.0, 4.0  # mm: of the offset beside the circle; of the stroke below it


@design_method(
    SliderCrank,
    title=Words("按行程速比系数 K 设计偏置曲柄滑块机构", "Offset slider-crank from its time ratio K"),
    source="机械原理, synthesis by the coefficient of travel speed variation: inscribed angle over the stroke C1C2",
    example="8-16",
)
def draw_slider_crank(draft: Draft, design: SliderCrank) -> None:
    """θ, the stroke C₁C₂, the circle η, and A on it."""
    board = draft.board
    theta = theta_of(draft, design.K.si)
    draft.shared(STROKE, design.H.si * 1e3)
    circle_of = Words("$A$ 点所在的圆", "The circle of $A$")
    board.section(circle_of if design.theta else Words("滑块的极限位置", "Limit positions of the slider"))
    board.step(
        Words(
            "选 $μ_l$，在导路上截取 $C_{1}C_{2} = H/μ_l$，得滑块的两极限位置。",
            "Choose $μ_l$ and lay off $C_{1}C_{2} = H/μ_l$ on the guide: the limit positions of the slider.",
        ),
        SHEET,
    )
    c1 = pin(draft, "C_1", 0j)
    c2 = pin(draft, "C_2", board.lay_off(c1, 1 + 0j, draft.mm(design.H.si), key="H"))
    board.join(SHEET, c1, c2, Role.CENTRE)
    if design.theta == 0:
        _central(draft, design, (c1, c2))
        return
    circle = eta(draft, (c1, c2), theta, 1)
    stroke(draft, (c1, c2), _below(circle))
    _solution(draft, design, (c1, c2), circle)


def _central(draft: Draft, design: SliderCrank, ends: tuple[Points, Points]) -> None:
    """Without quick return A lies on the guide, BC from the middle of the stroke: AC₁ and AC₂ are BC ∓ AB."""
    board, (c1, c2) = draft.board, ends
    assert design.BC is not None
    board.section(_PIVOT)
    board.step(
        Words(
            "$K = 1$，$θ = 0$，无急回：$A$ 在导路上，$e = 0$。因 $AC_1 = l_BC − l_AB$、$AC_2 = l_BC + l_AB$，"
            "$A$ 到 $C_{1}C_2$ 的中点 $M$ 的距离为 $l_BC$；作 $M$，在导路上截取 $MA = l_{BC}/μ_l$。"
            "（在 $M$ 的另一侧截取得其镜像，所得机构相同。）",
            "With $K = 1$ and $θ = 0$ there is no quick return: $A$ lies on the guide, and $e = 0$. As "
            "$AC_1 = l_BC − l_AB$ and $AC_2 = l_BC + l_AB$, $A$ is $l_BC$ from the midpoint $M$ of $C_{1}C_2$: draw "
            "$M$ and lay off $MA = l_{BC}/μ_l$ on the guide. (On the other side of $M$ it gives the mirror image, the "
            "same linkage.)",
        ),
        SHEET,
    )
    stroke(draft, ends, UNDER)
    m = point(draft, "M", board.meet(board.bisector(SHEET, c1, c2), board.parallel(c1, unit(c2 - c1)), _MIDDLE))
    a = pivot(draft, draft.letter("A"), board.lay_off(m, -unit(c2 - c1), draft.mm(design.BC.si), key="MA"))
    board.join(SHEET, a, c1, Role.CENTRE)
    along = float(nominal(dot(c2 - c1, a - c1) / np.square(np.abs(c2 - c1))))
    verdict = Verdict.ACROSS if 0 <= along <= 1 else Verdict.VALID
    limits = limits_of(a, a, c1, c2, ("A", "C_1", "C_2"))
    slider(draft, (limits.extended, limits.folded), 1 + 0j)
    settled(draft, limits, verdict, partial(_read, design=design), framed=False)


def _below(circle: Eta) -> float:
    """How far below C₁C₂ the stroke stands clear of the circle (mm)."""
    return max(float(nominal(circle.radius)) - complex(nominal(circle.centre)).imag + BELOW, UNDER)


def _solution(draft: Draft, design: SliderCrank, ends: tuple[Points, Points], circle: Eta) -> None:
    """A by what is given beside, and the linkage in both limits."""
    board, (c1, c2) = draft.board, ends
    board.section(_PIVOT)
    if design.e is not None:
        at = _at_offset(draft, circle, c1, draft.mm(design.e.si))
    else:
        length, name = (design.AB, "AB") if design.AB is not None else (design.BC, "BC")
        assert length is not None
        at = next(by_arc(draft, ends, circle, 2 * draft.mm(length.si), name))
    a = pivot(draft, draft.letter("A"), at)
    if circle.flat:
        circle.arc(draft, c1, a)
    base = foot(Line(c1, unit(c2 - c1)), a)
    along = float(nominal(dot(c2 - c1, base - c1) / np.square(np.abs(c2 - c1))))
    verdict = Verdict.ACROSS if 0 <= along <= 1 else Verdict.VALID
    limits = limits_of(a, base, c1, c2, ("A", "C_1", "C_2"))  # the foot of A on the guide in the place of D
    slider(draft, (limits.extended, limits.folded), 1 + 0j)
    settled(draft, limits, verdict, partial(_read, design=design), framed=False)


def _at_offset(draft: Draft, circle: Eta, c1: Points, offset: float) -> Points:
    """Where the parallel to the guide at the distance e meets the circle, on the left."""
    board = draft.board
    board.step(
        Words(
            "在导路上方作与导路相距 $e/μ_l$ 的平行线，与圆 $η$ 相交于 $A$。",
            "Draw the parallel to the guide at the distance $e/μ_l$ above it; it meets the circle $η$ at $A$.",
        ),
        SHEET,
    )
    line = board.parallel(board.lay_off(c1, 1j, offset, key="e"), 1 + 0j, key="A")
    right, left = board.arc_on_line(line, circle.centre, circle.radius, Words("求 $A$", "finding $A$"))
    board.rule(SHEET, Line(right, -line.along), left)
    end, low = complex(nominal(right)) + BEYOND, complex(nominal(c1))
    board.join(SHEET, right, end + OVER, Role.CONSTRUCTION)
    board.join(SHEET, c1, complex(end.real + OVER, low.imag), Role.CENTRE)
    dimension(draft, SHEET, complex(end.real, low.imag), end, "e")
    board.remark(MIRROR)
    return board.either(left)


def _read(draft: Draft, limits: Limits, design: SliderCrank) -> None:
    """l_AB, l_BC by half the difference and half the sum; the offset; the greatest pressure angle."""
    crank, coupler = crank_and_coupler(draft, limits)
    if design.theta == 0:
        offset = draft.shared(OFFSET, np.float64(0.0))
    else:
        offset = _offset(draft, limits) if design.e is None else draft.shared(OFFSET, design.e.si * 1e3)
    found = draft.stated(draft.of_this(ALPHA_MAX), greatest_pressure(draft, crank, coupler, offset))
    draft.worked(draft.of_this(GAMMA_MIN), RIGHT - found)


def _offset(draft: Draft, limits: Limits) -> Quantity:
    """e = μ_l AN, N being the foot of the perpendicular from A on the guide."""
    board, a = draft.board, limits.a
    n = point(draft, "N", limits.d)
    board.join(SHEET, a, n, Role.CONSTRUCTION)
    board.join(SHEET, limits.folded, n, Role.CENTRE)
    if abs(complex(nominal(a - n))) > CORNER:
        board.right_angle(SHEET, n, unit(a - n), unit(limits.folded - n))
    board.remark(
        Words(
            "自 $A$ 向导路作垂线，垂足为 $N$，$AN$ 为偏距。",
            " Point $N$ is the foot of the perpendicular from $A$ on the guide, and $AN$ the offset.",
        )
    )
    return draft.length(draft.of_this(OFFSET), board.measure(a, n, "A N"), "A N")
