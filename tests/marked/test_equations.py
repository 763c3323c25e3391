"""The rows of vector equations in a class: typed into the form, marked, counted, told."""

from __future__ import annotations

import csv
from io import BytesIO
from pathlib import Path

import pdfplumber
from openpyxl import load_workbook

from tests.marked.classes import NUMBERS, answers, graded, register, wide
from vecpoly.batch.forms.workbooks import answers_bytes, key_bytes
from vecpoly.marked.out.items import items

ROWS = ("eq1_dir", "eq1_size", "eq2_dir", "eq2_size")
RIGHT = ("?✓✓✓✓", "?✓?✓?", "?✓✓✓✓✓✓", "?✓✓?✓✓?")


def test_the_form_has_a_column_for_each_row_and_the_key_says_what_belongs_there() -> None:
    form = next(load_workbook(BytesIO(answers_bytes(register())))["答案"].iter_rows(values_only=True))
    assert [head for head in form if "eq" in str(head)] == [f"3-9:{row}" for row in ROWS]
    page = list(load_workbook(BytesIO(key_bytes(register())))["3-9"].iter_rows(values_only=True))
    assert tuple(page[2][page[0].index(row)] for row in ROWS) == RIGHT


def test_rows_are_marked_counted_and_told_and_whoever_typed_none_loses_nothing(tmp_path: Path) -> None:
    ticked = dict(zip(ROWS, RIGHT, strict=True))
    signs = (ticked, {**ticked, "eq1_size": "?✓✓✓?"}, dict.fromkeys(ROWS, ""))
    rows = {number: answers(number) | mine for number, mine in zip(NUMBERS, signs, strict=True)}
    done = graded(tmp_path / "out", wide(tmp_path / "a.csv", rows), feedback=True)
    assert [one.total for one in done.results] == [20.0, 19.5, 20.0]
    grades = list(csv.DictReader((tmp_path / "out" / "grades.csv").read_text("utf-8-sig").splitlines()))
    assert [float(row["3-9:方程"]) for row in grades] == [5.0, 4.5, 0.0]
    found = next(one for one in items(done.results) if one.key.en == "equation 1, magnitude")
    assert (found.counts["right"], found.counts["close"]) == (1, 1) and "v_{C2B}" in found.slips[0][0].en
    with pdfplumber.open(tmp_path / "out" / "feedback" / f"{NUMBERS[1]}_李四.pdf") as book:
        text = "".join(page.extract_text() for page in book.pages)
    assert "方程 1 大小" in text and "未知" in text


def test_a_row_that_cannot_be_read_waits_with_what_was_written_and_where(tmp_path: Path) -> None:
    rows = {number: answers(number) | dict.fromkeys(ROWS, "") for number in NUMBERS}
    rows[NUMBERS[1]]["eq1_dir"] = "✓✓"
    graded(tmp_path / "out", wide(tmp_path / "a.csv", rows), lang="en")
    (waiting,) = list(csv.DictReader((tmp_path / "out" / "queue.csv").read_text("utf-8-sig").splitlines()))
    assert (waiting["quantity"], waiting["written"]) == ("equation 1, direction", "✓✓")
    assert "a.csv, line 4, column" in waiting["place"]
    assert "2 terms are written" in waiting["why"] and "manual marking" not in waiting["why"]
