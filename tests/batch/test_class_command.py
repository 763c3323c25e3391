"""vecpoly class and vecpoly variants at the command line."""

from __future__ import annotations

import shutil
from contextlib import chdir
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from tests.batch.homework import TEXT, files, piloted, remembered
from vecpoly.batch.register import read_register
from vecpoly.cli import app
from vecpoly.problem.assignment import load_assignment

ROSTER = "学号,姓名,班级\n20230001,王小明,1\n,无号,1\n20230003,李雷,1\n"


COMMAND = ("class", "hw3.yaml", "--roster", "名单.csv", "-o", "hw", "-j", "1")


def prepared(folder: Path, text: str = TEXT) -> None:
    """An assignment and a roster in the folder."""
    (folder / "hw3.yaml").write_text(text, encoding="utf-8")
    (folder / "名单.csv").write_bytes(ROSTER.encode("gb18030"))


def run(folder: Path, *words: str) -> Result:
    """The command, given in this folder."""
    with chdir(folder), piloted():
        return CliRunner().invoke(app, words)


@pytest.fixture(scope="module")
def first(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Result]:
    """The class, made once, and what was said of it."""
    folder = tmp_path_factory.mktemp("first")
    prepared(folder)
    return folder, run(folder, *COMMAND)


@pytest.fixture(scope="module")
def variants(tmp_path_factory: pytest.TempPathFactory) -> Result:
    """Two variants, of a problem whose statement tells a value that is varied."""
    told = TEXT.replace("    scales: null\n", "    scales: null\n    statement: 曲柄 AB = 30 mm。\n")
    folder = tmp_path_factory.mktemp("variants")
    prepared(folder, told)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("vecpoly.variants.pilot.pilot", remembered)
        return run(folder, "variants", "hw3.yaml", "-n", "2")


def test_one_bad_row_never_stops_the_rest(first: tuple[Path, Result]) -> None:
    folder, done = first
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


def test_a_second_run_changes_no_byte_and_makes_again_what_is_lost(first: tuple[Path, Result], tmp_path: Path) -> None:
    shutil.copytree(first[0], tmp_path, dirs_exist_ok=True)
    (tmp_path / "hw" / "questions" / "20230001_王小明.pdf").unlink()
    run(tmp_path, *COMMAND)
    made = files(tmp_path / "hw")
    assert len(made) >= 12 and made == files(first[0] / "hw")


def test_a_statement_that_tells_a_varied_value_is_named(variants: Result) -> None:
    assert "the statement says AB = 30 mm" in variants.stdout


def test_the_yield_is_shown_before_anything_is_printed(variants: Result) -> None:
    assert variants.exit_code == 0
    assert "% of the draws pass" in variants.stdout and variants.stdout.count(": AB = ") == 2


@pytest.mark.parametrize(("extra", "says"), [(["--shard", "4/4"], "0/4"), (["--profile", "none.yaml"], "none.yaml")])
def test_a_wrong_option_is_refused_in_a_sentence(tmp_path: Path, extra: list[str], says: str) -> None:
    prepared(tmp_path)
    done = run(tmp_path, *COMMAND, *extra)
    assert done.exit_code == 2 and says in done.stderr and "Traceback" not in done.stderr


def test_the_assignment_of_the_manual_is_one(tmp_path: Path) -> None:
    text = (Path(__file__).parents[2] / "docs" / "class.md").read_text(encoding="utf-8")
    first = text.partition("```yaml\n")[2].partition("```")[0]
    (tmp_path / "hw3.yaml").write_text(first, encoding="utf-8")
    found = load_assignment(tmp_path / "hw3.yaml")
    assert [bool(problem.ranges) for problem in found.problems] == [True, False] and found.id == "hw3"


def test_sheets_of_who_left_or_is_called_otherwise_are_told(first: tuple[Path, Result], tmp_path: Path) -> None:
    """They lay beside those of the roster, without a word."""
    folder, before = first
    assert "may be deleted" not in before.stderr
    shutil.copytree(folder, tmp_path / "again")
    (tmp_path / "again" / "名单.csv").write_bytes(ROSTER.replace("王小明", "王晓明").encode("gb18030"))
    said = run(tmp_path / "again", *COMMAND).stderr
    old = [f"{where}/20230001_王小明.pdf" for where in ("questions", "solutions")]
    assert f"may be deleted: {', '.join(old)}" in said.replace("\n", "")
