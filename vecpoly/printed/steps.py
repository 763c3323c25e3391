"""The lines of the steps end with the value that the box of answers and the table have: as many digits, not more."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from math import isclose, isfinite, log10
from typing import cast

from ..algebra.formula import Node, Row, Txt, named
from ..algebra.quantity import Expr
from ..algebra.worked import forms, told_again
from ..answer import YES_NO, Answer
from ..board.construction import Construction, Step
from ..foundation.slotted import replace
from .digits import MOST, coordinates, decimals, rounded
from .places import place_parts
from .units import printed_unit

_NUMBER = re.compile(r"(−?)\d+(?:\.\d+)?(?:×10\^\{−?\d+\})?")  # as `number` writes it
_EQUALS = " = "
_KEPT = 9  # figures by which a value is known again


def as_printed(construction: Construction, answers: Mapping[str, Answer]) -> tuple[Construction, dict[str, Answer]]:
    """The construction and the answers: every line of an asked quantity ends as that is printed, and every line goes on
    with asked quantities as they are printed, as far as its result allows."""
    ends = dict[tuple[Node, Node], Txt]()  # by the symbol of a line and its end as worked
    for answer in answers.values():
        line = answer.reading.formula
        if isinstance(line, Row) and (end := printed_end(line, answer)) is not None:
            ends[line.items[0], line.items[-1]] = end
    every = [line for step in construction.steps for line in step.formulas if isinstance(line, Row)]
    told = Told(answers.values(), [(line, ends.get((line.items[0], line.items[-1]))) for line in every])

    def printed(line: Node) -> Node:
        """The line asked, and any that evaluates the same again, with its end."""
        return told.line(line, ends.get((line.items[0], line.items[-1]))) if isinstance(line, Row) else line

    steps = (_with_lines(step, tuple(map(printed, step.formulas))) for step in construction.steps)
    lines = {key: one.reading.formula for key, one in answers.items()}
    found = {key: printed(line) if line is not None else None for key, line in lines.items()}
    return replace(construction, steps=tuple(steps)), {
        key: replace(one, reading=replace(one.reading, formula=found[key])) if found[key] is not lines[key] else one
        for key, one in answers.items()
    }


class Told:
    """The numbers of asked quantities as they are printed, for lines that go on with them; any other has one form in
    all lines, with the guard figures of that which needs the most."""

    def __init__(self, answers: Iterable[Answer], lines: Iterable[tuple[Row, Txt | None]]) -> None:
        asked = (one for one in answers if not one.is_place and not one.undefined and one.reading.unit != YES_NO)
        self._by_symbol = {named(one.reading.symbol): one for one in asked if isfinite(one.drawn)}
        self._one_form = _one_form(lines)

    def line(self, line: Row, end: Txt | None) -> Row:
        """The line with this end, or with its own; what is not worked out, or goes on with nothing asked, as it is."""
        if end is None and line.worked is None:
            return line
        last = end or line.items[-1]
        number = _result(last)
        if line.worked is None or not isinstance(last, Txt) or not number:
            return Row((*line.items[:-1], last))
        return told_again(line, last, number, self._told)

    def _told(self, symbol: Node, value: float) -> str:
        """The number as its answer is printed; of another as all lines have it; nothing of what stands in one form."""
        answer = self._by_symbol.get(symbol)
        same = answer is not None and isclose(abs(value), abs(answer.drawn), rel_tol=1e-9)
        return (
            _digits(answer, value, 1.0)
            if answer is not None and same
            else self._one_form.get(_known(symbol, value), "")
        )


def _result(last: Node) -> str:
    """The number with which a line ends."""
    if not isinstance(last, Txt) or _EQUALS not in last.text:
        return ""
    found = _NUMBER.match(last.text.split(_EQUALS)[1])
    return found[0] if found else ""


def _known(symbol: Node, value: float) -> tuple[Node, str]:
    """A quantity with its value, by which it is known again."""
    return symbol, f"{value:.{_KEPT}g}"


def _one_form(lines: Iterable[tuple[Row, Txt | None]]) -> dict[tuple[Node, str], str]:
    """The longest number of each quantity that would stand in several forms in these lines."""
    found: dict[tuple[Node, str], set[str]] = {}
    for line, end in lines:
        if line.worked is not None and (shown := _result(end or line.items[-1])):
            for symbol, value, text in forms(cast("Expr", line.worked), shown):
                found.setdefault(_known(symbol, value), set()).add(text)
    return {known: max(texts, key=len) for known, texts in found.items() if len(texts) > 1}


def _with_lines(step: Step, lines: tuple[Node, ...]) -> Step:
    return step if lines == step.formulas and not any(map(_is_open, step.formulas)) else replace(step, formulas=lines)


def _is_open(line: Node) -> bool:
    return isinstance(line, Row) and line.worked is not None


def printed_end(line: Row, answer: Answer) -> Txt | None:
    """The end of a line with the digits of the answer; None of what has none: a question, no number."""
    end, unit = line.items[-1], answer.reading.unit
    if not isinstance(end, Txt) or _EQUALS not in end.text or unit == YES_NO or not isfinite(answer.drawn):
        return None
    if answer.is_place:
        at = answer.drawn_vector
        return None if at is None else Txt(f"{_EQUALS}({', '.join(place_parts(at, coordinates(answer)))}) mm")
    first, *parts = end.text.split(_EQUALS)
    return Txt(_EQUALS.join((first, *(_with_digits(part, answer) for part in parts))))


def _with_digits(part: str, answer: Answer) -> str:
    """A number with its unit, in the unit that is printed or in the SI unit before it; its sign stays."""
    found, unit = _NUMBER.match(part), answer.reading.unit
    if found is None:
        return part
    rest, (factor, printed) = part[found.end() :].strip(), printed_unit(unit)
    scale = {"": 1.0, "°": 1.0, printed: factor, unit: 1.0}.get(rest)
    if scale is None:
        return part
    text = _digits(answer, abs(scale * answer.drawn), scale)
    return f"{found[1] if text != '0' else ''}{text}{part[found.end() :]}"


def _digits(answer: Answer, value: float, scale: float) -> str:
    """A value with the digits of the answer, in a unit of which the SI unit has so many."""
    places, factor = decimals(answer), printed_unit(answer.reading.unit)[0]
    return rounded(value, None if places is None else max(0, places + round(log10(factor / scale))), MOST)
