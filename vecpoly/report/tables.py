"""The tables of a report: readings beside exact values, printed answers with their verdicts, empty answer tables."""

from __future__ import annotations

from collections.abc import Sequence

from ..check.verdict import Checked
from ..problem.problem import as_printed
from ..quantity import number
from ..solution import Answer, Solution
from ..words import Lang, Words
from .flow.table import DataTable

_READINGS = {
    "zh": ("量", "图上长度 /mm", "比例尺", "量得值", "方向（转向）", "精确值", "偏差", "预期误差"),
    "en": ("Quantity", "mm on paper", "Scale", "Drawn", "Direction, sense", "Exact", "Deviation", "Expected error"),
}
_PRINTED = {"zh": ("量", "原书", "精确值", "偏差", "结论"), "en": ("Quantity", "Printed", "Exact", "Deviation", "Verdict")}
_EMPTY = {"zh": ("量", "图上长度 /mm", "比例尺", "数值与单位", "方向（转向）"),
          "en": ("Quantity", "mm on paper", "Scale", "Value with unit", "Direction, sense")}
_BLANK = "＿＿＿＿＿"
_SENSE = {"ccw": Words("↺ 逆时针", "↺ ccw"), "cw": Words("↻ 顺时针", "↻ cw"), None: Words.same("—")}


def readings_table(solution: Solution, lang: Lang) -> DataTable:
    """One line an answer: symbol, mm, scale, value, direction or sense, exact, deviation, expected error."""
    rows = [_row(answer, lang) for answer in solution.answers.values()]
    return DataTable(_READINGS[lang], rows, None, "lccrccrr")


def _row(answer: Answer, lang: Lang) -> tuple[str, ...]:
    r = answer.reading
    mm = "—" if r.mm is None else f"{r.mm:.1f}"
    if r.key.startswith("p_") and answer.drawn_vector is not None and answer.exact_vector is not None:
        drawn, exact = (f"({number(1e3 * v.real)}, {number(1e3 * v.imag)})" for v in (answer.drawn_vector, answer.exact_vector))
        gap = f"{number(1e3 * abs(answer.drawn_vector - answer.exact_vector), 2)} mm"
        return (f"${r.symbol}$", mm, f"${r.scale}$", f"{drawn} mm", "—", exact, gap, number(1e3 * answer.expected_error, 2))
    return (
        f"${r.symbol}$", mm, f"${r.scale}$" if r.scale else "—", f"{number(answer.drawn, 4)} {r.unit}", way(answer, lang),
        number(_clean(answer.exact, answer.expected_error), 5), _deviation(answer), number(answer.expected_error, 2),
    )


def _clean(exact: float, error: float) -> float:
    """Zero where only rounding noise is left."""
    return 0.0 if abs(exact) < 1e-9 * max(1.0, abs(error)) else exact


def _deviation(answer: Answer) -> str:
    if not _clean(answer.exact, answer.expected_error):
        return number(answer.drawn, 2)
    return percent(answer.relative_deviation, 2)


def way(answer: Answer, lang: Lang) -> str:
    """Direction in degrees, or the sense of turning."""
    if answer.drawn_vector is not None:
        return "—" if answer.direction is None else f"{answer.direction:.1f}°".replace("-", "−")
    return _SENSE[answer.sense].of(lang)


def empty_table(solution: Solution, lang: Lang) -> DataTable:
    """The answer table to be filled in by hand."""
    rows = [(f"${a.reading.symbol}$", _BLANK if a.reading.mm is not None else "—", f"${a.reading.scale}$" if a.reading.scale else "", _BLANK, _BLANK) for a in solution.answers.values()]
    return DataTable(_EMPTY[lang], rows, (30.0, 32.0, 26.0, 44.0, 38.0), "lcccc")


def printed_table(checked: Sequence[Checked], lang: Lang) -> DataTable:
    """Printed answers, the exact values, and what is to be said of them."""
    rows = []
    for c in checked:
        verdict = c.verdict.words.of(lang)
        slip = f"：{c.slip.zh}" if c.slip and lang == "zh" else (f": {c.slip.en}" if c.slip else "")
        rows.append((f"${symbol_of(c)}$", _as_given(c, lang), _exact_like(c), percent(c.deviation, 1), verdict + slip))
    return DataTable(_PRINTED[lang], rows, None, "lrrrl")


def _as_given(checked: Checked, lang: Lang) -> str:
    """The printed answer as it stands there, and what it is where a length on paper is printed."""
    printed = checked.printed
    text = as_printed(printed.text, lang)
    if printed.scale:
        unit = printed.rel.unit if printed.rel else "m"
        text += f" = {number(abs(printed.value))} {unit}"
    return text


def _exact_like(checked: Checked) -> str:
    """The exact value with its unit."""
    return f"{number(checked.exact)} {checked.printed.rel.unit if checked.printed.rel else 'm'}"


def symbol_of(checked: Checked) -> str:
    """The textbook's symbol of a printed answer."""
    return checked.printed.rel.symbol if checked.printed.rel else checked.printed.symbol


def percent(ratio: float, digits: int) -> str:
    """A signed percentage; no sign on zero."""
    text = f"{100 * ratio:+.{digits}f}"
    return (text.lstrip("+-") if float(text) == 0 else text.replace("-", "−")) + " %"


