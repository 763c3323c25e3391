"""The tables of a report: readings beside exact values, printed answers with their verdicts, empty answer tables."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

from ..algebra.quantity import number
from ..board.construction import Listing
from ..check.printed.verdict import Checked
from ..names import is_place
from ..problem.problem import Problem, as_printed
from ..solution import YES_NO, Answer, Solution
from ..words import Lang, Words
from .flow.table import DataTable
from .values import called, direction_of_load, printed_unit, rough, value

_READINGS = {
    "zh": ("量", "图上长度 /mm", "比例尺", "量得值", "方向", "精确值", "偏差", "预期误差"),
    "en": ("Quantity", "On paper, mm", "Scale", "Drawn", "Direction", "Exact", "Deviation", "Exp. error"),
}
_PRINTED = {
    "zh": ("量", "原书", "精确值", "偏差", "结论"),
    "en": ("Quantity", "Printed", "Exact", "Deviation", "Verdict"),
}
_NONE = "—"
_COMPUTED = {"zh": "计算值", "en": "Computed"}
_NOTHING = 1e-9  # m: places that all hands find alike, a fixed pivot
_DRAWN = 3  # column of the value in _READINGS
MOST_COLUMNS = 15  # of a table of stations, in all its blocks
FEW = 6  # rows of a table that stays one block
_SENSE = {"ccw": Words("↺ 逆时针", "↺ ccw"), "cw": Words("↻ 顺时针", "↻ cw"), None: Words.same("—")}


def readings_table(solution: Solution, lang: Lang) -> DataTable:
    """One line an answer: symbol, mm, scale, value, direction or sense, exact, deviation, expected error."""
    rows = [_row(answer, solution.problem, lang) for answer in solution.answers.values()]
    header = list(_READINGS[lang])
    if all(answer.computed for answer in solution.answers.values()):
        header[_DRAWN] = _COMPUTED[lang]
    return trimmed(header, rows, (), "lccrccrr")


def listed(listing: Listing, lang: Lang) -> DataTable:
    """What a step reads at many places: in as many blocks beside each other as a page has room for."""
    blocks = max(1, min(listing.blocks, MOST_COLUMNS // len(listing.head)))
    wide = listing.abreast(blocks) if len(listing.rows) > max(blocks, FEW) else listing
    return DataTable([head.of(lang) for head in wide.head], wide.rows, None, "c" * len(wide.head), lang=lang)


def trimmed(header: Sequence[str], rows: Sequence[Sequence[str]], widths: Sequence[float], align: str) -> DataTable:
    """The table without columns in which nothing stands."""
    kept = [i for i in range(len(header)) if not rows or any(row[i] != _NONE for row in rows)]
    return DataTable(
        [header[i] for i in kept],
        [[row[i] for i in kept] for row in rows],
        [widths[i] for i in kept] if widths else None,
        "".join(align[i] for i in kept),
    )


def _row(answer: Answer, problem: Problem, lang: Lang) -> tuple[str, ...]:
    r = answer.reading
    mm = "—" if r.mm is None else f"{r.mm:.1f}"
    if answer.is_place and answer.drawn_vector is not None and answer.exact_vector is not None:
        return _place(answer, mm, answer.drawn_vector, answer.exact_vector)
    if answer.is_place:  # at infinity
        gap, reach = number(answer.deviation, 2) + "°", _NONE if answer.computed else rough(answer.expected_error) + "°"
        return (f"${r.symbol}$", mm, "—", "∞", _angle(answer.drawn), _angle(answer.exact), gap, reach)
    factor = printed_unit(r.unit)[0]
    clean = _clean(answer.exact, answer.expected_error)
    exact = value(clean, YES_NO, lang) if r.unit == YES_NO or answer.undefined else number(factor * clean, 5)
    return (
        called(r.symbol, r.key, lang),
        mm,
        f"${r.scale}$" if r.scale else "—",
        value(answer.drawn, r.unit, lang, r.key),
        way(answer, problem, lang),
        exact,
        _deviation(answer, factor),
        _NONE if answer.computed else rough(factor * answer.expected_error),
    )


def _place(answer: Answer, mm: str, drawn: complex, exact: complex) -> tuple[str, ...]:
    """The row of a point (m)."""
    here, there = (f"({_fixed(v.real)}, {_fixed(v.imag)})" for v in (drawn, exact))
    off = abs(drawn - exact)
    gap = f"{number(1e3 * off if off > _NOTHING else 0.0, 2)} mm"
    reach = number(1e3 * answer.expected_error, 2) if answer.expected_error > _NOTHING else _NONE
    return (f"${answer.reading.symbol}$", mm, f"${answer.reading.scale}$", f"{here} mm", "—", there, gap, reach)


def _fixed(place: float) -> str:
    """A coordinate in mm to a hundredth, the last zeros and the sign of zero left out."""
    text = f"{1e3 * place:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text.replace("-", "−")


def _clean(exact: float, error: float) -> float:
    """Zero where only rounding noise is left."""
    return 0.0 if abs(exact) < 1e-9 * max(1.0, abs(error)) else exact


def _deviation(answer: Answer, factor: float) -> str:
    """In per cent; nothing where a formula gave the exact value, or where yes is right."""
    if answer.computed:
        return "—"
    if not _clean(answer.exact, answer.expected_error):
        return f"{number(factor * answer.drawn, 2)} {printed_unit(answer.reading.unit)[1]}".rstrip()
    return percent(answer.relative_deviation, 2)


def way(answer: Answer, problem: Problem, lang: Lang) -> str:
    """Direction in degrees, the sense of turning, or the line along which a force is counted."""
    if answer.drawn_vector is not None:
        return "—" if answer.direction is None else _angle(answer.direction)
    fixed = direction_of_load(problem, answer.key)
    if fixed is not None:
        return Words(f"沿 {_angle(degrees(fixed))}", f"along {_angle(degrees(fixed))}").of(lang)
    return _SENSE[answer.sense if _clean(answer.exact, answer.expected_error) else None].of(lang)


def _angle(turn: float) -> str:
    return f"{turn:.1f}°".replace("-", "−")


def printed_table(checked: Sequence[Checked], lang: Lang) -> DataTable:
    """Printed answers, the exact values, and what is to be said of them."""
    rows = []
    for c in checked:
        verdict = c.verdict.words.of(lang)
        slip = f"：{c.slip.zh}" if c.slip and lang == "zh" else (f": {c.slip.en}" if c.slip else "")
        rows.append(
            (
                f"${symbol_of(c)}$",
                _as_given(c, lang),
                _exact_like(c, lang),
                percent(c.deviation, 1 if c.printed.kind == "graphical" else 2),
                verdict + slip,
            )
        )
    return DataTable(_PRINTED[lang], rows, None, "lrrrl")


def _as_given(checked: Checked, lang: Lang) -> str:
    """The printed answer as it stands there, and what it is where a length on paper is printed."""
    printed = checked.printed
    text = as_printed(printed.text, lang)
    if printed.scale:
        unit = printed.rel.unit if printed.rel else "m"
        text += f" = {number(abs(printed.value))} {unit}"
    return text


def _exact_like(checked: Checked, lang: Lang) -> str:
    """The exact value with its unit."""
    rel = checked.printed.rel
    if rel is None or is_place(rel):
        return f"{number(checked.exact, 5)} m"
    return value(checked.exact, rel.unit, lang, digits=5)


def symbol_of(checked: Checked) -> str:
    """The textbook's symbol of a printed answer."""
    return checked.printed.rel.symbol if checked.printed.rel else checked.printed.symbol


def percent(ratio: float, digits: int) -> str:
    """A signed percentage; no sign on zero."""
    text = f"{100 * ratio:+.{digits}f}"
    return (text.lstrip("+-") if float(text) == 0 else text.replace("-", "−")) + " %"
