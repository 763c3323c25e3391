"""Points for a line as drawn belong to its length where that was written down, and else to the value found from it."""

from __future__ import annotations

from dataclasses import replace

from ..key import AnswerKey, Graded, Kind, Points
from ..reading.written import State
from ..sheet import Sheet


def paid_by_length(key: AnswerKey, sheet: Sheet) -> AnswerKey:
    """The key for this sheet: the method points of vectors whose length was read stand with that length."""
    read = {name for name, text in sheet.answers.items() if text.state is not State.BLANK}
    moved = [one for one in key.quantities if _moves(one, read)]
    if not moved:
        return key
    return replace(key, quantities=tuple(_paid(one, moved) for one in key.quantities))


def _moves(one: Graded, read: set[str]) -> bool:
    return one.kind is Kind.VECTOR and one.line in read and one.points.method > 0


def _paid(one: Graded, moved: list[Graded]) -> Graded:
    if one in moved:
        return replace(one, points=replace(one.points, method=0.0))
    extra = sum(vector.points.method for vector in moved if vector.line == one.key)
    if not extra:
        return one
    return replace(one, points=Points(method=one.points.method, accuracy=one.points.accuracy + extra))
