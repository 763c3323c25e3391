"""What an assignment says of points and rules holds all over the class, and is refused where it names nothing."""

from __future__ import annotations

import re
from io import BytesIO
from pathlib import Path

import pytest
from openpyxl import load_workbook

from tests.batch.homework import made, people
from vecpoly.batch.forms.columns import columns_of
from vecpoly.batch.forms.workbooks import key_bytes
from vecpoly.batch.register import read_register
from vecpoly.errors import ProblemFileError
from vecpoly.grading.key import Points
from vecpoly.grading.rules import Lines, Rules
from vecpoly.grading.told.scheme import rules_told
from vecpoly.marked.scheme import read_scheme

TEXT = """\
title: {zh: 作业, en: Homework}
id: hw
problems:
  - {problem: 3-9, find: [v_C2B, v_E, omega_3]}
"""
SAID = (
    TEXT
    + """\
rules: {own: 0.5, first: [v_E]}
rubric: {velocity: {scale: 2, drawn: 4, values: 2, rates: 2}}
points:
  3-9:
    v_E: {method: 3, accuracy: 1}
totals: {3-9: 11}
"""
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("class") / "hw"
    made(out, people([1, 2]), SAID)
    return out


def test_the_points_of_the_assignment_stand_in_every_key(folder: Path) -> None:
    register = read_register(folder)
    for sheet in register.sheets:
        key = sheet.parts[0].key
        assert key["v_E"].points == Points(method=3, accuracy=1) and key.stated == {"mu_v": 2}
        assert key["v_C2B"].points == Points(method=2, accuracy=1) and key["omega_3"].points.total == 2
    assert register.scheme.rules.own == 0.5 and read_scheme(None, register) == register.scheme


def test_the_key_has_a_page_of_points_that_adds_up_and_names_the_rules(folder: Path) -> None:
    page = load_workbook(BytesIO(key_bytes(read_register(folder))))["分值"]
    rows = [row for row in page.iter_rows(min_row=2, values_only=True) if row[6] is not None]
    assert rows[-1][6] == 11 == sum(float(str(row[6])) for row in rows[:-1])
    assert ("3-9", "v_E", "速度", 3, 1, 0, 4) in rows
    told = [row[0] for row in page.iter_rows(values_only=True) if row[6] is None]
    assert told == [said.zh for said in rules_told(read_register(folder).scheme.rules)] and "50 %" in str(told[0])


def test_a_file_of_rules_changes_what_it_says_and_nothing_else(folder: Path, tmp_path: Path) -> None:
    register = read_register(folder)
    (tmp_path / "rules.yaml").write_text("rules: {close: 0.25}\npoints: {3-9: {v_C2B: {method: 5}}}\n")
    scheme = read_scheme(tmp_path / "rules.yaml", register)
    key = scheme.key(register.sheets[0].parts[0].key)
    assert (scheme.rules.own, scheme.rules.close) == (0.5, 0.25)
    assert key["v_E"].points.total == 4 and key["v_C2B"].points.total == 5 and key.stated == {"mu_v": 2}


def test_a_length_on_the_way_that_has_points_has_a_column_and_a_place_in_the_key(tmp_path: Path) -> None:
    made(tmp_path / "hw", people([1]), TEXT + "points: {3-9: {pe: {accuracy: 2}, v_B: {method: 1}}}\n")
    register = read_register(tmp_path / "hw")
    assert {"3-9:pe", "3-9:v_B"} <= {column.head for column in columns_of(register)}
    (heads, *_) = load_workbook(BytesIO(key_bytes(register)))["3-9"].iter_rows(values_only=True)
    assert {"pe", "pe T", "v_B"} <= set(heads) and "pd" not in heads


def test_other_points_write_no_page_anew(tmp_path: Path) -> None:
    out = tmp_path / "hw"
    made(out, people([1]), TEXT)
    pages = {
        file: file.stat().st_mtime_ns for folder in ("questions", "solutions") for file in (out / folder).iterdir()
    }
    made(out, people([1]), SAID)
    assert pages and all(file.stat().st_mtime_ns == time for file, time in pages.items())
    assert read_register(out).sheets[0].parts[0].key.worth == 11


@pytest.mark.parametrize(("said", "why"), [
    ("points:\n  3-9: {v_X: {method: 1}}", r"line 6, column 9: points\.3-9\.v_X: no quantity .*did you mean 'v_E'"),
    ("points: {3-90: {v_E: {method: 1}}}", r"line 5, column 10: .*no problem '3-90'; did you mean '3-9'"),
    ("totals: {3-9: 9}", r"line 5, column 10: totals\.3-9: the points of 3-9 come to 8, totals says 9; mend one"),
    ("rules: {clos: 0.5}", r"line 5, column 9: rules\.clos: unknown key 'clos'; did you mean 'close'"),
    ("rubric: {velocity: {drawm: 5}}", r"line 5, column 21: .*unknown key 'drawm'; did you mean 'drawn'"),
    ("rules: {first: [v_E, v_F]}", r"line 5, column 22: rules\.first\[1\]: no quantity 'v_F'"),
])  # fmt: skip
def test_a_wrong_name_is_refused_with_its_line_before_anything_is_drawn(tmp_path: Path, said: str, why: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        made(tmp_path / "hw", people([1]), TEXT + said + "\n")
    assert re.search(why, str(refused.value)) and refused.value.words.zh != refused.value.words.en
    assert not list((tmp_path / "hw").rglob("*"))


@pytest.mark.parametrize(
    ("drawing", "zh", "en"), [("required", "必须交图", "a drawing is required"), ("told", "不由图给分", "none")]
)
def test_what_a_drawing_is_worth_is_told_in_words(drawing: Lines, zh: str, en: str) -> None:
    """In Chinese it read “图线的分数：required”."""
    (said,) = rules_told(Rules(drawing=drawing))
    assert said.zh == f"图线的分数：{zh}" and said.en.endswith(en)
