"""The lines of the steps end with the value that the box of answers and the table have: as many digits, not more."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isclose, isfinite
from operator import is_

from ..algebra.formula import Node, Row, Txt, named, sym
from ..algebra.worked import size_of
from ..answer import YES_NO, Answer
from ..board.construction import Construction, Step
from ..foundation.slotted import replace
from .alike import of_both, one_name
from .arcs import arcs_as_told
from .digits import coordinates
from .metres import in_metres
from .places import place_parts
from .told import EQUALS, NUMBER, Told, number_of
from .units import printed_unit


class _Printed:
    """How the lines end, and go on, with the answers as they are told."""

    def __init__(self, lines: Sequence[Row], answers: Mapping[str, Answer]) -> None:
        self.answers = dict(answers)
        self._ends = dict[tuple[Node, Node], Txt]()  # by the symbol of a line and its end as worked
        self._own = dict[int, Txt]()  # by the line itself: what is found in two ways may be read better in one of them
        for answer in answers.values():
            line = answer.reading.formula
            if isinstance(line, Row) and (end := printed_end(line, answer)) is not None:
                self._ends[line.items[0], line.items[-1]] = self._own[id(line)] = end
        names = one_name(answers.values(), lines)
        self._told = Told(answers.values(), names)
        self._learn_equal(lines, names)
        self._told.carry([(line, self._end_of(line)) for line in lines])

    def _learn_equal(self, lines: Sequence[Row], names: Mapping[Node, Node]) -> None:
        """A line of what is an answer by another name ends as that does: R_23 = 997 N beside R_32 = 997 N."""
        asked = (one for one in self.answers.values() if not one.is_place and isfinite(one.drawn) and one.drawn)
        known = {_name(named(one.reading.symbol), names): one for one in asked}
        for line in lines:
            answer = known.get(_name(line.items[0], names)) if line.worked is not None else None
            if answer is None or self._end_of(line) is not None:
                continue
            if isclose(size_of(line), abs(answer.drawn), rel_tol=1e-9) and (end := printed_end(line, answer)):
                self._own[id(line)] = end

    @property
    def strained(self) -> set[str]:
        """The answers that go on with more figures of what was read than a hand writes."""
        return {key for key, one in self.answers.items() if of_both(named(one.reading.symbol)) in self._told.strained}

    def line(self, line: Row) -> Row:
        """The line as it is printed."""
        return self._told.line(line, self._end_of(line))

    def _end_of(self, line: Row) -> Txt | None:
        """Of the line asked, and of any that evaluates the same again; None: its own."""
        return self._own.get(id(line)) or self._ends.get((line.items[0], line.items[-1]))


def _name(symbol: Node, names: Mapping[Node, Node]) -> Node:
    """The symbol by which its number is known."""
    return names.get(of_both(symbol), of_both(symbol))


def as_printed(construction: Construction, answers: Mapping[str, Answer]) -> tuple[Construction, dict[str, Answer]]:
    """The construction and the answers: every line of an asked quantity ends as that is printed, and every line goes on
    with asked quantities as they are printed, as far as its result allows."""
    lines = [line for step in construction.steps for line in step.formulas if isinstance(line, Row)]
    printed = _settled(lines, answers)
    lines += [line for one in answers.values() if isinstance(line := one.reading.formula, Row)]
    once = {id(line): line for line in lines}  # a line asked stands in its step, too
    scales = {sym(one.scale.symbol) for one in construction.figures if one.scale.unit == "m" and one.scale.symbol}
    made = {key: in_metres(printed.line(line), line, scales) for key, line in once.items()}
    steps = tuple(_with_lines(step, made) for step in construction.steps)
    return arcs_as_told(replace(construction, steps=steps)), {
        key: _with_line(one, made) for key, one in printed.answers.items()
    }


def _settled(lines: Sequence[Row], answers: Mapping[str, Answer]) -> _Printed:
    """As they are printed. An answer that lies midway has a figure more where that spares what was read more of them
    than a hand writes: 6.74/10.49 = 0.6425, not 6.74/10.4904 = 0.642."""
    first = _Printed(lines, answers)
    if not (strained := first.strained):
        return first
    second = _Printed(lines, {key: replace(one, finer=1) if key in strained else one for key, one in answers.items()})
    return first if second.strained else second


def _with_line(answer: Answer, made: Mapping[int, Row]) -> Answer:
    line = made.get(id(answer.reading.formula))
    return answer if line is None else replace(answer, reading=replace(answer.reading, formula=line))


def _with_lines(step: Step, made: Mapping[int, Row]) -> Step:
    lines = tuple(made.get(id(line), line) for line in step.formulas)
    return step if all(map(is_, lines, step.formulas)) else replace(step, formulas=lines)


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
