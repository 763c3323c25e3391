"""Cells as people fill them in: scales with a comma, cells that are merged over two students."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest
from openpyxl import Workbook

from tests.grading.cases import key_of
from tests.marked.classes import NUMBERS, answers, everybody, graded, register, wide
from vecpoly.grading.sheet import sheet_of
from vecpoly.marked.intake.heads import head as head_of


@pytest.mark.parametrize(
    "text", ["0.006", "0,006", "0．006", "6×10^-3", "6e-3", "0,006 (m/s)/mm", "6 mm/s/mm", "0.006 m/s/mm"]
)
def test_a_scale_is_read_as_any_number_is(text: str) -> None:
    """0,006 was refused with “if of thousands, write 0006”, and v = 0,191 beside it was read."""
    sheet = sheet_of(key_of("3-9"), {"mu_v": text})
    assert not sheet.faults and sheet.scales == {"mu_v": pytest.approx(0.006)}


def test_a_scale_that_cannot_be_read_is_told_with_its_name_and_its_problem(tmp_path: Path) -> None:
    rows = {number: cells | {"mu_v": "6,000"} for number, cells in everybody().items()}
    file = wide(tmp_path / "a.csv", rows, mark=";")
    graded(tmp_path / "out", file)
    queue = list(csv.DictReader((tmp_path / "out" / "queue.csv").read_text("utf-8-sig").splitlines()))
    assert len(queue) == 3 and all("题 3-9：μ_v = 6,000" in row["原因"] for row in queue)
    grades = list(csv.DictReader((tmp_path / "out" / "grades.csv").read_text("utf-8-sig").splitlines()))
    assert [float(row["待人工"]) for row in grades] == [1, 1, 1]


@pytest.mark.parametrize("text", ["0", "-0.006", "0 m/s/mm"])
def test_a_scale_that_is_not_above_zero_is_told(text: str) -> None:
    """It was left out without a word."""
    sheet = sheet_of(key_of("3-9"), {"mu_v": text})
    assert not sheet.scales and [str(one.en) for one in sheet.faults] == [
        f"μ_v = {text}: a scale must be above zero; correct it"
    ]


@pytest.mark.parametrize("mark", [",", ";"])
def test_answers_of_a_number_that_was_written_out_as_a_decimal_are_its_students(tmp_path: Path, mark: str) -> None:
    file = wide(tmp_path / "a.csv", {f"{number}.0": cells for number, cells in everybody().items()}, mark=mark)
    done = graded(tmp_path / "out", file)
    assert not done.faults and all(one.returned for one in done.results)


def test_a_cell_merged_over_several_students_is_told_of_those_who_have_none(tmp_path: Path) -> None:
    """A spreadsheet keeps it with the first: the others were blank without a word."""
    book = Workbook()
    page = book.active
    assert page is not None
    cells = everybody()
    page.append(["作业 3", *[""] * 3])
    page.merge_cells("A1:D2")
    page.append([])
    page.append(["学号", *cells[NUMBERS[0]]])
    for number, row in cells.items():
        page.append([number, *row.values()])
    page.merge_cells("C4:C5")
    book.save(tmp_path / "a.xlsx")
    done = graded(tmp_path / "out", tmp_path / "a.xlsx")
    assert [(one.code, one.numbers["student"]) for one in done.faults] == [("merged", NUMBERS[1])]
    assert "line 5, column 3" in done.faults[0].words.en
    assert [one.aside for one in done.results] == [False, True, False]


@pytest.mark.parametrize("way", ["{}", "{} mm", "{}ｍｍ", "{}毫米", "约{}", "{} mm 左右", "l={}"])
def test_a_length_has_the_unit_of_its_column_where_none_is_written(tmp_path: Path, way: str) -> None:
    """４９．２ｍｍ in a column of mm was '49.2 mm mm', and cost the mark for units."""
    one = register().sheets[0].parts[0].key["v_E"]
    assert one.mm is not None and one.line
    cells = {"v_E deg": "", "v_E mm": way.format(round(one.mm, 1))}
    file = wide(tmp_path / "a.csv", {NUMBERS[0]: cells})
    result = graded(tmp_path / "m", file).results[0]
    found = result.marks["3-9"][one.line]
    assert [each.id.value for each in found.messages] == ["ok"] and not result.marks["3-9"].lost
    assert result.places["3-9", one.line].column == 3


def test_a_unit_that_is_typed_beside_its_column_too_is_one_unit(tmp_path: Path) -> None:
    cells = answers(NUMBERS[0])
    rows = (f"{NUMBERS[0]},{key},{cells[key]} m/s,m/s" for key in ("v_E", "v_C2B"))
    (tmp_path / "a.csv").write_text("\n".join(("student,step,value,unit", *rows)), encoding="utf-8")
    marks = graded(tmp_path / "m", tmp_path / "a.csv").results[0].marks["3-9"]
    assert marks["v_E"].is_right and marks["v_C2B"].is_right and not marks.lost


@pytest.mark.parametrize("head", ["v_E (m/s)", "v_E/(m·s⁻¹)", "v_E [mm/s]", "3-9:v_E（mm/s）", "v_E, m/s"])
@pytest.mark.parametrize("behind", ["", " ∠{:.0f}°", " m/s"])
def test_a_head_may_name_the_unit_of_its_column(tmp_path: Path, head: str, behind: str) -> None:
    """As tables are headed: it was refused, and values in mm/s below it would have been taken for m/s."""
    one = register().sheets[0].parts[0].key["v_E"]
    size = abs(one.exact) * (1000 if "mm" in head and "m/s" not in behind else 1)
    text = f"{size:.4g}" + behind.format(one.degrees)
    file = wide(tmp_path / "a.csv", {NUMBERS[0]: {head: text}}, mark=";")
    done = graded(tmp_path / "m", file)
    assert not done.faults and done.results[0].marks["3-9"]["v_E"].is_right and not done.results[0].marks["3-9"].lost


@pytest.mark.parametrize(
    ("head", "part"), [("v_E (mm)", "mm"), ("v_E/mm", "mm"), ("v_E (°)", "deg"), ("v_E (deg)", "deg")]
)
def test_mm_and_degrees_of_a_vector_are_its_length_and_its_direction(head: str, part: str) -> None:
    assert head_of(head, {"3-9": key_of("3-9")}).part.value == part
