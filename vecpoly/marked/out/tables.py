"""Grades as tables: a row for each student, a column for each answer, totals, flags; CSV and XLSX say the same."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from typing import Any

import xlsxwriter

from ...batch.forms.workbooks import write_row
from ...grading.marking.marked import Marked
from ...grading.rules import USUAL_RULES, Rules
from ...grading.told.scheme import SCHEME, scheme_rows
from ...words import Lang, Words
from ..work import Result
from .items import Item, item_rows
from .queue import queue_rows

Cell = str | float
Rows = list[list[Cell]]
_HEAD = (Words("学号", "number"), Words("姓名", "name"), Words("班级", "class"), Words("卷号", "sheet"))
_TAIL = (
    Words("总分", "total"),
    Words("满分", "of"),
    Words("待人工", "for a person"),
    Words("错误原因", "causes"),
    Words("备注", "remarks"),
)
_LINES = Words("图线", "lines")
_EQUATIONS = Words("方程", "equations")
_NOTHING = Words("没有交", "nothing returned")
_ASIDE = Words("有一行未用，见待人工批改的清单", "a row was not used, see the queue")
_PAGES = (Words("成绩", "grades"), Words("逐题分析", "items"), Words("待人工批改", "queue"), SCHEME)


def grade_rows(results: Sequence[Result], lang: Lang) -> Rows:
    """The header, and a row for each student: problems, answers, lines of drawings, totals."""
    problems = [problem for problem, _ in _first(results)]
    columns, drawn = _columns(results), [name for name in problems if any(one.marks[name].lines for one in results)]
    head = [*(word.of(lang) for word in _HEAD), *problems, *(f"{problem}:{key}" for problem, key in columns)]
    ticked = [name for name in problems if any(one.marks[name].equations for one in results)]
    head += [f"{problem}:{_LINES.of(lang)}" for problem in drawn]
    head += [f"{problem}:{_EQUATIONS.of(lang)}" for problem in ticked]
    rows = [_row(one, problems, columns, (drawn, ticked), lang) for one in results]
    return [[*head, *(word.of(lang) for word in _TAIL)], *rows]


def _first(results: Sequence[Result]) -> list[tuple[str, Marked]]:
    return list(results[0].marks.items()) if results else []


def _columns(results: Sequence[Result]) -> list[tuple[str, str]]:
    """What is worth something to somebody: lines that a drawing pays are worth nothing as numbers."""
    worth = {
        (problem, one.key)
        for result in results
        for problem, marked in result.marks.items()
        for one in marked.key.quantities
        if one.points.total
    }
    every = [(problem, one.key) for problem, marked in _first(results) for one in marked.key.quantities]
    return [column for column in every if column in worth]


def _row(
    result: Result,
    problems: Sequence[str],
    columns: Sequence[tuple[str, str]],
    beside: tuple[Sequence[str], Sequence[str]],
    lang: Lang,
) -> list[Cell]:
    """beside: the problems that somebody drew, and those whose equations somebody ticked."""
    points = {
        (problem, one.key): one.earned.total for problem, marked in result.marks.items() for one in marked.findings
    }
    drawn, ticked = beside
    lines = [round(sum(one.earned for one in result.marks[problem].lines), 3) for problem in drawn]
    lines += [round(sum(one.earned for one in result.marks[problem].equations), 3) for problem in ticked]
    waiting = sum(marked.waiting for marked in result.marks.values())
    slips = [
        f"{problem}:{root} {slip}" for problem, marked in result.marks.items() for root, slip in marked.slips.items()
    ]
    remarks = [fault.of(lang) for fault in result.faults] + [_ASIDE.of(lang)] * result.aside
    remarks = remarks or ([] if result.returned else [_NOTHING.of(lang)])
    who = result.student
    return [
        who.number, who.name, who.team, result.sheet, *(result.marks[problem].total for problem in problems),
        *(round(points.get(column, 0.0), 3) for column in columns), *lines, result.total, result.worth,
        float(waiting), "; ".join(slips), "; ".join(remarks),
    ]  # fmt: skip


def xlsx_bytes(results: Sequence[Result], items: Sequence[Item], lang: Lang, rules: Rules = USUAL_RULES) -> bytes:
    """Grades, item analysis, queue, and what everything is worth, on a page each."""
    target = BytesIO()
    book = xlsxwriter.Workbook(target, {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False})
    head = book.add_format({"bold": True, "bg_color": "#DDDDDD"})
    worth = scheme_rows([marked.key for _, marked in _first(results)], rules, lang)
    tables = (grade_rows(results, lang), item_rows(items, lang), queue_rows(results, lang), worth)
    for name, rows in zip(_PAGES, tables, strict=True):
        _page(book.add_worksheet(name.of(lang)), rows, head)
    book.close()
    return target.getvalue()


def _page(page: Any, rows: Rows, head: Any) -> None:
    for i, row in enumerate(rows):
        write_row(page, i, row, head if i == 0 else None)
    page.freeze_panes(1, min(4, len(rows[0])) if rows else 0)
    page.set_column(0, len(rows[0]) if rows else 0, 12)
