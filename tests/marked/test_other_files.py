"""A file that holds no answers to this class is refused before anybody is marked as one who returned nothing."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.marked.classes import NUMBERS, answers, everybody, graded, register, wide
from vecpoly.errors import TableError
from vecpoly.foundation.slotted import replace
from vecpoly.grading.key import AnswerKey
from vecpoly.marked.intake.heads import head
from vecpoly.marked.intake.read import read_answers


def two_problems() -> dict[str, AnswerKey]:
    key = register().sheets[0].parts[0].key
    return {"3-9": key, "3-12": replace(key, problem="3-12")}


@pytest.mark.parametrize("text", ["学号,姓名,班级\n2023001,张三,机1\n", "学号,4-1:F,4-1:M\n2023001,3,4\n"])
def test_a_roster_or_another_assignments_answers_are_refused(tmp_path: Path, text: str) -> None:
    """Everybody was marked as blank."""
    (tmp_path / "a.csv").write_text(text, encoding="utf-8")
    with pytest.raises(TableError, match="no column holds answers to this class") as raised:
        graded(tmp_path / "out", tmp_path / "a.csv")
    assert raised.value.code == "no-answers" and "3-9:v_E" in str(raised.value) and not (tmp_path / "out").exists()


def test_heads_without_the_problem_do_where_it_is_one_and_with_it_may_name_a_unit(tmp_path: Path) -> None:
    one = {key: value for key, value in two_problems().items() if key == "3-9"}
    for keys, column in ((one, "v_E (mm/s)"), (one, "3-9:v_E (mm/s)"), (two_problems(), "3-9:v_E (mm/s)")):
        (tmp_path / "a.csv").write_text(f"学号,{column}\n{NUMBERS[0]},173\n", encoding="utf-8")
        found = read_answers(tmp_path / "a.csv", keys, {NUMBERS[0]: keys}.__getitem__, {})
        assert not found.faults and "173" in repr(found)


def test_a_form_that_nobody_filled_in_is_answers_all_the_same(tmp_path: Path) -> None:
    blank = {number: dict.fromkeys(answers(number), "") for number in NUMBERS}
    assert not any(one.returned for one in graded(tmp_path / "out", wide(tmp_path / "a.csv", blank)).results)


def test_a_problem_that_the_class_has_not_is_told_once_however_many_columns_are_of_it(tmp_path: Path) -> None:
    keys = two_problems()
    heads = ["3-9:v_E", "7-7:v_E", "7-7:v_B", "8-8:x", "omega_3"]
    lines = ["学号," + ",".join(heads), f"{NUMBERS[0]}" + ",1" * len(heads)]
    (tmp_path / "a.csv").write_text("\n".join(lines), encoding="utf-8")
    found = read_answers(tmp_path / "a.csv", keys, lambda number: keys, {})
    told = [one.said.en for one in found.faults]
    assert [text.partition(";")[0] for text in told[:2]] == [
        "this class has no problem 7-7",
        "this class has no problem 8-8",
    ]
    assert len(told) == 3 and "does not say of which problem" in told[2]


def test_a_length_whose_letters_have_a_colon_is_no_problem_of_that_name() -> None:
    """“force 3:bc” on a page that is of one problem."""
    key = register().sheets[0].parts[0].key
    first = replace(key.quantities[0], key="force 3:bc")
    assert head("force 3:bc", {"3-9": replace(key, quantities=(first,))}).symbol == "force 3:bc"


def test_another_page_without_answers_is_no_matter(tmp_path: Path) -> None:
    from openpyxl import Workbook

    book = Workbook()
    page = book.active
    assert page is not None
    cells = everybody()
    page.append(["学 号", *cells[NUMBERS[0]]])
    for number, row in cells.items():
        page.append([number, *row.values()])
    book.create_sheet("名单").append(["学号", "姓名"])
    book.save(tmp_path / "a.xlsx")
    done = graded(tmp_path / "out", tmp_path / "a.xlsx")
    assert [one.total for one in done.results] == [20.0] * 3 and not done.faults
