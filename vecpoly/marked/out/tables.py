"""Grades as tables: a row for each student, a column for each answer, totals, flags; CSV and XLSX say the same."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from io import BytesIO
from typing import Any

import xlsxwriter

from ...batch.forms.workbooks import write_row
from ...grading.key import AnswerKey
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
_BESIDE: tuple[tuple[Words, Callable[[Marked], float | None]], ...] = (  # points beside those of answers; None: no such
    (Words("图线", "lines"), lambda marked: sum(one.earned for one in marked.lines) if marked.lines else None),
    (
        Words("方程", "equations"),
        lambda marked: sum(one.earned for one in marked.equations) if marked.equations else None,
    ),
    (Words("比例尺", "scales"), lambda marked: sum(marked.stated.values()) if marked.key.stated else None),
    (Words("单位", "units"), lambda marked: -marked.lost or None),
)
_NOTHING = Words("没有交", "nothing returned")
_ASIDE = Words("有一行或一份图未用，见待人工批改的清单", "a row or a drawing was not used, see the queue")
_PAGES = (Words("成绩", "grades"), Words("逐题分析", "items"), Words("待人工批改", "queue"), SCHEME)


def grade_rows(results: Sequence[Result], lang: Lang) -> Rows:
    """The header, and a row for each student: problems, answers, lines of drawings, totals."""
    problems = [problem for problem, _ in _first(results)]
    columns = _columns(results)
    head = [*(word.of(lang) for word in _HEAD), *problems, *(f"{problem}:{key}" for problem, key in columns)]
    beside = [
        (name, title, points)
        for title, points in _BESIDE
        for name in problems
        if any(points(one.marks[name]) is not None for one in results)
    ]
    head += [f"{name}:{title.of(lang)}" for name, title, _ in beside]
    others = [[points(one.marks[name]) or 0.0 for name, _, points in beside] for one in results]
    rows = [_row(one, problems, columns, other, lang) for one, other in zip(results, others, strict=True)]
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
    result: Result, problems: Sequence[str], columns: Sequence[tuple[str, str]], beside: Sequence[float], lang: Lang
) -> list[Cell]:
    """beside: the points that are of no answer."""
    points = {
        (problem, one.key): one.earned.total for problem, marked in result.marks.items() for one in marked.findings
    }
    slips = [
        f"{problem}:{root} {slip}" for problem, marked in result.marks.items() for root, slip in marked.slips.items()
    ]
    remarks = [fault.of(lang) for fault in result.faults] + [_ASIDE.of(lang)] * result.aside
    remarks = remarks or ([] if result.returned else [_NOTHING.of(lang)])
    who = result.student
    return [
        who.number, who.name, who.team, result.sheet, *(result.marks[problem].total for problem in problems),
        *(round(points.get(column, 0.0), 3) for column in columns), *(round(one, 3) for one in beside),
        result.total, result.worth, float(result.waiting), "; ".join(slips), "; ".join(remarks),
    ]  # fmt: skip


def xlsx_bytes(
    results: Sequence[Result],
    items: Sequence[Item],
    lang: Lang,
    keys: Sequence[AnswerKey] = (),
    rules: Rules = USUAL_RULES,
) -> bytes:
    """Grades, item analysis, queue, and what everything is worth, on a page each. keys: with the points of the class,
    before anybody's equations and lengths take a share of them."""
    target = BytesIO()
    book = xlsxwriter.Workbook(target, {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False})
    head = book.add_format({"bold": True, "bg_color": "#DDDDDD"})
    worth = scheme_rows(keys, rules, lang)
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
