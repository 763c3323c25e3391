"""The lines of the steps end with the value that the box of answers and the table have: as many digits, not more."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite

from ..algebra.formula import Node, Row, Txt
from ..answer import YES_NO, Answer
from ..board.construction import Construction, Step
from ..foundation.slotted import replace
from .digits import coordinates
from .places import place_parts
from .told import EQUALS, NUMBER, Told, number_of
from .units import printed_unit


def as_printed(construction: Construction, answers: Mapping[str, Answer]) -> tuple[Construction, dict[str, Answer]]:
    """The construction and the answers: every line of an asked quantity ends as that is printed, and every line goes on
    with asked quantities as they are printed, as far as its result allows."""
    ends = dict[tuple[Node, Node], Txt]()  # by the symbol of a line and its end as worked
    for answer in answers.values():
        line = answer.reading.formula
        if isinstance(line, Row) and (end := printed_end(line, answer)) is not None:
            ends[line.items[0], line.items[-1]] = end

    def end_of(line: Row) -> Txt | None:
        """Of the line asked, and of any that evaluates the same again; None: its own."""
        return ends.get((line.items[0], line.items[-1]))

    told = Told(answers.values())
    told.carry([(line, end_of(line)) for step in construction.steps for line in step.formulas if isinstance(line, Row)])

    def printed(line: Node) -> Node:
        return told.line(line, end_of(line)) if isinstance(line, Row) else line

    steps = (_with_lines(step, tuple(map(printed, step.formulas))) for step in construction.steps)
    lines = {key: one.reading.formula for key, one in answers.items()}
    found = {key: printed(line) if line is not None else None for key, line in lines.items()}
    return replace(construction, steps=tuple(steps)), {
        key: replace(one, reading=replace(one.reading, formula=found[key])) if found[key] is not lines[key] else one
        for key, one in answers.items()
    }


def _with_lines(step: Step, lines: tuple[Node, ...]) -> Step:
    return step if lines == step.formulas and not any(map(_is_open, step.formulas)) else replace(step, formulas=lines)


def _is_open(line: Node) -> bool:
    return isinstance(line, Row) and line.worked is not None


def printed_end(line: Row, answer: Answer) -> Txt | None:
    """The end of a line with the digits of the answer; None of what has none: a question, no number."""
    end, unit = line.items[-1], answer.reading.unit
    if not isinstance(end, Txt) or EQUALS not in end.text or unit == YES_NO or not isfinite(answer.drawn):
        return None
    if answer.is_place:
        at = answer.drawn_vector
        return None if at is None else Txt(f"{EQUALS}({', '.join(place_parts(at, coordinates(answer)))}) mm")
    first, *parts = end.text.split(EQUALS)
    return Txt(EQUALS.join((first, *(_with_digits(part, answer) for part in parts))))


def _with_digits(part: str, answer: Answer) -> str:
    """A number with its unit, in the unit that is printed or in the SI unit before it; its sign stays."""
    found, unit = NUMBER.match(part), answer.reading.unit
    if found is None:
        return part
    rest, (factor, printed) = part[found.end() :].strip(), printed_unit(unit)
    scale = {"": 1.0, "°": 1.0, printed: factor, unit: 1.0}.get(rest)
    if scale is None:
        return part
    text = number_of(answer, abs(scale * answer.drawn), scale)
    return f"{found[1] if text != '0' else ''}{text}{part[found.end() :]}"
