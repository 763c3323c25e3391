"""Velocities and accelerations that were read off have their direction by the letters of the polygon: v_E = μ_v pe =
0.168 m/s (p→e)."""

from __future__ import annotations

from ...algebra.formula import Node, Over, Row, Sym, Txt
from ...words import Lang, Words

MOTIONS = (Sym("μ", "v"), Sym("μ", "a"))
FORCES = (Sym("μ", "F"),)
_FORMULA, _WORKED = 2, 6  # of a line symbol = formula = numbers = result
_FROM = Words("（方向 ", " (from "), Words(" → ", " to "), Words("）", ")")


def ends_of(line: Node, scales: tuple[Sym, ...] = MOTIONS) -> tuple[Node, Node] | None:
    """The letters of tail and tip of the only vector that a line reads off by one of these scales, v = μ_v pe; None of
    another line."""
    if not isinstance(line, Row) or len(line.items) != _WORKED:
        return None
    match line.items[_FORMULA]:
        case Row((Sym() as scale, _, Over(Row((tail, tip)), False))) if scale in scales:
            return tail, tip
        case _:
            return None


def pointed(line: Node, lang: Lang) -> Node:
    """The line with the direction of what it reads off behind it; of nothing, as it is."""
    ends = ends_of(line)
    if ends is None or not isinstance(line, Row):
        return line
    first, between, last = (Txt(words.of(lang)) for words in _FROM)
    return Row((*line.items, first, ends[0], between, ends[1], last))
