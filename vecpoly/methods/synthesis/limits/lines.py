"""A crank-rocker from the lines of its coupler in both limits: they meet in A; D on the bisector of C₁C₂."""

from __future__ import annotations

from math import pi

from ....designs.limit_lines import LimitLines
from ....designs.quantities import THETA
from ....designs.quantities import K as ADVANCE
from ....plane import Line, Points, ahead, cross, dot, nominal, unit
from ....words import Words
from ..angles import marked
from ..draft import HALF_TURN, SHEET, Draft
from ..linkage import pin, pivot
from ..registry import design_method
from .judged import judged, limits_of, settled

PAST = 15.0  # mm: so far a line that is produced backwards is drawn the other way too
BACKWARDS = Words(
    "交点在此线过 $C_1$ 的反向延长线上。", " The intersection lies on that line produced backwards through $C_1$."
)
SIDES = (("一侧", "on one side"), ("另一侧", "on the other side"))


@design_method(
    LimitLines,
    title=Words("按两极限位置的连杆线设计曲柄摇杆机构", "Crank-rocker from the coupler's lines in its limit positions"),
    source="机械原理, limit positions: crank and coupler in one line, transmission angle at the rocker",
    example="8-5",
)
def draw_limit_lines(draft: Draft, design: LimitLines) -> None:
    """A, θ; then D on either side of the coupler's line."""
    board = draft.board
    board.section(Words("求 $A$ 点", "The point $A$"))
    board.step(
        Words(
            "选 $μ_l$，按给定位置画 $C_1$、$C_2$ 及两极限位置的连杆线。极限位置时曲柄与连杆共线，两线都通过 $A$，"
            "其交点即 $A$；两线的夹角即 $θ$。",
            "Choose $μ_l$, set out $C_1$ and $C_2$ and the lines of the coupler there. In its limits the coupler lies "
            "in "
            "line with the crank, so both pass through $A$ and meet there; the angle between them is $θ$.",
        ),
        SHEET,
    )
    c1, c2 = (pin(draft, f"C_{i}", draft.mm(1.0) * spot.at) for i, spot in ((1, design.C1), (2, design.C2)))
    first, second = (
        board.ray(c, 1 + 0j, board.given(angle.si, f"line_{i}"))
        for i, c, angle in ((1, c1, design.line_1), (2, c2, design.line_2))
    )
    a = pivot(draft, "A", board.meet(first, second, Words("求 $A$", "finding $A$")))
    board.rule(SHEET, first, a)
    board.rule(SHEET, second, a)
    theta = draft.stated(THETA, draft.angle(a, c1, c2))
    draft.worked(ADVANCE, (HALF_TURN + theta) / (HALF_TURN - theta))
    _rockers(draft, design, (a, c1, c2))


def _rockers(draft: Draft, design: LimitLines, pins: tuple[Points, Points, Points]) -> None:
    board, (a, c1, c2) = draft.board, pins
    board.section(Words("求 $D$ 点和各构件长度", "The point $D$ and the lengths"))
    bisector: Line | None = None
    for way, side in zip((1, -1), SIDES, strict=True):
        pin_d = draft.letter("D")
        board.step(
            Words(
                f"${pin_d}$ 在 $C_{{1}}C_2$ 的中垂线上。$C_1$ 处的传动角为 $90° − α_1$：过 $C_1$ 在 $C_{{1}}A$ 的"
                f"{side[0]}作与它成此角的直线，与中垂线相交于 ${pin_d}$。",
                f"Point ${pin_d}$ lies on the bisector of $C_{{1}}C_2$. The transmission angle at $C_1$ is "
                f"$90° − α_1$: draw a line through $C_1$ at this angle to $C_{{1}}A$ {side[1]}; it meets the bisector "
                f"at ${pin_d}$.",
            ),
            SHEET,
        )
        bisector = bisector or board.bisector(SHEET, c1, c2)
        key = "C1D" if way > 0 else ""
        ray = board.ray(c1, unit(a - c1), way * (pi / 2 - board.given(design.alpha_1.si, "alpha_1")), key=key)
        if abs(float(nominal(cross(ray.along, bisector.along)))) < 1e-9:
            board.remark(
                Words("此线与中垂线平行，不相交。", " The line is parallel to the bisector and does not meet it.")
            )
            continue
        d = pivot(draft, pin_d, board.meet(ray, bisector, Words(f"求 ${pin_d}$", f"finding ${pin_d}$")))
        onward = ahead(c1, ray.along, PAST)
        if float(nominal(dot(ray.along, d - c1))) < 0:
            board.remark(BACKWARDS)
            board.rule(SHEET, ray, onward)
        board.rule(SHEET, ray, d)
        marked(draft, c1, (a, onward), "90° − α_1", nth=draft.number - 1)
        board.rule(SHEET, bisector, d)
        settled(draft, limits_of(a, d, c1, c2, ("A", "C_1", "C_2")), judged(a, d, c1, c2))
