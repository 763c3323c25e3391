"""Every asked quantity is evaluated in the step that yields it, once: symbol = formula = numbers = result."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from ...algebra.formula import Node, Row, Txt, plain, row
from ...algebra.quantity import number
from ...foundation.slotted import replace
from ..acts import Act, Answer, Follow, Gauge, Measure
from ..construction import Reading, Step

_WORKED = 3  # parts of a line at least that tells how its result was found


def evaluated(
    steps: Sequence[Step], acts: Sequence[Act], readings: Mapping[str, Reading]
) -> tuple[tuple[Step, ...], dict[str, Reading]]:
    """The steps with the evaluation of each asked quantity, and the readings with the line that their step has."""
    told, found = list(steps), dict(readings)
    answers = {act.key: act for act in acts if isinstance(act, Answer)}
    lines = [_Line(at, line) for at, step in enumerate(steps) for line in step.formulas]
    for key, reading in readings.items():
        written = _written(lines, reading)
        if written is not None:
            line = in_mm(written.node, reading)
            all_lines = tuple(line if one is written.node else one for one in told[written.step].formulas)
            told[written.step] = replace(told[written.step], formulas=all_lines)
        elif reading.formula is not None and key in answers:
            step, line = _shown_in(steps, acts, answers[key]) - 1, in_mm(_as_another(lines, reading.formula), reading)
            told[step] = _with_line(told[step], line, answers[key].number)
        else:
            continue
        found[key] = replace(reading, formula=line)
    return tuple(told), found


def _with_line(step: Step, line: Node, number: int) -> Step:
    """The step with this line after its others; before the first that goes on with what it finds: h = μ_l h before
    M = R_21 μ_l h. number: of the act that answers."""
    way = _way(line)
    at = next((n for n, other in enumerate(step.formulas) if _goes_on(other, way)), len(step.formulas))
    shown = min((number, *step.written[at:]))
    return replace(
        step,
        formulas=(*step.formulas[:at], line, *step.formulas[at:]),
        written=(*step.written[:at], shown, *step.written[at:]),
    )


def _way(line: Node) -> str:
    """The formula of symbol = formula = numbers = result; nothing of another line."""
    told = plain(line.items[2]) if isinstance(line, Row) and len(line.items) > _WORKED + 1 else ""
    return " ".join(told.split())  # with plain spaces between its factors


def _goes_on(other: Node, way: str) -> bool:
    """Whether its formula has this one, and more, as a factor."""
    theirs = _way(other)
    return bool(way) and theirs != way and f" {way} " in f" {theirs} "


def _shown_in(steps: Sequence[Step], acts: Sequence[Act], answer: Answer) -> int:
    """The step that has the line: that of the table in which it is read; of a length that bears the symbol itself, h,
    that which goes on with it; else the one that yields it."""
    own = answer.head.step
    if steps[own - 1].listing is not None:
        return own
    read = [acts[n] for n in answer.inputs if isinstance(acts[n], Measure) and acts[n].key == answer.key]
    return read[0].head.step if read and steps[read[0].head.step - 1].formulas else yields(acts, answer)


def yields(acts: Sequence[Act], answer: Answer) -> int:
    """The step in which all that an answer rests on stands drawn; reading it off is no step of its own, nor is
    following its vector once more."""
    return max((acts[one].head.step for one in _rests_on(acts, answer)), default=answer.head.step)


def _rests_on(acts: Sequence[Act], act: Act) -> Iterator[int]:
    for one in act.inputs:
        if isinstance(acts[one], Measure | Gauge | Follow):
            yield from _rests_on(acts, acts[one])
        else:
            yield one


def in_mm(line: Node, reading: Reading) -> Node:
    """The line of an asked length ends with mm, as tables give it: h = 0.0008 × 2.4 = 0.00192 m = 1.92 mm."""
    if reading.unit != "m" or not (
        isinstance(line, Row) and isinstance(end := line.items[-1], Txt) and end.text.endswith(" m")
    ):
        return line
    mm = number(1e3 * reading.scalar)
    ends = Txt(f" = {mm} mm" if len(line.items) < _WORKED else f"{end.text} = {mm} mm")
    return Row((*line.items[:-1], ends), line.worked)


@dataclass(frozen=True)
class _Line:
    """A line of a step."""

    step: int
    node: Node

    @cached_property
    def said(self) -> tuple[str, str]:
        """What it evaluates, and the number that it ends with."""
        text = plain(self.node)
        result = text.rsplit(" = ", 1)[-1].split(" ")[0].rstrip("°").lstrip("−")  # senses are told in words
        return text.split(" = ")[0].strip(), result


def _written(lines: Sequence[_Line], reading: Reading) -> _Line | None:
    """The line that evaluates a quantity in a step already, the last one: its own before one that comes to the same."""
    own = next((one for one in reversed(lines) if one.node == reading.formula), None)
    named = (plain(row(reading.symbol)), number(abs(reading.scalar)))
    return own or next((one for one in reversed(lines) if one.said == named), None)


def _as_another(lines: Sequence[_Line], node: Node) -> Node:
    """The line; of what another symbol was found as, R_32 = R_23 = 1004 N, the way to it is not told twice."""
    if not isinstance(node, Row) or len(node.items) <= _WORKED:
        return node
    alike = (one.node for one in lines if isinstance(one.node, Row) and one.node.items[1:] == node.items[1:])
    other = next(alike, None)
    return node if not isinstance(other, Row) else Row((node.items[0], Txt(" = "), other.items[0], node.items[-1]))
