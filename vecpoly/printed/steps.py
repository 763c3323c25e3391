"""The lines of the steps end with the value that the box of answers and the table have: as many digits, not more."""

from __future__ import annotations

import re
from collections.abc import Mapping
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
    told, ends, again = dict(answers), dict[Node, Row](), dict[tuple[Node, Node], Txt]()
    for key, answer in answers.items():
        line = answer.reading.formula
        if not isinstance(line, Row) or (end := printed_end(line, answer)) is None:
            continue
        ends[line] = _ended(line, end)
        again[line.items[0], line.items[-1]] = end
        told[key] = replace(answer, reading=replace(answer.reading, formula=ends[line]))
    own = {answer.reading.formula for answer in answers.values()}

    def printed(line: Node) -> Node:
        """The line asked, and any that evaluates the same again, with its end."""
        if line in own or not isinstance(line, Row):
            return ends.get(line, line)
        end = again.get((line.items[0], line.items[-1]))
        return line if end is None else _ended(line, end)

    steps = (_with_lines(step, tuple(map(printed, step.formulas))) for step in construction.steps)
    return replace(construction, steps=tuple(steps)), told


def _ended(line: Row, end: Txt) -> Row:
    return Row((*line.items[:-1], end))


def _with_lines(step: Step, lines: tuple[Node, ...]) -> Step:
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
