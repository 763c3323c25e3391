"""Drawings of a class: told whose they are by their names, graded vector by vector, and nobody stops the others."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from tests.marked.classes import NUMBERS, answers, graded, register, wide
from vecpoly import Mistake, Slip, solve
from vecpoly.board.place import View
from vecpoly.export.dxf.document import figure_dxf
from vecpoly.grading.drawings.judging.mark import Verdict
from vecpoly.marked.drawn import grade_drawings
from vecpoly.words import Words

WRONG = Slip(Mistake.HALVED, "v_B")


def silent(_: Words, done: int, of: int) -> None:
    assert 0 < done <= of


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One right drawing, one with the given velocity half as long, one of nobody, one that is none."""
    made = tmp_path_factory.mktemp("drawn")
    for number, slip in ((NUMBERS[0], None), (NUMBERS[1], WRONG)):
        sheet = register().sheet(number)
        assert sheet is not None
        variant = register().variant(sheet.parts[0])
        own = solve(variant, by="exact", repeats=0, precise=False, slip=slip).construction
        (figure,) = (one for one in own.figures if one.view is View.VELOCITY)
        folder = made / number if slip else made
        folder.mkdir(exist_ok=True)
        name = "3-9.dxf" if slip else f"{number}_张三_3-9.dxf"
        (folder / name).write_bytes(figure_dxf(figure))
    (made / "2023009_3-9.dxf").write_text("0\nEOF\n", encoding="ascii")
    (made / f"{NUMBERS[2]}_3-9.dxf").write_text("no drawing", encoding="ascii")
    return made


def test_every_drawing_is_judged_and_what_is_nobodys_is_told(folder: Path, tmp_path: Path) -> None:
    drawn = grade_drawings(register(), folder, tmp_path, "en", silent)
    right = {
        sheet.student.number: all(one.verdict is Verdict.RIGHT for one in mark.vectors)
        for sheet, _, mark in drawn.marks
    }
    assert right == {NUMBERS[0]: True, NUMBERS[1]: False}
    assert len(drawn.faults) == 2 and any("2023009" in one.words.en for one in drawn.faults)
    rows = list(csv.reader((tmp_path / "drawings.csv").read_text("utf-8-sig").splitlines()))
    assert {row[5] for row in rows[1:] if row[0] == NUMBERS[0]} == {"right"}
    assert ["v_B", "wrong"] in [row[4:6] for row in rows[1:] if row[0] == NUMBERS[1]]
    overlays = sorted(path.name for path in (tmp_path / "drawings").iterdir())
    assert overlays == [f"{number}_3-9.pdf" for number in NUMBERS[:2]]
    assert all((tmp_path / "drawings" / name).read_bytes().startswith(b"%PDF") for name in overlays)


def test_points_are_those_of_the_numbers_whatever_was_drawn(folder: Path, tmp_path: Path) -> None:
    file = wide(tmp_path / "a.csv", {number: answers(number) for number in NUMBERS})
    plain, drawn = graded(tmp_path / "plain", file), graded(tmp_path / "drawn", file, drawings=folder)
    assert [one.total for one in plain.results] == [one.total for one in drawn.results]
    assert len(drawn.faults) == 2 and (tmp_path / "drawn" / "drawings.csv").exists()
