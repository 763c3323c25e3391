"""Whose work it is: copied answers, and rows that were mixed up."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from tests.marked.classes import NUMBERS, answers, everybody, graded, register, wide
from vecpoly.grading.scheme import Scheme
from vecpoly.marked.graded import Order, grade


def test_one_students_answers_are_wrong_with_anothers_numbers(tmp_path: Path) -> None:
    mixed = everybody() | {NUMBERS[0]: answers(NUMBERS[1])}
    done = graded(tmp_path / "out", wide(tmp_path / "a.csv", mixed))
    mine = done.results[0]
    assert NUMBERS[1] in mine.faults[0].en and not any(one.chain for one in mine.marks["3-9"].findings)
    assert mine.total < 15 and done.results[1].total == 20 and not done.results[1].faults


def test_anothers_values_are_known_though_their_lengths_were_found_by_ones_own_scale(tmp_path: Path) -> None:
    mine, theirs = (register().sheet(number) for number in NUMBERS[:2])
    assert mine is not None and theirs is not None
    key, copied = mine.parts[0].key, answers(NUMBERS[1])
    scaled = {
        f"3-9:{name} mm": f"{theirs.parts[0].key[name].exact / key.scales[key[name].mu] * 1.3:.1f}"
        for name in copied
        if key[name].mu in key.scales
    }
    own = {f"3-9:mu_{letter}": f"{key.scales[f'mu_{letter}'] / 1.3:.5g}" for letter in "va"}
    row = {f"3-9:{name}": text for name, text in copied.items()} | scaled | own
    (result, *_) = graded(tmp_path / "out", wide(tmp_path / "a.csv", {NUMBERS[0]: row})).results
    assert NUMBERS[1] in result.faults[0].en and not result.marks["3-9"].slips


def test_a_row_with_the_sheet_of_another_student_is_told_and_not_used(tmp_path: Path) -> None:
    """As where the answers were sorted without the column of numbers."""
    one, two, three = NUMBERS
    rows = {
        one: {"卷号": "S1"} | answers(two),
        two: {"卷号": "s-1"} | answers(two),
        three: {"卷号": ""} | answers(three),
    }
    done = graded(tmp_path / "out", wide(tmp_path / "a.csv", rows))
    (fault,) = done.faults
    assert fault.code == "other-sheet" and "line 3, column 2" in fault.words.en and "S0" in fault.said.en
    assert [result.total for result in done.results] == [0.0, 20.0, 20.0]
    assert [result.aside for result in done.results] == [True, False, False]
    queue, grades = ((tmp_path / "out" / name).read_text("utf-8-sig") for name in ("queue.csv", "grades.csv"))
    assert f"{one}," in queue and "有一行或一份图未用" in grades and "没有交" not in grades


def test_a_row_with_the_name_of_another_student_is_told_and_not_used_and_a_nickname_is_no_matter(
    tmp_path: Path,
) -> None:
    one, two, three = NUMBERS
    names = {sheet.student.number: sheet.student.name for sheet in register().sheets}
    rows = {number: {"姓名": names[number]} | answers(number) for number in NUMBERS}
    rows[one]["姓名"], rows[three]["姓名"] = names[two], "阿三"
    done = graded(tmp_path / "out", wide(tmp_path / "a.csv", rows))
    assert [fault.code for fault in done.faults] == ["other-name"] and names[two] in done.faults[0].said.en
    assert [result.total for result in done.results] == [0.0, 20.0, 20.0]


def test_the_first_row_without_a_number_is_told_where_it_holds_answers(tmp_path: Path) -> None:
    """Under the header stands the row of units as a rule, which belongs to nobody."""
    form = wide(tmp_path / "a.csv", {"": answers(NUMBERS[0])} | everybody())
    head, units, *rows = form.read_text("utf-8").splitlines()
    form.write_text("\n".join((head, *rows)), "utf-8")
    done = graded(tmp_path / "out", form)
    assert [(fault.code, fault.place.line) for fault in done.faults if fault.place] == [("no-number", 2)] and units


def test_of_copied_answers_equations_and_own_scales_are_paid_as_anybodys(tmp_path: Path) -> None:
    """Their rows were lost, with their points among those that could be had."""
    sheet = register().sheet(NUMBERS[0])
    assert sheet is not None
    key = sheet.parts[0].key
    ticks = {row.key: "".join("✓" if known else "?" for known in row.known) for row in key.equations}
    assert sum(row.points for row in key.equations) > 0
    rows = everybody() | {NUMBERS[0]: answers(NUMBERS[1])}
    rows = {number: cells | ticks for number, cells in rows.items()}
    (mine, *others) = graded(tmp_path / "out", wide(tmp_path / "a.csv", rows)).results
    assert NUMBERS[1] in mine.faults[0].en
    assert mine.worth == 20.0 and [one.total for one in others] == [20.0, 20.0]
    earned = sum(one.earned for one in mine.marks["3-9"].equations)
    assert earned == pytest.approx(sum(row.points for row in key.equations))


def test_who_has_no_name_in_the_register_hides_no_other_row(tmp_path: Path) -> None:
    """A row without a name was that of the nameless student, in a column that there was not."""
    first, *others = register().sheets
    nameless = replace(register(), sheets=(replace(first, student=replace(first.student, name="")), *others))
    answered = wide(tmp_path / "a.csv", everybody())
    order = Order(
        register=nameless, files=(answered,), out=tmp_path / "out", scheme=Scheme(), lang="zh", feedback=False
    )
    done = grade(order, lambda *_: None)
    assert not done.faults and [one.total for one in done.results] == [20.0] * 3
