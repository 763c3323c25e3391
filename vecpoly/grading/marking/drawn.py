"""Points for a line as drawn belong to its length where that was written down, and else to the value found from it."""

from __future__ import annotations

from collections.abc import Mapping

from ...foundation.slotted import replace
from ..key import AnswerKey, Graded, Kind, Points
from ..reading.written import State
from ..rules import Rules
from ..sheet import Sheet


def paid_by_length(key: AnswerKey, sheet: Sheet, rules: Rules) -> AnswerKey:
    """The key for this sheet: the method points of vectors whose length was read stand with that length; what a wrong
    direction costs of them stays with the vector, where one was written."""
    read = {name for name, text in sheet.answers.items() if text.state is not State.BLANK}
    pointing = {name for name in read if sheet.answers[name].direction is not None}
    kept = {one.key: rules.turned if one.key in pointing else 1.0 for one in key.quantities if _moves(one, read)}
    return replace(key, quantities=tuple(_paid(key, one, kept) for one in key.quantities)) if kept else key


def _moves(one: Graded, read: set[str]) -> bool:
    return one.kind is Kind.VECTOR and one.line in read and one.points.method > 0


def _paid(key: AnswerKey, one: Graded, kept: Mapping[str, float]) -> Graded:
    """kept: of the method points of each such vector what its length is paid."""
    if one.key in kept:
        direction = one.points.method * (1.0 - kept[one.key])
        return replace(one, points=Points(accuracy=one.points.accuracy, sense=one.points.sense + direction))
    extra = sum(key[name].points.method * share for name, share in kept.items() if key[name].line == one.key)
    if not extra:
        return one
    return replace(one, points=Points(method=one.points.method, accuracy=one.points.accuracy + extra))
