"""One answer in two places, by whatever names: the second is told with both places, and never taken in silence."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.marked.classes import NUMBERS, answers, everybody, graded, register
from vecpoly.errors import TableError
from vecpoly.marked.intake.read import read_answers
from vecpoly.marked.intake.returned import Returned

ONE = NUMBERS[0]


def returned(path: Path) -> Returned:
    keys = {"3-9": register().sheets[0].parts[0].key}
    return read_answers(path, keys, lambda number: keys if number in NUMBERS else None, {})


def told(found: Returned) -> list[str]:
    return [f"{one.place.line}:{one.place.column} {one.said.en}" for one in found.faults if one.place]


@pytest.mark.parametrize("other", ["v_E", "v_{E}", "3-9:v_E (mm/s)"])
def test_a_second_column_of_one_quantity_is_told_and_not_used(tmp_path: Path, other: str) -> None:
    """The last of them was taken."""
    (tmp_path / "a.csv").write_text(f"学号,3-9:v_E,ω3,{other}\n{ONE},0.2,1.5 顺,7\n", encoding="utf-8")
    found = returned(tmp_path / "a.csv")
    assert told(found) == ["1:4 it holds what column 2 (3-9:v_E) holds; this column is not used, leave one of them"]
    assert found.answers[ONE, "3-9"].cells["v_E"] == "0.2"


@pytest.mark.parametrize("part", ["v_E mm", "v_E deg", "omega_3 sense"])
def test_another_part_of_the_same_answer_is_no_second_one(tmp_path: Path, part: str) -> None:
    (tmp_path / "a.csv").write_text(f"学号,v_E,omega_3,{part}\n{ONE},0.2,1.5,\n", encoding="utf-8")
    assert not returned(tmp_path / "a.csv").faults


def test_a_second_row_of_one_quantity_in_a_long_table_is_told_and_not_used(tmp_path: Path) -> None:
    turning = [f"{number},{value},rad/s,cw" for number, value in ((ONE, "ω3,1.5"), (ONE, "w3,7"), (NUMBERS[1], "w3,2"))]
    rows = ["学号,量,数值,单位,转向", *turning, f"{ONE},v_E,,m/s,", f"{ONE},v_E,1,m/s,"]
    (tmp_path / "a.csv").write_text("\n".join(rows), encoding="utf-8")
    found = returned(tmp_path / "a.csv")
    (said,) = told(found)
    assert said.startswith("3:2 omega_3 is written in ") and "line 2, column 3 already" in said
    assert found.answers[ONE, "3-9"].cells["omega_3"].startswith("1.5")
    assert found.answers[NUMBERS[1], "3-9"].cells["omega_3"].startswith("2")


def test_two_names_of_one_quantity_in_a_document_are_told_with_the_lines_where_they_stand(tmp_path: Path) -> None:
    cells = "    3-9:\n      ω3: 1.5\n      v_E: 0.2\n      w_3: 7\n"
    text = f"students:\n- student: {ONE}\n  answers:\n{cells}- student: x\n  answers: {{}}\n"
    (tmp_path / "a.yaml").write_text(text, encoding="utf-8")
    found = returned(tmp_path / "a.yaml")
    twice, stranger = told(found)
    assert twice.startswith("7:7 omega_3 is written in ") and "line 5, column 7" in twice
    assert stranger.startswith("8:3 the register has no student x")  # the line was the number of the document
    assert found.answers[ONE, "3-9"].cells["omega_3"] == "1.5"


def test_answers_of_several_students_stand_under_one_name_and_a_bare_list_is_told_so(tmp_path: Path) -> None:
    documents = [{"student": number, "answers": {"3-9": answers(number)}} for number in NUMBERS]
    (tmp_path / "a.json").write_text(json.dumps({"students": documents}), encoding="utf-8")
    assert [one.total for one in graded(tmp_path / "out", tmp_path / "a.json").results] == [20.0] * len(everybody())
    (tmp_path / "a.json").write_text(json.dumps(documents), encoding="utf-8")
    with pytest.raises(TableError, match="stand under students:"):
        returned(tmp_path / "a.json")


def test_a_title_above_the_heads_hides_no_column(tmp_path: Path) -> None:
    """The sign between cells was looked for in the first line alone."""
    (tmp_path / "a.csv").write_text(f"第三次作业\n学号;v_E\n{ONE};0,2\n", encoding="utf-8")
    assert returned(tmp_path / "a.csv").answers[ONE, "3-9"].cells["v_E"] == "0,2"
