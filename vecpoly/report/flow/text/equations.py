"""Equations in running text: a short one stands on one line, a longer one is parted behind its equality signs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ....foundation.slotted import replace
from ..cells import Cell, Gap, Kind
from .held import RELATIONS, SIGNS, is_number

LONGEST = 18.0  # em of an equation that is not parted


def whole(cells: Sequence[Cell], gaps: Sequence[Gap], em: float, longest: float = LONGEST) -> list[Gap]:
    """The spaces between the cells, none of which parts a short equation, or two terms of a longer one."""
    out = [*gaps]
    for start, end in _runs(cells):
        wide = sum(cell.box.width for cell in cells[start:end]) + sum(gap.width for gap in gaps[start : end - 1])
        for at in range(start, end - 1):
            if wide <= longest * em or not _may_end(cells[at]):
                out[at] = replace(out[at], breakable=False)
    return out


def _may_end(cell: Cell) -> bool:
    """Whether a line may end with it within a long equation: an equality sign, a piece of a formula that ends so."""
    if cell.kind is Kind.FORMULA:
        return cell.source is not None and cell.source.piece.rstrip()[-1:] in RELATIONS
    return cell.text in RELATIONS


def _runs(cells: Sequence[Cell]) -> Iterator[tuple[int, int]]:
    """Where equations stand: operands with relations and signs between them."""
    start = 0
    for at in range(1, len(cells) + 1):
        if at == len(cells) or not _goes_on(cells[at - 1], cells[at]):
            if at - start > 1:
                yield start, at
            start = at


def _goes_on(before: Cell, after: Cell) -> bool:
    if after.kind is Kind.FORMULA and after.joined:
        return True
    sign = RELATIONS | SIGNS
    return (before.text in sign and _operand(after)) or (after.text in sign and _operand(before))


def _operand(cell: Cell) -> bool:
    return cell.kind is Kind.FORMULA or is_number(cell.text.rstrip("°,.;:，。；、"))
