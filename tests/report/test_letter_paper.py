"""Claims about Letter paper: every page has its format, answers stay true, nothing leaves the frame."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

import pikepdf
import pytest
from typer.testing import CliRunner

from tests.laws import few
from tests.studies import in_small
from vecpoly import load, loads, solve
from vecpoly.cli import app
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.drawing.sheets.space import FRAME
from vecpoly.errors import NotAskedError, ProblemFileError
from vecpoly.report.document import report_bytes

POINTS = 72 / 25.4
SIZES = {(612.0, 792.0), (792.0, 612.0)}
NAMES = ("3-9", "4-3a", "8-15", "6-1", "7-1", "2-6", "cam-flat-face")


def sizes(pdf: bytes) -> set[tuple[float, float]]:
    """Width and height of all pages, in points."""
    with pikepdf.open(BytesIO(pdf)) as read:
        return {(round(float(page.mediabox[2]), 3), round(float(page.mediabox[3]), 3)) for page in read.pages}


@pytest.mark.parametrize("style", few(["solution", "question"], 2))
def test_every_page_of_a_report_on_letter_paper_is_letter(style: str) -> None:
    solutions = [solve(load(name).on("letter"), repeats=0, precise=False) for name in few(NAMES, 3)]
    assert sizes(report_bytes(solutions, style=style)) <= SIZES


def test_a_course_report_is_printed_on_letter_paper_with_its_cover() -> None:
    solution = solve(load("D-3-knife").on("letter"), repeats=0, precise=False)
    with in_small():
        assert sizes(report_bytes([solution], style="course", lang="en")) <= SIZES


@pytest.mark.parametrize("name", few(NAMES, 2))
def test_what_is_drawn_on_letter_paper_stays_within_its_frame_and_agrees_with_the_exact_answers(name: str) -> None:
    solution = solve(load(name).on("letter"), by="exact", repeats=0, precise=False)
    for sheet in sheets(solution.construction, on=solution.problem.paper, plates=True, bands=False):
        width, height = sheet.size
        assert sheet.plate or sorted((width, height)) == pytest.approx([215.9, 279.4])
        for one in sheet.figures:
            e = one.extents
            assert e.x0 >= FRAME and e.y0 >= FRAME and e.x1 <= width - FRAME and e.y1 <= height - FRAME
    for answer in solution.answers.values():
        if answer.exact is not None and answer.drawn is not None:
            assert answer.drawn == pytest.approx(answer.exact, rel=1e-6, abs=1e-9)


def test_figures_that_fill_an_a4_sheet_have_scales_of_their_own_on_letter_paper() -> None:
    made = [solve(problem, repeats=0, precise=False) for problem in (load("3-9"), load("3-9").on("letter"))]
    a4, letter = ({figure.view: figure.scale.value for figure in one.construction.figures} for one in made)
    assert all(letter[view] >= a4[view] for view in a4)


def test_problems_on_paper_of_two_formats_are_not_bound_together() -> None:
    solutions = [solve(problem, repeats=0, precise=False) for problem in (load("2-6"), load("3-9").on("letter"))]
    with pytest.raises(NotAskedError, match="--paper"):
        report_bytes(solutions)


def test_the_command_line_chooses_the_paper_of_all_problems(tmp_path: Path) -> None:
    pdf = tmp_path / "a.pdf"
    ended = CliRunner().invoke(app, ["report", "2-6", "3-9", "--paper", "letter", "-o", str(pdf)])
    assert not ended.exit_code and sizes(pdf.read_bytes()) <= SIZES


def test_a_format_that_nobody_knows_is_refused_at_its_place() -> None:
    text = load("3-9").text + "\nsheet: {format: A3}\n"
    with pytest.raises(ProblemFileError, match="A4") as refused:
        loads(text)
    assert any("format" in fault.path for fault in refused.value.faults)
