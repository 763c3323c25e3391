"""A drawing that is nobody's is told for what it is: a stranger's, of another problem, of a name that tells nothing."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.marked.classes import NUMBERS, answers, graded, wide


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("2099999_3-9.dxf", "the register has no student 2099999"),
        ("2099999/3-9.dxf", "the register has no student 2099999"),
        (f"{NUMBERS[0]}_9-9.dxf", "this class has no problem 9-9; there are 3-9"),
        ("scan.dxf", "its name does not tell whose it is"),
        ("3-9.dxf", "its name does not tell whose it is"),  # and not that of a student of the folder's name
    ],
)
def test_why_a_drawing_is_nobodys_is_told(tmp_path: Path, name: str, said: str) -> None:
    drawing = tmp_path / "drawn" / name
    drawing.parent.mkdir(parents=True)
    drawing.write_bytes(b"0\nEOF\n")
    rows = wide(tmp_path / "a.csv", {NUMBERS[0]: answers(NUMBERS[0])})
    done = graded(tmp_path / "out", rows, drawings=tmp_path / "drawn")
    (fault,) = done.faults
    assert said in fault.words.en and fault.words.zh != fault.words.en
