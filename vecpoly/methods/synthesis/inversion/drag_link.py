"""A drag link: while DC turns by 180° the crank turns by 360°/(K + 1); B₂ laid over, the bisector meets the ray in
C₁."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import magnitude
from ....board.paper.marks import Role
from ....designs.quantities import AB, AD, BC, CD
from ....designs.quantities import K as ADVANCE
from ....designs.two_positions import DragLink
from ....designs.verdict import Verdict
from ....foundation.bounds import below
from ....plane import Points, cross, nominal
from ....plane.geometry import dot
from ....words import Words
from ..angles import marked, valued
from ..draft import ONE, SHEET, WHOLE_TURN, Draft
from ..linkage import crank_circle, drawn, pin, pivot, point, rejected
from ..registry import design_method
from ..transmission import least_angle

Pair = tuple[Points, Points]


@design_method(
    DragLink,
    title=Words("按行程速比系数 K 设计双曲柄机构", "Drag link from its time ratio K"),
    source="机械原理, inversion: two pairs of positions of a double crank, the driven crank turning by 180°",
    example="drag-link",
)
def draw_drag_link(draft: Draft, design: DragLink) -> None:
    """β, B₁ and B₂; B₂ turned back by 180° about D; C₁."""
    board = draft.board
    draft.shared(ADVANCE, design.K.si)
    for named, length in ((AD, design.AD), (AB, design.AB)):
        draft.shared(named, length.si * 1e3)
    a, d, b1, b2 = _given(draft, design)
    board.section(Words("刚化反转", "Inversion"))
    board.step(
        Words(
            "从动曲柄转过 180°，将位置 2 的图形刚化，绕 $D$ 反转 180°，使 $DC_2$ 与 $DC_1$ 重合，$B_2$ 转到 $B′_2$。"
            "$C_1$ 到 $B_1$、$B′_2$ 等距，故 $B_{1}B′_2$ 的中垂线与给定的射线 $DC_1$ 的交点即 $C_1$。",
            "The driven crank turns by 180°. Regard the figure of position 2 as rigid and turn it back by 180° about "
            "$D$, so that $DC_2$ falls on $DC_1$ and $B_2$ on $B′_2$. Point $C_1$ is as far from $B_1$ as from "
            "$B′_2$, so the bisector of $B_{1}B′_2$ meets the given ray $DC_1$ at $C_1$.",
        ),
        SHEET,
    )
    over = point(draft, "B′_2", d + board.transfer(SHEET, d - b2, "DB2"))
    board.join(SHEET, b2, over, Role.CONSTRUCTION)
    ray = board.ray(d, 1 + 0j, board.given(design.psi_1.si, "psi_1"))
    bisector = board.bisector(SHEET, b1, over)
    c1 = pin(draft, "C_1", board.meet(bisector, ray, Words("求 $C_1$", "finding $C_1$")))
    board.rule(SHEET, bisector, c1)
    c2 = pin(draft, "C_2", d + board.transfer(SHEET, d - c1, ""))
    _solution(draft, (a, d), (b1, c1), (b2, c2), design.psi_1.si)


def _given(draft: Draft, design: DragLink) -> tuple[Points, Points, Points, Points]:
    """A, D and the crank in both positions."""
    board = draft.board
    board.section(Words("主动曲柄的两位置", "The driving crank in both positions"))
    board.step(
        Words(
            "从动曲柄转过 180° 时主动曲柄转过的角度：",
            "While the driven crank turns by 180° the driving one turns through:",
        ),
        SHEET,
    )
    k = magnitude("K", board.given(design.K.si, "K"), "")
    beta = board.compute("β", WHOLE_TURN / (k + ONE), "deg")
    board.step(
        Words(
            "选 $μ_l$，画机架 $AD$ 和主动曲柄的两位置 $AB_1$、$AB_2$，$∠B_{1}AB_2 = β$。",
            "Choose $μ_l$ and draw the frame $AD$ and the driving crank in its two positions $AB_1$ and $AB_2$, "
            "$∠B_{1}AB_2 = β$.",
        ),
        SHEET,
    )
    a = pivot(draft, "A", 0j)
    d = pivot(draft, "D", board.lay_off(a, 1 + 0j, draft.mm(design.AD.si)))
    first = board.ray(a, 1 + 0j, board.given(design.phi_1.si, "phi_1"))
    second = board.ray(a, first.along, np.radians(beta.value), key="AB2")
    b1, b2 = (
        pin(draft, f"B_{i}", board.lay_off(a, ray.along, draft.mm(design.AB.si)))
        for i, ray in ((1, first), (2, second))
    )
    crank_circle(draft, a, np.abs(b1 - a))
    for end in (b1, b2):
        board.join(SHEET, a, end, Role.CONSTRUCTION)
    marked(draft, a, (b1, b2), valued(draft, "β", beta.value), turn=np.radians(beta.value))
    return a, d, b1, b2


def _solution(draft: Draft, frame: Pair, first: Pair, second: Pair, psi: float) -> None:
    """Read BC and CD of what serves."""
    board, (a, d), (b, c) = draft.board, frame, first
    verdict = _judged(frame, first, second, psi)
    drawn(draft, (a, b, c, d), (a, *second, d), verdict=verdict)
    rejected(draft, verdict)
    if verdict is Verdict.VALID:
        crank = magnitude(AB.symbol, board.found[AB.key], "mm")
        coupler = draft.length(draft.of_this(BC), board.measure(b, c, "B_1 C_1"), "B_1 C_1")
        draft.length(draft.of_this(CD), board.measure(c, d, "C_1 D"), "C_1 D")
        least_angle(draft, crank, coupler)
    order = np.abs(b - a), np.abs(c - b), np.abs(d - a), a.real
    draft.candidate(verdict, order, A=a, D=d, B1=b, C1=c, B2=second[0], C2=second[1])


def _judged(frame: Pair, first: Pair, second: Pair, psi: float) -> Verdict:
    """A double crank has the frame as its shortest link, and C on one side of BD; DC₁ points along its ray."""
    a, d, b, c = (complex(nominal(at)) for at in (*frame, *first))
    others = sorted((abs(b - a), abs(c - b), abs(c - d)))
    if not (below(abs(d - a), others[0]) and below(abs(d - a) + others[2], others[0] + others[1])):
        return Verdict.NO_DOUBLE_CRANK
    left = [float(nominal(cross(d - on, off - on))) > 0 for on, off in (first, second)]
    if left[0] != left[1]:
        return Verdict.OTHER_SIDE
    ahead = float(nominal(dot(np.exp(1j * psi), c - d))) > 0
    return Verdict.VALID if ahead else Verdict.REVERSED
