"""What the key of a class says, typed into its form, has full marks, and no row of the form is at fault."""

from __future__ import annotations

from dataclasses import replace
from io import BytesIO
from pathlib import Path

import openpyxl
import pytest

from tests.grading.cases import key_of, problem_of
from tests.laws import few, soaking
from tests.marked.classes import register
from vecpoly.batch.forms.workbooks import answers_bytes, key_bytes
from vecpoly.batch.register import Exercise, Part, Register, Sheet
from vecpoly.grading.scheme import Scheme
from vecpoly.marked.graded import Order, grade
from vecpoly.problem.library import library
from vecpoly.problem.values.vary import data_of

FEW = ("4-3a", "3-9", "curv-10", "5-2", "boom-thrust", "D-1", "3-7c", "8-4", "whitworth-quick-return")
TABLES = ("tables", "extends")  # of files beside the problem's, which a class has no need of
CASES = sorted(entry.id for entry in library()) if soaking() else few(FEW, 2)


def class_of_one(name: str) -> Register:
    """One student who has the problem as it stands in the library."""
    part = Part(problem=name, attempt=0, values={}, scales=dict(problem_of(name).scales.given), key=key_of(name))
    sheet = Sheet(sheet="S", student=register().sheets[0].student, parts=(part,))
    data = {key: value for key, value in data_of(problem_of(name)).items() if key not in TABLES}
    exercise = Exercise(id=name, data=data, fingerprint="")
    return replace(register(), sheets=(sheet,), exercises=(exercise,))


def typed(form: bytes, key: bytes) -> bytes:
    """The form, filled from the key by the names of their columns: sizes to four digits, senses as arrows."""
    told = openpyxl.load_workbook(BytesIO(key)).worksheets[0]
    known = {str(head.value).partition("（")[0]: cell.value for head, cell in zip(told[1], told[3], strict=True)}
    book = openpyxl.load_workbook(BytesIO(form))
    page = book.worksheets[0]
    heads = {str(cell.value).partition(":")[2]: cell.column for cell in page[1]}
    for head, column in heads.items():
        if head.endswith(" sense"):
            page.cell(3, column).value = "↺" if float(str(known[head[:-6]])) > 0 else "↻"
        elif head and isinstance(value := known[head], int | float):
            page.cell(3, column).value = float(f"{abs(value) if f'{head} sense' in heads else value:.4g}")
        elif head:
            page.cell(3, column).value = value
    out = BytesIO()
    book.save(out)
    return out.getvalue()


@pytest.mark.parametrize("name", CASES)
def test_the_key_typed_into_the_form_has_full_marks_and_no_row_is_at_fault(name: str, tmp_path: Path) -> None:
    """The row of units was one without a number wherever a force was asked; the point for the scale of a figure with
    nothing but places was nobody's; a thrust, read on no polygon of its own, was asked for in mm; a vector that is
    nothing broke the feedback sheet."""
    one = class_of_one(name)
    answers = tmp_path / "answers.xlsx"
    answers.write_bytes(typed(answers_bytes(one), key_bytes(one)))
    done = grade(
        Order(register=one, files=(answers,), out=tmp_path / "out", scheme=Scheme(), lang="zh"), lambda *_: None
    )
    (result,) = done.results
    assert not done.faults and result.returned
    assert result.total == pytest.approx(result.worth) and result.worth > 0
