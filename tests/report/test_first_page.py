"""Claims about the first page of a report: nothing on it is said twice."""

from __future__ import annotations

from functools import cache
from io import BytesIO

import pdfplumber

from tests.each import each
from vecpoly.problem.load import load
from vecpoly.report.document import report_bytes
from vecpoly.solution import solve


@cache
def _pages(*names: str) -> tuple[str, ...]:
    data = report_bytes([solve(load(name), repeats=20) for name in names], lang="en")
    with pdfplumber.open(BytesIO(data)) as document:
        return tuple(page.extract_text() for page in document.pages)


def test_the_running_head_begins_on_the_second_page() -> None:
    first, second, *_ = _pages("3-1a")
    title = "Problem 3-1a: Instant centres of an offset slider-crank"
    assert first.count(title) == 1 and second.startswith(title)


@each([("3-1a", True), ("8-3a", True), ("3-7e", False)])
def test_what_is_asked_is_not_told_again_where_the_statement_asks_by_the_same_symbols(case: tuple[str, bool]) -> None:
    name, once = case
    assert ("\nFind: " not in _pages(name)[0]) is once
