"""vecpoly class and vecpoly variants at the command line."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from tests.batch.homework import TEXT, files
from vecpoly.batch.register import read_register
from vecpoly.cli import app
from vecpoly.problem.assignment import load_assignment

ROSTER = "学号,姓名,班级\n20230001,王小明,1\n,无号,1\n20230003,李雷,1\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("hw3.yaml").write_text(TEXT, encoding="utf-8")
    Path("名单.csv").write_bytes(ROSTER.encode("gb18030"))
    return tmp_path


def test_one_bad_row_never_stops_the_rest(folder: Path) -> None:
    done = CliRunner().invoke(app, ["class", "hw3.yaml", "--roster", "名单.csv", "-o", "hw", "-j", "1"])
    assert done.exit_code == 2 and "名单.csv, line 3, column 1" in done.stderr
    assert [sheet.student.number for sheet in read_register(folder / "hw").sheets] == ["20230001", "20230003"]
    made = {path.name for path in (folder / "hw").iterdir()}
    assert {
        "questions",
        "solutions",
        "register.json",
        "key.xlsx",
        "answers.xlsx",
        "questions.pdf",
        "questions.zip",
        "moodle-cloze.xml",
    } <= made
    assert "% of the draws pass" in done.stderr


def test_a_second_run_changes_no_byte(folder: Path) -> None:
    def made() -> dict[str, bytes]:
        CliRunner().invoke(app, ["class", "hw3.yaml", "--roster", "名单.csv", "-o", "hw", "-j", "1"])
        return files(folder / "hw")

    first = made()
    assert len(first) >= 12 and made() == first
    (folder / "hw" / "questions" / "20230001_王小明.pdf").unlink()
    assert made() == first


def test_a_statement_that_tells_a_varied_value_is_named(folder: Path) -> None:
    Path("hw3.yaml").write_text(
        TEXT.replace("    scales: null\n", "    scales: null\n    statement: 曲柄 AB = 30 mm。\n"), encoding="utf-8"
    )
    done = CliRunner().invoke(app, ["variants", "hw3.yaml", "-n", "0"])
    assert "the statement says AB = 30 mm" in done.stdout


def test_the_yield_is_shown_before_anything_is_printed(folder: Path) -> None:
    done = CliRunner().invoke(app, ["variants", "hw3.yaml", "-n", "2"])
    assert done.exit_code == 0
    assert "% of the draws pass" in done.stdout and done.stdout.count("AB = ") == 2


@pytest.mark.parametrize(("extra", "says"), [(["--shard", "4/4"], "0/4"), (["--profile", "none.yaml"], "none.yaml")])
def test_a_wrong_option_is_refused_in_a_sentence(folder: Path, extra: list[str], says: str) -> None:
    done = CliRunner().invoke(app, ["class", "hw3.yaml", "--roster", "名单.csv", "-o", "hw", "-j", "1", *extra])
    assert done.exit_code == 2 and says in done.stderr and "Traceback" not in done.stderr


def test_the_assignment_of_the_manual_is_one(tmp_path: Path) -> None:
    text = (Path(__file__).parents[2] / "docs" / "class.md").read_text(encoding="utf-8")
    first = text.partition("```yaml\n")[2].partition("```")[0]
    (tmp_path / "hw3.yaml").write_text(first, encoding="utf-8")
    found = load_assignment(tmp_path / "hw3.yaml")
    assert [bool(problem.ranges) for problem in found.problems] == [True, False] and found.id == "hw3"
