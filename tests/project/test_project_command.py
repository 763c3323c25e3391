"""vecpoly design: exit codes, and what other commands say of a project."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from tests.project.test_project_files import GOOD
from vecpoly.cli.app import app


@pytest.mark.parametrize(("asked", "code", "said"), [("1.25", 0, "met"), ("1.4", 1, "NOT MET")])
def test_the_exit_code_tells_whether_the_demands_are_met(tmp_path: Path, asked: str, code: int, said: str) -> None:
    path, out = tmp_path / "feeder.yaml", tmp_path / "out.pdf"
    path.write_text(GOOD.replace("K = 1.25 within", f"K = {asked} within"), encoding="utf-8")
    done = CliRunner().invoke(app, ["design", str(path), "-o", str(out), "--lang", "en"])
    assert done.exit_code == code, done.output
    assert said in done.output and out.read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize(("name", "command"), [("design-shaper", "design"), ("search-path", "search")])
def test_solve_refuses_what_is_no_problem_and_names_the_right_command(name: str, command: str) -> None:
    done = CliRunner().invoke(app, ["solve", name])
    assert done.exit_code == 2
    assert f"vecpoly {command}" in done.output


def test_design_refuses_a_problem() -> None:
    done = CliRunner().invoke(app, ["design", "3-9"])
    assert done.exit_code == 2
    assert "vecpoly solve" in done.output
