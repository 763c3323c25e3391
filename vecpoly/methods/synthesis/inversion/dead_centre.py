"""A dead centre: the crank is taken as the frame, C₁ laid over; the bisector meets the line AC₂ in B₂."""

from __future__ import annotations

from math import ceil, floor, pi, tau

import numpy as np

from ....board.paper.marks import Role
from ....designs.quantities import AB, AD, BC, CD
from ....designs.two_positions import DeadCentre
from ....designs.verdict import Verdict
from ....foundation.bounds import below
from ....plane import Line, Points, cross, distance, nominal, unit
from ....words import Words
from ..angles import marked, valued
from ..draft import SHEET, Draft
from ..linkage import crank_circle, drawn, pin, pivot, point, rejected
from ..registry import design_method
from .judged import NONE

Pair = tuple[Points, Points]
AXIS = 0.8  # of CD: how far the line AD runs on beyond D, from which ψ counts


@design_method(
    DeadCentre,
    title=Words(
        "按摇杆的一个极限位置（死点）设计四杆机构", "Four-bar with a dead centre in a given position of its rocker"
    ),
    source="机械原理, inversion: the crank taken as the frame, the figure of the first position laid over",
    example="dead-centre",
)
def draw_dead_centre(draft: Draft, design: DeadCentre) -> None:
    """C₁, C₂; C₁ turned with the crank; B₂; B₁."""
    board = draft.board
    a, d, c1, c2 = _given(draft, design)
    board.section(Words("刚化反转", "Inversion"))
    board.step(
        Words(
            "将位置 1 的图形刚化，绕 $A$ 转过 $φ_12$，使 $AB_1$ 与 $AB_2$ 重合，$C_1$ 转到 $C′_1$。$B_2$ 到 $C′_1$ 和 "
            "$C_2$ 等距，"
            "又在极限位置 $A$、$B_2$、$C_2$ 共线，故 $C′_{1}C_2$ 的中垂线与直线 $AC_2$ 的交点即 $B_2$。",
            "Regard the figure of position 1 as rigid and turn it by $φ_12$ about $A$, so that $AB_1$ falls on $AB_2$ "
            "and $C_1$ on $C′_1$. Point $B_2$ is as far from $C′_1$ as from $C_2$, and $A$, $B_2$ and $C_2$ lie in one "
            "line; so the bisector of $C′_{1}C_2$ meets the line $AC_2$ at $B_2$.",
        ),
        SHEET,
    )
    laid = board.ray(a, unit(c1 - a), board.given(design.phi_12.si, "phi_12"), key="C1'")
    over = point(draft, "C′_1", board.lay_off(a, laid.along, np.abs(c1 - a)))
    board.swing(SHEET, a, np.abs(c1 - a), over)
    bisector, line = board.bisector(SHEET, over, c2), Line(a, unit(c2 - a))
    b2 = board.meet(bisector, line, Words("求 $B_2$", "finding $B_2$"))
    board.rule(SHEET, bisector, b2)
    board.rule(SHEET, line, c2)
    b2 = pin(draft, "B_2", b2)
    ahead = unit(b2 - a) if float(nominal(np.abs(b2 - a))) > NONE else line.along  # B₂ may be A
    back = board.ray(a, ahead, -board.given(design.phi_12.si, "phi_12"))
    b1 = pin(draft, "B_1", board.lay_off(a, back.along, np.abs(b2 - a)))
    verdict = _judged((a, d), (b1, c1), (b2, c2), design.phi_12.si)
    drawn(draft, (a, b1, c1, d), (a, b2, c2, d), verdict=verdict)
    crank_circle(draft, a, np.abs(b2 - a))
    told = valued(draft, "φ_{12}", np.degrees(design.phi_12.si))
    marked(draft, a, (b1, b2), told, key="phi_12", turn=design.phi_12.si)
    rejected(draft, verdict)
    if verdict is Verdict.VALID:
        draft.length(draft.of_this(AB), board.measure(a, b2, "A B_2"), "A B_2")
        draft.length(draft.of_this(BC), board.measure(b2, c2, "B_2 C_2"), "B_2 C_2")
    order = distance(a, b2), distance(b2, c2), distance(a, d), a.real
    draft.candidate(verdict, order, A=a, D=d, B1=b1, C1=c1, B2=b2, C2=c2)


def _judged(frame: Pair, first: Pair, second: Pair, turn: float) -> Verdict:
    """A linkage whose links all have a length, with C on the same side of BD all the way from one to the other."""
    if min(float(nominal(np.abs(second[0] - end))) for end in (frame[0], second[1])) < NONE:
        return Verdict.NO_LINK
    sides = [float(nominal(cross(frame[1] - b, c - b))) for b, c in (first, second)]
    if sides[0] * sides[1] <= 0:
        return Verdict.OTHER_SIDE
    return Verdict.VALID if _passes(frame, first, turn) else Verdict.BRANCH


def _passes(frame: Pair, first: Pair, turn: float) -> bool:
    """Whether the dyad BCD spans BD wherever AB comes over the line of the frame on its way: BD is shortest with B on
    AD, longest with B on DA produced."""
    a, d, b, c = (complex(nominal(at)) for at in (*frame, *first))
    crank, reach, gap = abs(b - a), abs(c - b) + abs(d - c), abs(abs(c - b) - abs(d - c))
    start = float(np.angle((b - a) / (d - a)))
    low, high = sorted((start, start + turn))
    near, far = (ceil((low - line) / tau) <= floor((high - line) / tau) for line in (0.0, pi))
    shortest, longest = abs(abs(d - a) - crank), abs(d - a) + crank
    return (not near or below(gap, shortest)) and (not far or below(longest, reach))


def _given(draft: Draft, design: DeadCentre) -> tuple[Points, Points, Points, Points]:
    """A, D and the rocker in both positions."""
    board = draft.board
    board.section(Words("摇杆的两位置", "The rocker in both positions"))
    board.step(
        Words(
            "选 $μ_l$，画机架 $AD$ 和摇杆的两位置 $DC_1$、$DC_2$。",
            "Choose $μ_l$ and draw the frame $AD$ and the rocker in its two positions $DC_1$ and $DC_2$.",
        ),
        SHEET,
    )
    draft.shared(AD, design.AD.si * 1e3)
    draft.shared(CD, design.CD.si * 1e3)
    a = pivot(draft, "A", 0j)
    d = pivot(draft, "D", board.lay_off(a, 1 + 0j, draft.mm(design.AD.si)))
    ends, axis = [], d + draft.mm(design.CD.si) * AXIS
    board.join(SHEET, d, axis, Role.CENTRE)
    for i, psi in ((1, design.psi_1), (2, design.psi_2)):
        ray = board.ray(d, 1 + 0j, board.given(psi.si, f"psi_{i}"))
        ends.append(pin(draft, f"C_{i}", board.lay_off(d, ray.along, draft.mm(design.CD.si))))
        board.join(SHEET, d, ends[-1], Role.CONSTRUCTION)
        told = valued(draft, f"ψ_{i}", np.degrees(psi.si))
        marked(draft, d, (axis, ends[-1]), told, key=f"psi_{i}", nth=i - 1, turn=psi.si)
    return a, d, ends[0], ends[1]
