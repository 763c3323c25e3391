"""One answer as it is listed, made from the reading in the ledger: v_F = μ_v·31.9 mm = 0.319 m/s (←)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import degrees, isclose

from ...algebra.formula import Node, Row, Txt, row, split_words
from ...printed.angles import bearing_told
from ...printed.digits import LEAST, coordinates, drawn_number, in_percent, is_hopeless, on_paper
from ...printed.places import place_parts
from ...printed.units import printed_unit
from ...problem.problem import Problem
from ...solution import YES_NO, Answer, Solution, told_short
from ...words import Lang, Words
from ..values import (
    called,
    class_told,
    counted_from,
    direction_of_load,
    is_class,
    is_efficiency,
    is_worded,
    unit_after,
    value,
)
from .notes import COARSE, INSTEAD, UNREADABLE, error_of, remark_of, stands_still

SQUARE = {"0.0°": "→", "90.0°": "↑", "180.0°": "←", "270.0°": "↓"}
_TURNS = {"ccw": Words("逆时针", "counter-clockwise"), "cw": Words("顺时针", "clockwise")}


@dataclass(frozen=True, slots=True, kw_only=True)
class AnswerLine:
    """What is said of one asked quantity: the line itself; before it, what it is called; after it, what is to be said.

    result: the number with its unit, as the line ends. heading: what stands over its part of the list. also: keys of
    others that are the same.
    """

    key: str
    node: Node
    before: str = ""
    after: str = ""
    result: str = ""
    heading: str = ""
    also: tuple[str, ...] = ()


def answer_line(
    answer: Answer, solution: Solution, lang: Lang, *, heading: str = "", also: Sequence[str] = (), read: bool = True
) -> AnswerLine:
    """The line of one answer; also: the keys of others that are the same; read: with the length on paper."""
    line = short_line(answer, solution, lang, read=read)
    same = [piece for key in also for piece in (Txt(" = "), row(solution.answers[key].reading.symbol))]
    return AnswerLine(
        key=answer.key,
        node=Row((line.items[0], *same, *line.items[1:])) if isinstance(line, Row) and same else line,
        before=_named(answer, lang)[0],
        after=_after(answer, lang),
        result=result_of(answer, lang),
        heading=heading,
        also=tuple(also),
    )


def short_line(answer: Answer, solution: Solution, lang: Lang, *, read: bool = True) -> Node:
    """What came out, without the way to it: v_C = μ_v·65.2 mm = 0.652 m/s (∠67.9°); read: with the length on paper."""
    reading = answer.reading
    _, name, way = _named(answer, lang)
    if answer.is_place and answer.drawn_vector is None and not answer.undefined:
        turn = _way(answer)
        return Row((name, Txt(Words(f" 在无穷远处（{turn}）", f" at infinity ({turn})").of(lang))))
    said = split_words(result_of(answer, lang) + _bracket(answer, solution.problem, way, lang))
    result = [row(piece) if formula else Txt(piece) for formula, piece in said]
    if is_worded(answer.key, answer.reading.unit):
        return Row((*result,))
    parts: tuple[Node, ...] = (name, Txt(" = "))
    if read and is_length_times_scale(answer, solution):
        parts = (*parts, row(reading.scale), Txt(f"·{on_paper(answer)} mm"), Txt(" = "))
    return Row((*parts, *result))


def named_line(answer: Answer, solution: Solution, lang: Lang) -> Node:
    """The same without the length on paper, where nothing stands before it: 静平衡（ΣW = 0）：是."""
    line = short_line(answer, solution, lang, read=False)
    if not is_worded(answer.key, answer.reading.unit):
        return line
    pieces = split_words(_named(answer, lang)[0])
    name = (part for formula, piece in pieces for part in (row(piece).items if formula else (Txt(piece),)))
    return Row((*name, Txt("" if lang == "zh" else " "), line))


def is_length_times_scale(answer: Answer, solution: Solution) -> bool:
    """Whether it is what was measured on paper, and nothing but that times the scale."""
    mm, symbol, unit = answer.reading.mm, answer.reading.scale, answer.reading.unit
    if not mm or not symbol:
        return False
    size = abs(answer.drawn) * (1e-3 if unit == "mm" else 1.0)
    scales = (one.scale for one in solution.construction.figures if one.scale.symbol == symbol)
    return any(isclose(mm * scale.value, size, rel_tol=1e-6) for scale in scales)


def result_of(answer: Answer, lang: Lang) -> str:
    """The number with its unit: as in the table."""
    reading = answer.reading
    if answer.undefined or reading.unit == YES_NO:
        return value(answer.drawn, reading.unit, lang, answer.key)
    if answer.is_place:
        at = answer.drawn_vector
        return f"∞ ({_way(answer)})" if at is None else f"({', '.join(place_parts(at, coordinates(answer)))}) mm"
    if is_class(answer.key):
        return class_told(answer.drawn, lang)
    text = drawn_number(answer)
    if is_efficiency(answer.key, reading.unit) and answer.drawn >= LEAST:
        return f"{text} ({in_percent(text)})"
    return text + unit_after(printed_unit(reading.unit)[1])


def _named(answer: Answer, lang: Lang) -> tuple[str, Node, str]:
    """What stands before the line, its symbol, and by which way the quantity was found."""
    symbol = answer.reading.symbol
    before, _, way = called(symbol, answer.key, lang).partition(f"${symbol}$")
    if is_worded(answer.key, answer.reading.unit):
        return f"{called(symbol, answer.key, lang)}{'：' if lang == 'zh' else ':'}", row(symbol), ""
    return before.strip(), row(symbol), way.strip("（） ()")


def direction_told(answer: Answer, solution: Solution, lang: Lang) -> str:
    """Where a vector points, in which sense it turns, along which line a force counts; of what stands still, why."""
    return remark_of(answer, lang) if stands_still(answer) else _direction(answer, solution.problem, lang)


def _bracket(answer: Answer, problem: Problem, way: str, lang: Lang) -> str:
    """Direction or sense, in brackets."""
    still = remark_of(answer, lang) if stands_still(answer) else ""
    said = [one for one in (_direction(answer, problem, lang), way, still) if one]
    if not said:
        return ""
    return f"（{'，'.join(said)}）" if lang == "zh" else f" ({', '.join(said)})"


def _direction(answer: Answer, problem: Problem, lang: Lang) -> str:
    """An arrow along an axis, else the angle from the x axis; of turning, the sense; of a force along a line, that."""
    if answer.is_place:
        return ""
    if answer.drawn_vector is not None:
        return "" if answer.direction is None else _pointing(answer.direction)
    if (fixed := direction_of_load(problem, answer.key)) is not None and answer.drawn:
        return _pointing(degrees(fixed))
    if (line := counted_from(problem, answer.key)) is not None:
        return line.of(lang)
    if answer.along is not None:
        return answer.along.of(lang)
    return _TURNS[answer.sense].of(lang) if answer.sense else ""


def _pointing(turn: float) -> str:
    told = bearing_told(turn)
    return SQUARE.get(told) or f"∠{told}"


def _way(answer: Answer) -> str:
    """In which direction a place at infinity lies."""
    return f"∠{answer.drawn:.1f}°".replace("-", "−")


def _after(answer: Answer, lang: Lang) -> str:
    """The conclusion that the construction came to, whether its length can be measured, how coarse the reading is."""
    said = [
        "" if stands_still(answer) else remark_of(answer, lang),
        told_short(answer).of(lang) if answer.short else "",
    ]
    said += [f"{UNREADABLE.of(lang)}{Words('：', ': ').of(lang)}{INSTEAD.of(lang)}" if is_hopeless(answer) else ""]
    said += [f"{COARSE.of(lang)} {error_of(answer)}" if error_of(answer) else ""]
    return Words("；", "; ").of(lang).join(filter(None, said))
