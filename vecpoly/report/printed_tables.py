"""Printed tables of a problem as a report speaks of them: the whole, one line a column, then what a line cannot say."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from typing import Any

from ..check.table.told.amounts import amount, rows_at, which
from ..check.table.weigh import Level
from ..check.table.whole import ColumnCheck, TableCheck, check_table
from ..problem.problem import Problem
from ..words import Lang, Words, stopped

# title, header, rows, alignment → name for the template
Put = Callable[[Words, Sequence[str], Sequence[tuple[str, ...]], str], str]
_HEADER = {
    "zh": ("列", "结论", "相符行数", "最大偏差", "原因"),
    "en": ("Column", "Verdict", "Rows right", "Deviation", "By which slip"),
}
_RIGHT = 2  # column
_AS_ABOVE = Words("同上", "as above")
_UNKNOWN = Words("不明", "unknown")


def printed_tables(problem: Problem, lang: Lang, put: Put) -> list[dict[str, Any]]:
    """One entry a table: its name, what is to be said of the whole, the verdicts as a table, remarks on columns."""
    return [_table(check_table(problem, file), lang, put) for file in problem.tables]


def _table(checked: TableCheck, lang: Lang, put: Put) -> dict[str, Any]:
    title = Words(f"印刷数据表 {checked.title.zh} 各列的核对", f"The columns of the printed table {checked.title.en}")
    count = Counter(_cause(one) for one in checked.columns)
    alike = {level: [one.column.label.of(lang) for one in checked.columns if one.verdict is level] for level in Level}
    parts = [
        f"{'、'.join(names)}：{level.words.zh}" if lang == "zh" else f"{', '.join(names)}: {level.words.en}"
        for level, names in alike.items()
        if names
    ]
    return {
        "name": checked.title.of(lang),
        "whole": _run_on([words.of(lang) for words in checked.whole], lang),
        "notes": _run_on([words.of(lang) for words in checked.notes], lang),
        "table": put(title, *_lines(checked, lang), "llrrl"),
        "short": "；".join(parts) if lang == "zh" else "; ".join(parts),
        "columns": [one.words.of(lang) for one in checked.columns if not _said(one, count[_cause(one)])],
    }


def _lines(checked: TableCheck, lang: Lang) -> tuple[list[str], list[tuple[str, ...]]]:
    """Heads and rows; of how many rows, in the head where that is one number."""
    heads, rows = [*_HEADER[lang]], _rows(checked, lang)
    counts = {row[_RIGHT].partition("/")[2] for row in rows}
    if len(counts) == 1:
        (every,) = counts
        heads[_RIGHT] += f"（共 {every} 行）" if lang == "zh" else f" of {every}"
        rows = [(*row[:_RIGHT], row[_RIGHT].partition("/")[0], *row[_RIGHT + 1 :]) for row in rows]
    return heads, rows


def _rows(checked: TableCheck, lang: Lang) -> list[tuple[str, ...]]:
    rows: list[tuple[str, ...]] = []
    last: Words | None = None
    for one in checked.columns:
        cause = _cause(one)
        said = (
            "—"
            if cause is None
            else (_AS_ABOVE if cause == last and cause != _UNKNOWN and one.explanations[0].alone is None else cause).of(
                lang
            )
        )
        if one.verdict is Level.ROWS and cause is None:
            said = rows_at(checked.table, which(one.given.outliers))
        rows.append(
            (
                one.column.label.of(lang),
                one.verdict.words.of(lang),
                f"{one.given.rows_right}/{int(one.column.there.sum())}",
                amount(one.column, one.given.worst) if one.verdict else "—",
                said,
            )
        )
        last = cause
    return rows


def _cause(one: ColumnCheck) -> Words | None:
    if one.explanations:
        best = one.explanations[0]
        many = (
            Words(f"公式中 {best.slips} 处差错（见上）", f"{best.slips} slips in its formula (see above)")
            if best.slips > 1
            else Words("公式中一处差错（见上）", "a slip in its formula (see above)")
        )
        return best.words if best.alone is None else many
    return _UNKNOWN if one.verdict is Level.WRONG else None


def _said(one: ColumnCheck, sharing: int) -> bool:
    """Whether the line of the table, and the box above it, say all:
    the column is right, or shares its one slip with others."""
    if one.explanations and one.explanations[0].alone is not None:
        return len(one.explanations) == 1 and one.best.level < Level.ROWS
    if one.explanations:
        return (
            sharing > 1
            and one.best.level < Level.ROWS
            and len({slip.slip for slip in one.explanations} - {"constant factor"}) == 1
        )
    return one.verdict <= Level.LAST_DIGIT or one.verdict is Level.LOW


def _run_on(texts: list[str], lang: Lang) -> str:
    """Several remarks in one box, numbered, each with its full stop."""
    texts = [stopped(text, lang) for text in texts]
    return (
        texts[0]
        if len(texts) == 1
        else ("　" if lang == "zh" else "  ").join(f"({i}) {text}" for i, text in enumerate(texts, 1))
    )
