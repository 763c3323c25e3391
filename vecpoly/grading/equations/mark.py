"""The marks of ticked equations: what each row earns, and what it takes from the points for lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from ...foundation.slotted import replace
from ...words import Words
from ..compare.outcome import Finding, Outcome
from ..key import AnswerKey, Graded
from ..rules import Rules
from ..sheet import Sheet
from ..told.message import Message, message
from ..told.named import Told
from .row import EquationRow
from .ticks import BLANK, ticks


@dataclass(frozen=True, slots=True, kw_only=True)
class EquationMark:
    """One row: what was written, how it fares, what it earns of what it is worth, and why."""

    row: EquationRow
    raw: str
    outcome: Outcome
    worth: float
    earned: float
    messages: tuple[Message, ...] = ()

    @property
    def title(self) -> Words:
        """Which row of which equation."""
        number = self.row.key.partition("_")[0].removeprefix("eq")
        return Words(f"方程 {number} ", f"equation {number}, ") + self.row.which.words

    def as_json(self) -> dict[str, Any]:
        """Plain data."""
        return {
            "key": self.row.key, "written": self.raw, "outcome": self.outcome.value, "worth": self.worth,
            "points": self.earned, "messages": [one.as_json() for one in self.messages],
        }  # fmt: skip


def paid_by_equations(key: AnswerKey, sheet: Sheet, rules: Rules) -> tuple[AnswerKey, tuple[EquationMark, ...]]:
    """The key without the points that the rows of equations take from its lines, and what these rows earn.

    Rows of a part pay where one of them was filled in, or where numbers alone do not do (`compensatory`).
    """
    filled = {row.block for row in key.equations if not BLANK.fullmatch(sheet.ticks.get(row.key, ""))}
    rows = [row for row in key.equations if row.block in filled or not rules.compensatory]
    marks = tuple(_marked(row, sheet.ticks.get(row.key, ""), rules) for row in rows)
    return replace(key, quantities=tuple(_less(one, key, rows) for one in key.quantities)), marks


def _less(one: Graded, key: AnswerKey, rows: Sequence[EquationRow]) -> Graded:
    taken = sum(row.points for row in rows if row.block == one.block)
    if not taken or not one.points.method:
        return one
    lines = sum(each.points.method for each in key.quantities if each.block == one.block)
    return replace(one, points=replace(one.points, method=one.points.method * (1.0 - taken / lines)))


def _marked(row: EquationRow, raw: str, rules: Rules) -> EquationMark:
    if BLANK.fullmatch(raw):
        return _mark(row, raw, Outcome.BLANK, 0.0, message(Told.BLANK))
    read = ticks(raw, len(row.known))
    if isinstance(read, Words):
        return _mark(row, raw, Outcome.UNREADABLE, 0.0, message(Told.UNREADABLE, raw=raw, why=read))
    wrong = [i for i, (mine, known) in enumerate(zip(read, row.known, strict=True)) if mine is not known]
    said = [_said(row, [i for i in wrong if row.known[i] is known], known=known) for known in (True, False)]
    told = tuple(one for one in said if one is not None)
    if not wrong:
        return _mark(row, raw, Outcome.RIGHT, 1.0, message(Told.RIGHT))
    if len(wrong) == 1:
        return _mark(row, raw, Outcome.CLOSE, rules.close, *told)
    return _mark(row, raw, Outcome.WRONG, 0.0, *told)


def _mark(row: EquationRow, raw: str, outcome: Outcome, share: float, *said: Message) -> EquationMark:
    return EquationMark(row=row, raw=raw, outcome=outcome, worth=row.points, earned=share * row.points, messages=said)


def _said(row: EquationRow, terms: Sequence[int], *, known: bool) -> Message | None:
    if not terms:
        return None
    symbols = [f"${row.symbols[i]}$" for i in terms]
    both = Words("、".join(symbols), ", ".join(symbols))
    return message(Told.TICK_GIVEN if known else Told.TICK_UNKNOWN, terms=both, row=row.which.words)


def only_with_equation(
    findings: Sequence[Finding], key: AnswerKey, paid: AnswerKey, marks: Sequence[EquationMark], rules: Rules
) -> tuple[Finding, ...]:
    """The findings; unless numbers alone do, without the accuracy marks of parts whose equations are not right.

    paid: the key in which lengths that were read have the points of their lines, which are no accuracy marks.
    """
    if rules.compensatory:
        return tuple(findings)
    bad = {one.row.block for one in marks if not one.outcome.is_right}
    return tuple(
        _without(one, key[one.key], paid[one.key]) if key[one.key].block in bad and one.earned.accuracy else one
        for one in findings
    )


def _without(one: Finding, own: Graded, paid: Graded) -> Finding:
    kept = 1.0 - own.points.accuracy / paid.points.accuracy
    if kept == 1.0:
        return one
    earned = replace(one.earned, accuracy=one.earned.accuracy * kept)
    return replace(one, earned=earned, messages=(*one.messages, message(Told.NO_EQUATION)))
