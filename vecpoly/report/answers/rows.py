"""The rows of the framed answer: each value with its unit and direction, and beside it what it is exactly, by how much
it is off, and by how much it may be off."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...algebra.rounding import braced, read_back
from ...foundation.slotted import dataclass
from ...printed.digits import drawn_number, in_percent, is_hopeless
from ...solution import Answer, Solution
from ...words import Lang, Words
from ..flow.results.framed import FramedTable
from ..tables import trimmed
from ..values import called, is_efficiency
from .alike import named_once
from .errors import NOTHING, beside, in_one_unit
from .line import direction_told, result_of
from .order import Part, arranged, broken
from .placed import ALIGN_PLACES, PLACES, angle, clean, endless, gaps, place_row, reaches
from .tables import deviation_told, row_of, unit_of
from .verdict import exceeds, starred

BY_FORMULA = Words("计算值", "computed")
GIVEN = Words("已知", "given")
_ALL = Words("各解", "All")
_QUANTITY, _UNIT, _DIRECTION = Words("所求量", "Quantity"), Words("单位", "Unit"), Words("方向", "Direction")
_DRAWN, _RESULT = Words("量得值", "Drawn"), Words("结果", "Result")
_EXACT, _OFF, _ERROR = Words("精确值", "Exact"), Words("偏差", "Deviation"), Words("预期误差", "Expected error")
_ALIGN = "lldccddd"
_VALUE, _IN, _TRUE = 2, 3, 5  # columns of the value, its unit, and the exact value


@dataclass(frozen=True, slots=True)
class Rowed:
    """One row: the keys of the answers that it tells, and its cells, the first of which names the solution."""

    keys: tuple[str, ...]
    cells: tuple[str, ...]

    def with_cell(self, at: int, text: str) -> Rowed:
        """With another cell there."""
        at %= len(self.cells)
        return Rowed(self.keys, (*self.cells[:at], text, *self.cells[at + 1 :]))

    @property
    def over(self) -> bool:
        """Whether it is off by more than expected."""
        return exceeds(*self.cells[-2:])


def values_table(parts: Sequence[Part], solution: Solution, lang: Lang) -> FramedTable | None:
    """All that is no place, or a lone one: value, unit, direction, and what it is beside exactly; a unit that all have
    stands in the heads. None where there is nothing."""
    rows = [row for part in parts for row in _of_part(part, solution, lang)]
    if not rows:
        return None
    heads = ["", *(head.of(lang) for head in (_QUANTITY, _DRAWN, _UNIT, _DIRECTION, _EXACT))]
    if any(BY_FORMULA.of(lang) in row.cells for row in rows):
        heads[_VALUE] = _RESULT.of(lang)
    units = {row.cells[_IN] for row in rows}
    if len(units) == 1 and NOTHING not in units:
        for n in (_VALUE, _TRUE):
            heads[n] += f" /{braced(*units)}"
        rows = [row.with_cell(_IN, NOTHING) for row in rows]
    for n, head, bare in ((-2, _OFF, "%"), (-1, _ERROR, "")):
        told, column = in_one_unit(head.of(lang), [row.cells[n] for row in rows], bare)
        heads.append(told)
        rows = [row.with_cell(n, cell) for row, cell in zip(rows, column, strict=True)]
    return _framed(heads, rows, _ALIGN, lang)


def places_table(parts: Sequence[Part], solution: Solution, lang: Lang) -> FramedTable | None:
    """The places, each as drawn and exactly; one at infinity by its direction."""
    rows: list[Rowed] = []
    for head, answers in _headed(parts, solution, lang):
        ends = _ends(answers, solution)
        for n, (one, end) in enumerate(zip(answers, ends, strict=True)):
            told = _endless_row(one) if endless(one) else place_row(one)
            if not endless(one) and end[1] == NOTHING:  # a fixed pivot, which all hands find alike
                told, end = (*told[:3], GIVEN.of(lang), NOTHING), (NOTHING, NOTHING)
            rows.append(Rowed((one.key,), ("" if n else head, *told, *(text.replace(" mm", "") for text in end))))
    heads = ["", *(one.of(lang) for one in PLACES)]
    return _framed(heads, rows, f"l{ALIGN_PLACES}", lang) if rows else None


def _of_part(part: Part, solution: Solution, lang: Lang) -> Iterator[Rowed]:
    """The rows of one solution; equal vectors, and what was read as one length in one direction, share one."""
    ((head, answers),) = _headed([part], solution, lang)
    once = named_once(answers, solution, lang)
    ends = _ends([one for one, _ in once], solution)
    rows = [
        Rowed(_keys(one, name, answers, lang), ("", name, *_value(one, solution, lang), *end))
        for (one, name), end in zip(once, ends, strict=True)
    ]
    for n, row in enumerate(_alike([one for one, _ in once], rows, lang)):
        yield row if n else row.with_cell(0, head)


def _headed(parts: Sequence[Part], solution: Solution, lang: Lang) -> list[tuple[str, list[Answer]]]:
    """Of each part what stands over it, the number of its solution."""
    several, idle = len(arranged(solution.answers.values())) > 1, broken(solution)
    return [(part.heading(lang, idle) or (_ALL.of(lang) if several else ""), list(part.answers)) for part in parts]


def _keys(one: Answer, name: str, answers: Sequence[Answer], lang: Lang) -> tuple[str, ...]:
    """The keys of all that a row with such a name tells."""
    names = name.split(" = ") if name.count("$") > 2 else [name]
    return tuple(
        other.key
        for other in answers
        if other is one or (len(names) > 1 and called(other.reading.symbol, other.key, lang) in names)
    )


def _value(answer: Answer, solution: Solution, lang: Lang) -> tuple[str, ...]:
    """Number, unit, direction, exact value."""
    unit = unit_of(answer)
    if endless(answer):
        return "∞", NOTHING, f"∠{angle(answer.drawn)}", f"∠{angle(clean(answer))}"
    if answer.is_place:
        _, x, y, true_x, true_y = place_row(answer)
        return f"({x}, {y})", "mm", NOTHING, f"({true_x}, {true_y})"
    row = row_of(answer, solution, lang, unit)
    told = drawn_number(answer) if not answer.undefined else result_of(answer, lang)
    if is_efficiency(answer.key, answer.reading.unit) and "%" in result_of(answer, lang):
        unit = f"({in_percent(told)})"
    exact = BY_FORMULA.of(lang) if answer.computed else row[6]
    return told, unit, direction_told(answer, solution, lang) or NOTHING, exact


def _ends(answers: Sequence[Answer], solution: Solution) -> Iterator[tuple[str, str]]:
    """By how much each is off and may be off, with the unit where that is not per cent."""
    told = [_turned(one) if endless(one) else deviation_told(one) for one in answers]
    places = [one for one in answers if one.is_place and not endless(one)]
    of_places = dict(zip((one.key for one in places), zip(gaps(places), reaches(places), strict=True), strict=True))
    for one, off, error in zip(answers, told, beside(answers, told), strict=True):
        if one.key in of_places:
            off, error = map(_in_mm, of_places[one.key])
        yield NOTHING if is_hopeless(one) else off, starred(error, one, solution)


def _endless_row(answer: Answer) -> tuple[str, ...]:
    """A place at infinity by its direction."""
    return f"${answer.reading.symbol}$", "∞", f"∠{angle(answer.drawn)}", "∞", f"∠{angle(clean(answer))}"


def _turned(answer: Answer) -> str:
    """By how much that direction is off, as both stand beside it."""
    off = read_back(angle(answer.drawn)[:-1])[0] - read_back(angle(clean(answer))[:-1])[0]
    return f"{off:+.1f}°".replace("-", "−") if round(off, 1) else "0.0°"


def _in_mm(text: str) -> str:
    return text if text == NOTHING else f"{text} mm"


def _alike(answers: Sequence[Answer], rows: Sequence[Rowed], lang: Lang) -> list[Rowed]:
    """Rows that say the same of one length on paper, as of a force handed on, have one row."""
    found = dict[tuple[object, ...], list[Rowed]]()
    for n, (one, row) in enumerate(zip(answers, rows, strict=True)):
        mm = one.reading.mm
        found.setdefault((mm, *row.cells[2:]) if mm and one.drawn_vector is not None else (n,), []).append(row)
    comma = Words("、", ", ").of(lang)
    return [
        Rowed(
            tuple(key for row in some for key in row.keys),
            (some[0].cells[0], comma.join(row.cells[1] for row in some), *some[0].cells[2:]),
        )
        for some in found.values()
    ]


def _framed(header: Sequence[str], rows: Sequence[Rowed], align: str, lang: Lang) -> FramedTable:
    table = FramedTable.of(trimmed(header, [row.cells for row in rows], (), align, lang))
    table.keys = tuple(row.keys for row in rows)
    table.over = tuple(row.cells[1] for row in rows if row.over)
    return table
