"""Limit positions of given linkages: crank and coupler in one line, folded and stretched; θ, K, swing or stroke."""

from __future__ import annotations

from ....algebra.quantity import Quantity
from ....board.paper.marks import Role
from ....designs.limits_found import CrankRockerLimits, SliderCrankLimits
from ....designs.quantities import AB, AD, ALPHA_MAX, BC, CD, GAMMA_MIN, OFFSET, STROKE, SWING, THETA
from ....designs.quantities import K as ADVANCE
from ....designs.verdict import Verdict
from ....names import Named
from ....plane import Points, Reals, ahead, unit
from ....words import Words
from ..angles import found
from ..dimensions import stroke
from ..draft import HALF_TURN, RIGHT, SHEET, Draft
from ..linkage import crank_circle, drawn, pin, pivot, slider
from ..pressure import greatest_pressure
from ..registry import design_method
from ..transmission import least_angle

SOURCE = "机械原理, limit positions: crank and coupler in one line"

_SWINGS = Words(
    "$∠C_{1}DC_{2}$ 即摇杆的摆角 $ψ$，量得：", "and $∠C_{1}DC_{2}$ is the swing $ψ$ of the rocker; read them:"
)
_SLIDES = Words("$C_{1}C_{2}$ 即滑块的行程 $H$，量得：", "and $C_{1}C_{2}$ is the stroke $H$ of the slider; read them:")


_PINS = Words(
    "$C_1 A$ 的延长线、$AC_2$ 与曲柄销 $B$ 的轨迹圆交于 $B_1$、$B_2$。",
    " The line $C_1 A$ produced and $AC_2$ cut the circle of the crank pin $B$ at $B_1$ and $B_2$.",
)


@design_method(
    CrankRockerLimits,
    title=Words("曲柄摇杆机构的极限位置和急回特性", "Limit positions and quick return of a crank-rocker"),
    source=SOURCE,
    sheet=Words("极限位置", "Limit positions"),
    example="8-3a",
)
def draw_crank_rocker_limits(draft: Draft, design: CrankRockerLimits) -> None:
    """Arcs BC ∓ AB about A meet the circle of C."""
    board = draft.board
    lengths = [_given(draft, named, design) for named in (AB, BC, CD, AD)]
    board.section(Words("极限位置", "Limit positions"))
    board.step(
        Words(
            "选 $μ_l$，画 $A$、$D$，以 $D$ 为圆心、$l_CD/μ_l$ 为半径作 $C$ 的轨迹圆；以 $A$ 为圆心，分别以 "
            "$(l_BC − l_AB)/μ_l$、$(l_BC + l_AB)/μ_l$ 为半径作弧，与该圆相交于 $C_1$、$C_2$，即摇杆的两极限位置。",
            "Choose $μ_l$, draw $A$ and $D$ and the circle of $C$ about $D$ with the radius $l_CD/μ_l$. Arcs about "
            "$A$ with "
            "the radii $(l_BC − l_AB)/μ_l$ and $(l_BC + l_AB)/μ_l$ meet it at $C_1$ and $C_2$: the limits of the "
            "rocker.",
        )
        + _PINS,
        SHEET,
    )
    crank, coupler, rocker, frame = (draft.on_paper(one) for one in lengths)
    a = pivot(draft, "A", 0j)
    d = pivot(draft, "D", board.lay_off(a, 1 + 0j, frame, key="AD"))
    ends = [
        pin(draft, f"C_{i}", board.either(board.arcs(a, radius, d, rocker, Words("求极限位置", "the limits"))[0]))
        for i, radius in ((1, coupler - crank), (2, coupler + crank))
    ]
    board.arc(SHEET, d, rocker, ends[1], ends[0])
    for radius, end in zip((coupler - crank, coupler + crank), ends, strict=True):
        board.swing(SHEET, a, radius, end)
    b1, b2 = _cranks(draft, a, (ends[0], ends[1]), crank)
    drawn(draft, (a, b2, ends[1], d), (a, b1, ends[0], d))
    _advance(draft, a, (ends[0], ends[1]), _SWINGS)
    draft.stated(draft.of_this(SWING), draft.angle(d, ends[0], ends[1]))
    found(draft, SWING, d, (ends[0], ends[1]))
    least_angle(draft, lengths[0], lengths[1])
    draft.candidate(Verdict.VALID, (crank, coupler, frame, 0.0), A=a, D=d, B1=b1, C1=ends[0], B2=b2, C2=ends[1])


