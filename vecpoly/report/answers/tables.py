"""Drawn beside exact: a table of the quantities, and one of the places; no column in which nothing stands."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import degrees, isfinite

from ...algebra.quantity import number
from ...algebra.rounding import braced, places_of, read_back
from ...printed.angles import bearing_told
from ...printed.digits import drawn_number, exact_number, is_hopeless, on_paper
from ...printed.units import printed_unit
from ...problem.problem import Problem
from ...solution import YES_NO, Answer, Solution
from ...words import Lang, Words
from ..flow.table import DataTable
from ..tables import trimmed
from ..values import called, class_told, direction_of_load, is_class, value
from .alike import named_once
from .errors import NOTHING, beside, in_one_unit
from .line import is_length_times_scale
from .order import listed
from .placed import ALIGN_PLACES, PLACES, angle, clean, endless, gaps, place_row, places_table

_DIRECTION, _DEVIATION = Words("方向", "Direction"), Words("偏差", "Deviation")
_EXPECTED = Words("预期误差", "Expected error")
_HEADS = (
    Words("所求量", "Quantity"),
    Words("单位", "Unit"),
    Words("图上长度 /mm", "On paper /mm"),
    Words("比例尺", "Scale"),
    Words("量得值", "Drawn"),
    _DIRECTION,
    Words("精确值", "Exact"),
    Words("偏差 /%", "Deviation /%"),
    _EXPECTED,
)
_SCALE, _VALUE, _OFF, _WITH_UNIT, _ALIGN = 3, 4, 7, (4, 6), "lcdcddddd"
_COMPUTED = Words("计算值", "Computed")
_SHORT = Words("（过短）", " (too short)")
_SENSE = {"ccw": Words("逆时针", "counter-clockwise"), "cw": Words("顺时针", "clockwise")}


def readings_tables(solution: Solution, lang: Lang) -> tuple[DataTable, ...]:
    """The answers that were read or computed beside the exact ones; none where all of them are only counted."""
    answers = listed(solution.answers.values())
    if all(map(counted, answers)):
        return ()
    places, others = tabled(answers)
    found = [_values(others, solution, lang)] if others else []
    return (*found, *([places_table(places, solution, lang)] if places else []))


def readings_at(
    positions: Iterable[tuple[str, Solution, Iterable[Answer]]], drive: str, lang: Lang
) -> tuple[DataTable, ...]:
    """The same at several positions, each told in the first column; without the expected errors."""
    values: list[tuple[str, ...]] = []
    places: list[tuple[str, ...]] = []
    for where, solution, answers in positions:
        spots, others = parted(answers)
        values += _at(where, [_with_scale(row_of(one, solution, lang, unit_of(one)), solution) for one in others])
        placed = [(*place_row(one), gap) for one, gap in zip(spots, gaps(spots), strict=True)]
        places += _at(where, placed)
    tables = ((_without_gaps(values, _SCALE + 1), _HEADS, _ALIGN), (places, PLACES, ALIGN_PLACES))
    return tuple(
        trimmed(
            [drive, *(head.of(lang) for head in heads[:-1])], rows, (), f"l{align[:-1]}", lang, [row[2] for row in rows]
        )
        for rows, heads, align in tables
        if rows
    )


def _without_gaps(rows: list[tuple[str, ...]], scale: int) -> list[tuple[str, ...]]:
    """The rows without lengths on paper where few have one: these stand on the sheets. scale: the column behind them,
    which is another where a place tells each row first."""
    read = sum(row[scale] != NOTHING for row in rows)
    if 3 * read >= 2 * len(rows):
        return rows
    return [(*row[: scale - 1], NOTHING, NOTHING, *row[scale + 1 :]) for row in rows]


def _with_scale(row: tuple[str, ...], solution: Solution) -> tuple[str, ...]:
    """The row with the size of its scale, which is another at each position: μ_v = 0.0003."""
    symbol = row[_SCALE].strip("$")
    found = {one.scale.symbol: one.scale.told for one in solution.construction.figures if one.scale.symbol}
    told = f"${symbol}$ = {number(found[symbol].value)}" if symbol in found else row[_SCALE]
    return (*row[:_SCALE], told, *row[_SCALE + 1 :])


def _at(where: str, rows: list[tuple[str, ...]]) -> list[tuple[str, ...]]:
    return [("" if n else where, *row) for n, row in enumerate(rows)]


def parted(answers: Iterable[Answer]) -> tuple[list[Answer], list[Answer]]:
    """The places, and all that is none: a place at infinity is a direction."""
    every = list(answers)
    finite = {one.key for one in every if one.is_place and None not in (one.drawn_vector, one.exact_vector)}
    return [one for one in every if one.key in finite], [one for one in every if one.key not in finite]


def tabled(answers: Iterable[Answer]) -> tuple[list[Answer], list[Answer]]:
    """The same without places at infinity, which a sentence tells."""
    places, others = parted(answers)
    return places, [one for one in others if not endless(one)]


def lone_place(answers: Iterable[Answer]) -> Answer | None:
    """The only place beside other answers, which a sentence tells."""
    places, others = tabled(answers)
    return places[0] if len(places) == 1 and others else None


def counted(answer: Answer) -> bool:
    """Whether the answer is a number of things, or yes or no, and the same by the independent count."""
    whole = not answer.reading.unit and float(answer.drawn).is_integer() and answer.reading.mm is None
    return (whole or answer.reading.unit == YES_NO) and answer.drawn == answer.exact


def filled(answers: Sequence[Answer], solution: Solution, lang: Lang) -> tuple[list[str], list[tuple[str, ...]]]:
    """The heads and the rows of all columns."""
    header, one_unit = _headed(answers, lang)
    rows = [row_of(one, solution, lang, "" if one_unit else unit_of(one)) for one in answers]
    told = [row[_OFF] for row in rows]
    lost = [is_hopeless(one) and off != NOTHING for one, off in zip(answers, told, strict=True)]
    header[_OFF], offs = in_one_unit(_DEVIATION.of(lang), _worth(told, lost), "%")
    header[-1], errors = in_one_unit(_EXPECTED.of(lang), _worth(beside(answers, told), lost), "")
    if one_unit != NOTHING and all(off == NOTHING for off in told):  # each in the unit of its row
        errors = [error.partition(" ")[0] for error in errors]
        header[-1] = _EXPECTED.of(lang) + (f" /{braced(one_unit)}" if one_unit else "")
    return header, [(*row[:_OFF], off, error) for row, off, error in zip(rows, offs, errors, strict=True)]


def _worth(cells: Sequence[str], lost: Sequence[bool]) -> list[str]:
    """No deviation and no share of what could not be read."""
    return [NOTHING if one else cell for cell, one in zip(cells, lost, strict=True)]


def _values(every: list[Answer], solution: Solution, lang: Lang) -> DataTable:
    """What is the same by the drawing and exactly, v_B3 and v_C of a slotted slide, is checked once, in one row."""
    once = named_once(every, solution, lang)
    answers = [one for one, _ in once]
    header, rows = filled(answers, solution, lang)
    rows = [(name, *row[1:]) for (_, name), row in zip(once, rows, strict=True)]
    if not any(one.short for one in answers):  # that a length is too short is told beside it
        rows = _without_gaps(rows, _SCALE)
    return trimmed(header, rows, (), _ALIGN, lang, [unit_of(one) for one in answers])


def _headed(answers: Sequence[Answer], lang: Lang) -> tuple[list[str], str]:
    """The heads of all columns, and the unit that stands in them where the answers have but one."""
    units = {unit_of(one) for one in answers if one.reading.unit != YES_NO}
    one_unit = units.pop() if len(units) == 1 else ""
    header = [head.of(lang) for head in _HEADS]
    if all(one.computed for one in answers):
        header[_VALUE] = _COMPUTED.of(lang)
    if one_unit not in ("", NOTHING):
        header = [f"{head} /{braced(one_unit)}" if n in _WITH_UNIT else head for n, head in enumerate(header)]
    return header, one_unit


def unit_of(answer: Answer) -> str:
    """The unit as it stands in the table; of a pure number nothing."""
    unit = printed_unit(answer.reading.unit)[1]
    return {"deg": "°", "": NOTHING, YES_NO: NOTHING}.get(unit, unit)


def row_of(answer: Answer, solution: Solution, lang: Lang, unit: str) -> tuple[str, ...]:
    r = answer.reading
    exact, read = clean(answer), _is_read(answer, solution)
    return (
        called(r.symbol, r.key, lang),
        unit or NOTHING,
        f"{on_paper(answer)}{_SHORT.of(lang) if answer.short else ''}" if read else NOTHING,
        f"${r.factor + ' ' if r.factor else ''}{r.scale}$" if read and r.scale else NOTHING,
        _plain(answer, answer.drawn, lang) or drawn_number(answer),
        way(answer, solution.problem, lang),
        _plain(answer, exact, lang) or exact_number(answer, exact),
        deviation_told(answer),
    )


def _is_read(answer: Answer, solution: Solution) -> bool:
    """Whether its length was measured; that of what was reckoned and laid off is rounded, and gives another value."""
    length, scale = answer.reading.mm, answer.reading.scale
    if length is None or not scale or answer.reading.factor or answer.computed:
        return length is not None
    return is_length_times_scale(answer, solution)


def _plain(answer: Answer, size: float, lang: Lang) -> str:
    """What is no number: yes, no, undefined; a class; the direction of a place at infinity."""
    if answer.reading.unit == YES_NO or answer.undefined:
        return value(size, YES_NO, lang, answer.key)
    if is_class(answer.key):
        return class_told(size, lang)
    return f"∞, {angle(size)}" if answer.is_place else ""


def deviation_told(answer: Answer) -> str:
    """Of the two values as they stand beside it, in per cent, of an angle in degrees; NOTHING where the exact one is so
    small that it stands there as 0."""
    if (sign := sign_of_deviation(answer)) == NOTHING:
        return NOTHING
    angular, told = bool(sign), exact_number(answer, clean(answer))
    (drawn, _), (size, _) = read_back(drawn_number(answer)), read_back(told)
    if not angular and not size:
        return NOTHING
    text = f"{drawn - size:+.{places_of(told)}f}" if angular else f"{100 * (drawn - size) / abs(size):+.2f}"
    text = text.lstrip("+-") if float(text) == 0 else text.replace("-", "−")
    return text + sign


def sign_of_deviation(answer: Answer) -> str:
    """What stands behind it: ° of an angle, nothing of per cents; NOTHING where there is none, for a formula gave the
    exact value, or that is zero."""
    angular = answer.reading.unit == "deg"
    if answer.computed or answer.is_place or not isfinite(answer.relative_deviation if not angular else answer.drawn):
        return NOTHING
    return "°" if angular else "" if clean(answer) else NOTHING


def way(answer: Answer, problem: Problem, lang: Lang) -> str:
    """Direction in degrees, the sense of turning, or the line along which a force is counted."""
    if answer.drawn_vector is not None:
        return NOTHING if answer.direction is None else bearing_told(answer.direction)
    fixed = direction_of_load(problem, answer.key)
    if fixed is not None:
        return bearing_told(degrees(fixed))
    if answer.along is not None:
        return answer.along.of(lang)
    return _SENSE[answer.sense].of(lang) if answer.sense and clean(answer) else NOTHING
