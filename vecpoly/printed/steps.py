"""The lines of the steps end with the value that the box of answers and the table have: as many digits, not more."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from math import isfinite, log10

from ..algebra.formula import Node, Row, Txt
from ..answer import YES_NO, Answer
from ..board.construction import Construction, Step
from ..foundation.slotted import replace
from .digits import MOST, coordinates, decimals, rounded
from .places import place_parts
from .units import printed_unit

_NUMBER = re.compile(r"(−?)\d+(?:\.\d+)?(?:×10\^\{−?\d+\})?")  # as `number` writes it
_EQUALS = " = "


def as_printed(construction: Construction, answers: Mapping[str, Answer]) -> tuple[Construction, dict[str, Answer]]:
    """The construction and the answers, every line of an asked quantity ending as that is printed."""
    found, told = list(construction.steps), dict(answers)
    lines = [answer.reading.formula for answer in answers.values()]
    for key, answer in answers.items():
        line = answer.reading.formula
        if not isinstance(line, Row) or (end := printed_end(line, answer)) is None:
            continue
        found = [_rewritten(step, line, end, lines) for step in found]
        formula = Row((*line.items[:-1], end))
        told[key] = replace(answer, reading=replace(answer.reading, formula=formula))
    return replace(construction, steps=tuple(found)), told


def _rewritten(step: Step, asked: Row, end: Txt, others: Sequence[Node | None]) -> Step:
    """The step with this end of the line asked, and of any that evaluates the same again."""

    def alike(line: Node) -> bool:
        again = isinstance(line, Row) and (line.items[0], line.items[-1]) == (asked.items[0], asked.items[-1])
        return line == asked or (again and line not in others)

    lines = tuple(
        Row((*line.items[:-1], end)) if isinstance(line, Row) and alike(line) else line for line in step.formulas
    )
    return step if lines == step.formulas else replace(step, formulas=lines)


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
    places = decimals(answer)
    kept = None if places is None else max(0, places + round(log10(factor / scale)))
    text = rounded(abs(scale * answer.drawn), kept, MOST)
    return f"{found[1] if text != '0' else ''}{text}{part[found.end() :]}"
