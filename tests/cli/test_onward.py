"""--then analyse: every command goes on with the linkage that a synthesis found, and says so of what is none."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

import vecpoly.solution
from vecpoly.cli import app
from vecpoly.solution import Solution
from vecpoly.words import Words

Run = Callable[..., Result]
FOUND = "8-4-1"  # solution 1 of 8-4


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)
    return lambda *words: CliRunner().invoke(app, [str(word) for word in words], prog_name="vecpoly")


def test_solve_prints_and_writes_the_synthesis_and_the_motion_of_what_it_found(run: Run) -> None:
    result = run("solve", "8-4", "--then", "analyse", "--json", "out.json")
    assert result.exit_code == 0 and "Motion of the linkage that was found (solution 1)" in result.output
    first, second = json.loads(Path("out.json").read_text())
    assert (first["id"], second["id"]) == ("8-4", FOUND) and {"v_C", "alpha_3"} <= set(second["answers"])


def test_a_report_has_both_and_a_question_sheet_only_the_linkage(run: Run) -> None:
    from pypdf import PdfReader

    for style, name, pages in (("solution", f"{FOUND}.en.pdf", 2), ("question", f"{FOUND}.question.en.pdf", 1)):
        assert run("report", "8-4", "--then", "analyse", "--style", style, "--lang", "en").exit_code == 0
        said = "".join(page.extract_text() for page in PdfReader(name).pages).replace("\u2009", " ")
        assert "Motion of the linkage that was found" in said
        assert ("limit position" in said) is (pages == 2)


@pytest.mark.parametrize("words", [("cycle", "8-4"), ("draw", "8-4", "-o", "x.svg"), ("export", "8-4", "-o", "x.ggb")])
def test_cycle_draw_and_export_take_the_linkage(run: Run, words: tuple[str, ...]) -> None:
    assert run(*words).exit_code != 0 or words[0] == "draw", "without it they have the synthesis, which does not move"
    result = run(*words, "--then", "analyse")
    assert result.exit_code == 0, result.output


@pytest.mark.parametrize("command", ["solve", "report", "cycle", "draw", "play", "export"])
def test_what_is_no_synthesis_is_refused(run: Run, command: str) -> None:
    result = run(command, "3-9", "--then", "analyse")
    assert result.exit_code == 2 and "only a task of synthesis does" in result.output


def test_the_alarm_of_the_linkage_is_one_of_the_command(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    made = vecpoly.solution.solve

    def alarmed(problem: Any, **how: Any) -> Solution:
        solution = made(problem, **how)
        if problem.id != FOUND:
            return solution
        return replace(solution, construction=replace(solution.construction, warning=Words("红", "red")))

    monkeypatch.setattr(vecpoly.solution, "solve", alarmed)
    result = run("solve", "8-4", "--then", "analyse")
    assert result.exit_code == 3 and f"{FOUND}: red" in result.output


@pytest.mark.parametrize("words", [("cycle", "8-4"), ("report", "8-4", "--style", "course")])
def test_a_synthesis_without_a_cycle_of_its_own_is_told_how_to_go_on(run: Run, words: tuple[str, ...]) -> None:
    result = run(*words)
    assert result.exit_code == 2 and "8-4 is a synthesis" in result.output and "--then analyse" in result.output


@pytest.mark.parametrize("name", ["cognates", "8-1"])
def test_a_synthesis_that_ends_in_no_single_linkage_says_so(run: Run, name: str) -> None:
    result = run("solve", name, "--then", "analyse")
    assert result.exit_code == 2 and "is a task of synthesis, but its result is no single linkage" in result.output
