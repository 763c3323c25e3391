"""Rosters as schools export them; what is wrong with a row is told with its place, and does not stop the others."""

from __future__ import annotations

from pathlib import Path

import openpyxl
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.batch.roster import RosterError, plain, read_roster
from vecpoly.batch.student import Student
from vecpoly.limits import PERSON

ROWS = "学号,姓名,班级\n20230001,王小明,机械 1 班\n20230002,李雷,机械 2 班\n"
TWO = (
    Student(number="20230001", name="王小明", team="机械 1 班"),
    Student(number="20230002", name="李雷", team="机械 2 班"),
)


def roster(folder: Path, data: bytes) -> Path:
    path = folder / "名单.csv"
    path.write_bytes(data)
    return path


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "gb18030"])
@pytest.mark.parametrize("mark", [",", ";", "\t", "，"])
def test_encodings_and_separators_are_found_out(tmp_path: Path, encoding: str, mark: str) -> None:
    assert read_roster(roster(tmp_path, ROWS.replace(",", mark).encode(encoding))).students == TWO


def test_a_workbook_is_read_with_numbers_as_numbers_and_lines_above_its_header(tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    assert book.active is not None
    for row in (
        ("2023 级名单",),
        (),
        ("序号", "姓名", "学号", "行政班"),
        (1, "王小明", 20230001, "机械 1 班"),
        (2, "李雷", 20230002.0, "机械 2 班"),
    ):
        book.active.append(row)
    book.save(tmp_path / "a.xlsx")
    assert read_roster(tmp_path / "a.xlsx").students == TWO


def test_headers_may_be_spaced_out(tmp_path: Path) -> None:
    """学 号, 姓　名, as many schools print them to fill a column."""
    assert read_roster(roster(tmp_path, ROWS.replace("学号,姓名", "学 号,姓　名").encode())).students == TWO


def test_full_width_digits_are_digits(tmp_path: Path) -> None:
    assert read_roster(roster(tmp_path, ROWS.replace("20230002", "２０２３０００２").encode())).students == TWO


def test_numbers_that_were_written_out_as_decimals_are_those_of_the_students(tmp_path: Path) -> None:
    """20230001.0, as a table of numbers is written by some programs: nobody on the roster had returned anything."""
    assert read_roster(roster(tmp_path, ROWS.replace("20230001", "20230001.0").encode())).students == TWO
    short = read_roster(roster(tmp_path, ROWS.replace("20230001", "7.0").encode())).students
    assert [one.number for one in short] == ["7.0", "20230002"]


@given(st.integers(0, 10**10))
def test_a_number_is_the_same_text_however_it_was_kept(number: int) -> None:
    wide = "".join(chr(ord(digit) + 0xFEE0) for digit in str(number))
    assert plain(number) == plain(float(number)) == plain(wide) == plain(f" {number}\u3000") == str(number)


def test_a_number_that_stands_twice_is_refused_with_both_rows(tmp_path: Path) -> None:
    with pytest.raises(RosterError) as refused:
        read_roster(roster(tmp_path, (ROWS + "20230001,王二,机械 1 班\n").encode()))
    assert "rows 2 and 4" in refused.value.words.en and "第 2 行和第 4 行" in refused.value.words.zh


def test_a_bad_row_is_told_and_the_others_are_kept(tmp_path: Path) -> None:
    found = read_roster(roster(tmp_path, (ROWS + ",无号,机械 1 班\n2023/9,斜,机械 1 班\n").encode()))
    assert found.students == TWO
    assert [(fault.place.line, fault.place.column) for fault in found.faults if fault.place] == [(4, 1), (5, 1)]
    assert "2023/9" in found.faults[1].words.en


def test_a_name_too_long_for_a_line_and_a_file_is_told_and_the_others_are_kept(tmp_path: Path) -> None:
    found = read_roster(roster(tmp_path, (ROWS + f"7,{'长' * (PERSON + 1)},机械 1 班\n").encode()))
    assert found.students == TWO and str(PERSON) in found.faults[0].words.zh


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"a,b\n1,2\n", "no column of student numbers"),
        (b"\xff\xff\xff\xff", "neither UTF-8 nor GB 18030"),
        ("学号\n".encode(), "no students"),
    ],
)
def test_what_is_no_roster_is_refused_with_its_reason(tmp_path: Path, data: bytes, says: str) -> None:
    with pytest.raises(RosterError, match=says):
        read_roster(roster(tmp_path, data))


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "gb18030"])
def test_a_roster_is_read_whatever_ends_its_lines_and_however_it_is_encoded(
    tmp_path: Path, end: str, encoding: str
) -> None:
    """Lines of an old Macintosh ended in a traceback, and what is saved as Unicode text was refused."""
    assert read_roster(roster(tmp_path, ROWS.replace("\n", end).encode(encoding))).students == TWO


def test_a_roster_whose_quotes_nothing_closes_is_refused_with_the_line(tmp_path: Path) -> None:
    with pytest.raises(RosterError, match="line 2: it cannot be read") as refused:
        read_roster(roster(tmp_path, (ROWS.splitlines()[0] + '\n1,"' + "x" * 200_000 + "\n2,y").encode()))
    assert "第 2 行" in refused.value.words.zh


def test_what_is_no_workbook_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.xlsx").write_bytes(b"no zip")
    with pytest.raises(RosterError, match="no XLSX workbook"):
        read_roster(tmp_path / "a.xlsx")


@pytest.mark.parametrize("head", ["姓名（汉字）", "姓 名 [全名]", "Full_Name (as on the card)"])
@pytest.mark.parametrize("team", ["行政班级", "教学班级（2025）", "Class name"])
def test_what_a_head_says_aside_does_not_hide_a_column(tmp_path: Path, head: str, team: str) -> None:
    found = read_roster(roster(tmp_path, ROWS.replace("姓名,班级", f"{head},{team}").encode()))
    assert found.students == TWO and not found.nameless


def test_where_no_row_can_be_read_the_first_reason_is_told(tmp_path: Path) -> None:
    """It was said that there are no students."""
    with pytest.raises(RosterError, match=r"none of 2 rows can be read; first, .*line 2, column 1.*of over 50"):
        read_roster(roster(tmp_path, f"学号,姓名\n2024001,{'a' * 60}\n2024002,\n".encode()))


def test_a_roster_without_names_says_so(tmp_path: Path) -> None:
    assert read_roster(roster(tmp_path, "学号,电话\n1,2\n".encode())).nameless


def test_a_sum_below_the_list_is_told_and_is_no_student(tmp_path: Path) -> None:
    found = read_roster(roster(tmp_path, "序号,学号,姓名\n1,20230001,王小明\n合计,1,\n".encode()))
    assert [one.number for one in found.students] == ["20230001"]
    assert [fault.place.line for fault in found.faults if fault.place] == [3]


def test_a_class_in_a_merged_cell_is_that_of_all_its_rows_and_a_second_row_of_heads_is_no_student(
    tmp_path: Path,
) -> None:
    book = openpyxl.Workbook()
    page = book.active
    assert page is not None
    for row in (("学号", "姓名", "班级"), ("", "", ""), (1, "甲", "机 1"), (2, "乙", None), (3, "丙", "机 2")):
        page.append(row)
    for cells in ("A1:A2", "B1:B2", "C1:C2", "C3:C4"):
        page.merge_cells(cells)
    book.save(tmp_path / "a.xlsx")
    found = read_roster(tmp_path / "a.xlsx")
    assert [one.team for one in found.students] == ["机 1", "机 1", "机 2"] and not found.faults
