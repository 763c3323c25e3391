"""A pin at given distances from two known ones, in every position: two arcs."""

from __future__ import annotations

from ....board.paper.marks import Role
from ....designs.inversion.plan import Assemble
from ....designs.inversion.refusals import out_of_reach
from ....plane import Points, nominal
from ....words import Words
from ..draft import SHEET
from .sheet import Sheet, lettered


def join(sheet: Sheet, stage: Assemble) -> Sheet:
    """Arcs about both pins; of their meetings the one on the side that is given."""
    board = sheet.draft.board
    board.section(Words(f"铰链 ${stage.pin}$ 的各位置", f"The pin ${stage.pin}$ in all positions"))
    one, two, at = stage.one, stage.two, stage.pin
    radii = f"$l_{{{one}{at}}}$", f"$l_{{{at}{two}}}$"
    zh, en = ("左", "left") if stage.side > 0 else ("右", "right")
    board.step(
        Words(
            f"分别以 ${one}$、${two}$ 的各位置为圆心、{radii[0]}、{radii[1]} 为半径作弧，"
            f"取射线 ${one}{two}$ {zh}侧的交点 ${at}$。",
            f"Arcs about the positions of ${one}$ and ${two}$ with the radii {radii[0]} and {radii[1]} meet at ${at}$, "
            f"to the {en} of the ray ${one}{two}$.",
        ),
        SHEET,
    )
    ends = zip(sheet.pins[stage.one], sheet.pins[stage.two], strict=True)
    return sheet.with_pin(
        stage.pin, lettered(sheet.draft, stage.pin, tuple(_met(sheet, stage, one, two) for one, two in ends))
    )


def _met(sheet: Sheet, stage: Assemble, one: Points, two: Points) -> Points:
    board, draft = sheet.draft.board, sheet.draft
    radii = draft.mm(stage.to_one), draft.mm(stage.to_two)
    apart = abs(complex(nominal(two - one)))
    if not abs(radii[0] - radii[1]) <= apart <= sum(radii):
        raise out_of_reach(stage, apart * board.scale_of(SHEET).value)
    left, right = board.arcs(one, radii[0], two, radii[1], Words(f"求 ${stage.pin}$", f"finding ${stage.pin}$"))
    at = left if stage.side > 0 else right
    for centre, radius in ((one, radii[0]), (two, radii[1])):
        board.swing(SHEET, centre, radius, at)
        board.join(SHEET, centre, at, Role.CONSTRUCTION)
    return at