@design_method(
    SliderCrankLimits,
    title=Words("曲柄滑块机构的极限位置和急回特性", "Limit positions and quick return of a slider-crank"),
    source=SOURCE,
    sheet=Words("极限位置", "Limit positions"),
    example="8-3b",
)
def draw_slider_crank_limits(draft: Draft, design: SliderCrankLimits) -> None:
    """Arcs BC ∓ AB about A meet the guide."""
    board = draft.board
    lengths = [_given(draft, named, design) for named in (AB, BC)]
    offset = draft.shared(OFFSET, design.offset * 1e3)
    board.section(Words("极限位置", "Limit positions"))
    board.step(
        Words(
            "选 $μ_l$，画 $A$ 和导路；以 $A$ 为圆心，分别以 $(l_BC − l_AB)/μ_l$、$(l_BC + l_AB)/μ_l$ 为半径作弧，"
            "与导路相交于 $C_1$、$C_2$，即滑块的两极限位置。",
            "Choose $μ_l$, draw $A$ and the guide. Arcs about $A$ with the radii $(l_BC − l_AB)/μ_l$ and "
            "$(l_BC + l_AB)/μ_l$ meet the guide at $C_1$ and $C_2$: the limits of the slider.",
        )
        + _PINS,
        SHEET,
    )
    crank, coupler = (draft.on_paper(one) for one in lengths)
    a = pivot(draft, "A", 0j)
    guide = board.parallel(board.lay_off(a, -1j, draft.mm(design.offset)), 1 + 0j)
    ends = [
        pin(draft, f"C_{i}", board.either(board.arc_on_line(guide, a, radius, Words("求极限位置", "the limits"))[0]))
        for i, radius in ((1, coupler - crank), (2, coupler + crank))
    ]
    board.join(SHEET, guide.at, ends[1], Role.CENTRE)
    slider(draft, (ends[1], ends[0]), 1 + 0j)
    for radius, end in zip((coupler - crank, coupler + crank), ends, strict=True):
        board.swing(SHEET, a, radius, end)
    b1, b2 = _cranks(draft, a, (ends[0], ends[1]), crank)
    drawn(draft, (a, b2, ends[1]), (a, b1, ends[0]))
    _advance(draft, a, (ends[0], ends[1]), _SLIDES)
    draft.length(draft.of_this(STROKE), board.measure(ends[0], ends[1], "C_1 C_2"), "C_1 C_2")
    stroke(draft, (ends[0], ends[1]))
    alpha = draft.stated(draft.of_this(ALPHA_MAX), greatest_pressure(draft, lengths[0], lengths[1], offset))
    draft.worked(draft.of_this(GAMMA_MIN), RIGHT - alpha)
    draft.candidate(Verdict.VALID, (crank, coupler, offset.value, 0.0), A=a, B1=b1, C1=ends[0], B2=b2, C2=ends[1])


def _given(draft: Draft, named: Named, design: CrankRockerLimits | SliderCrankLimits) -> Quantity:
    """A given length, as a factor of formulas (mm)."""
    return draft.shared(named, draft.board.given(getattr(design, named.key).si, named.key) * 1e3)


def _cranks(draft: Draft, a: Points, ends: tuple[Points, Points], crank: Reals) -> tuple[Points, Points]:
    """B in both limits: beyond A, and towards C₂; the circle of B."""
    crank_circle(draft, a, crank)
    b1 = pin(draft, "B_1", ahead(a, unit(ends[0] - a), -crank))
    return b1, pin(draft, "B_2", ahead(a, unit(ends[1] - a), crank))


def _advance(draft: Draft, a: Points, ends: tuple[Points, Points], other: Words) -> None:
    """θ = ∠C₁AC₂ by protractor, K = (180° + θ) / (180° − θ); other: what else is read between the limits."""
    between = Words(
        "两极限位置时连杆线 $AC_1$、$AC_2$ 的夹角即极位夹角 $θ$，",
        "The angle between $AC_1$ and $AC_2$, the coupler's lines in both limits, is $θ$, ",
    )
    draft.board.step(between + other, SHEET)
    theta = draft.stated(draft.of_this(THETA), draft.angle(a, ends[0], ends[1]))
    found(draft, THETA, a, ends)
    draft.worked(draft.of_this(ADVANCE), (HALF_TURN + theta) / (HALF_TURN - theta))
