"""The command line with forces and devices: what it prints, what it draws, and how it refuses what cannot be."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from vecpoly import load
from vecpoly.cli import app
from vecpoly.cli.commands.demo import ASSIGNMENTS
from vecpoly.foundation.data import data_dir
from vecpoly.problem.assignment import load_assignment
from vecpoly.problem.library import entries

Run = Callable[..., Result]

SLIDER = """
id: slider
title: {zh: 曲柄滑块, en: slider-crank}
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 80 mm}, 2: {BC: 230 mm}, 3: {block: C}}
joints: [3 slides on y = -15 mm]
input: {link: 1, phi: PHI, omega: 1 rad/s ccw}
branch: [C right of B]
loads:
  F: {on: 3, at: C, size: 1000 N, direction: 180 deg, role: driving}
  M: {on: 1, size: "?", role: resisting}
friction:
  A: {rho: RHO}
  B: {rho: 5 mm}
  C: {rho: 4 mm}
  3-4: {phi: 8 deg}
find: [R_32, R_12, R_41, M, M_0, eta]
"""


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)
    return lambda *words: CliRunner().invoke(app, [str(word) for word in words], prog_name="vecpoly")


def slider(folder: Path, phi: str = "52 deg", rho: str = "6 mm") -> Path:
    path = folder / "slider.yaml"
    path.write_text(SLIDER.replace("PHI", phi).replace("RHO", rho), encoding="utf-8")
    return path


# -- answers --------------------------------------------------------------------------------------------------------


def test_solve_json_gives_size_direction_line_and_tangent_side_of_a_reaction(run: Run) -> None:
    data = json.loads(run("solve", "4-3a", "--hand", "exact", "--json", "-").stdout)["answers"]
    one = data["R_32"]
    assert one["unit"] == "N" and one["drawn"] == pytest.approx(one["exact"], rel=1e-9)
    assert one["direction_deg"] == pytest.approx(one["exact_direction_deg"], rel=1e-9)
    assert one["tangent"] == one["exact_tangent"] == "ccw" and len(one["point"]) == len(one["exact_point"]) == 2
    assert data["M"]["sense"] == "cw" and abs(data["M"]["drawn"]) < abs(data["M_0"]["drawn"])
    assert 0 < data["eta"]["drawn"] < 1 and "sense" not in data["eta"] and "direction_deg" not in data["eta"]


def test_exact_answers_forces_and_devices_without_a_drawing(run: Run) -> None:
    data = json.loads(run("exact", "4-3a", "5-7", "--json", "-").stdout)
    slider, train = data[0]["answers"], data[1]["answers"]
    assert slider["R_41"]["unit"] == "N" and slider["R_41"]["tangent"] == "cw" and slider["M"]["unit"] == "N·m"
    assert train["P"]["unit"] == "kW" and train["eta"]["unit"] == "" and 0 < train["eta"]["exact"] < 1
    shown = run("exact", "4-3a", "5-7").stdout
    assert "R_41" in shown and "η" in shown and "kW" in shown


def test_the_table_says_yes_and_no_and_no_deviation_of_formulas(run: Run) -> None:
    shown = run("solve", "5-5").stdout
    line = next(row for row in shown.splitlines() if "self_locking" in row)
    assert line.split()[1:3] == ["yes", "yes"]
    assert "是" in run("solve", "5-5", "--lang", "zh").stdout
    for row in run("solve", "5-7").stdout.splitlines()[3:]:
        assert "%" not in row


def test_large_numbers_stay_numbers(run: Run) -> None:
    assert "e+" not in run("solve", "5-5").stdout


def test_check_weighs_the_printed_answers_of_a_device(run: Run) -> None:
    data = {line["symbol"]: line for line in json.loads(run("check", "5-5", "--json", "-").stdout)["answers"]}
    assert data["eta"]["verdict"] == "reproduced" and data["eta"]["exact"] == pytest.approx(0.218515, rel=1e-5)
    assert "no printed answers" in run("check", "4-3a").stdout
    assert (
        run("check", "5-6").exit_code == 0 and run("check", "5-6", "5-7").exit_code == 1
    )  # 5-7: its printed η′ is wrong


# -- figures --------------------------------------------------------------------------------------------------------


def test_draw_knows_figures_by_kind_and_by_name(run: Run, tmp_path: Path) -> None:
    for figure in ("mechanism", "body", "force", "force:3", "body:2", "sheet"):
        assert run("draw", "4-3a", "--figure", figure).exit_code == 0, figure
    assert (tmp_path / "4-3a-force-3.svg").read_bytes() != (tmp_path / "4-3a-body.svg").read_bytes()
    assert (tmp_path / "4-3a-body-2.svg").exists()


@pytest.mark.parametrize("figure", ["force:9", "froce", "acceleration", "3", ":", "force:"])
def test_a_figure_that_is_not_there_is_answered_with_those_that_are(run: Run, figure: str) -> None:
    result = run("draw", "4-3a", "--figure", figure, "-o", "x.svg")
    if figure == "force:":
        assert result.exit_code == 0  # the first of its kind
        return
    assert (
        result.exit_code == 2 and "body:1" in result.stderr and "force:3" in result.stderr and "sheet" in result.stderr
    )


# -- lists and beginnings ---------------------------------------------------------------------------------------------


def test_list_methods_shows_force_methods_and_devices(run: Run) -> None:
    shown = run("list", "methods").stdout
    rows = [row.split() for row in shown.splitlines()]
    assert any(row[:1] == ["force"] for row in rows) and any(row[:2] == ["device", "screw-jack"] for row in rows)
    assert "Two-force link" in shown and "二力杆" in run("list", "methods", "--lang", "zh").stdout


def test_new_starts_from_a_problem_of_the_library(run: Run, tmp_path: Path) -> None:
    assert run("new", "jack", "--like", "5-5").exit_code == 0
    assert json.loads(run("exact", "jack.yaml", "--json", "-").stdout)["id"] == "jack"
    assert run("new", "press", "--like", "4-3a").exit_code == 0
    first, second = (tmp_path / "press.yaml").read_text("utf-8").splitlines()[:2]
    assert first == "# yaml-language-server: $schema=vecpoly.schema.json" and second == "id: press"
    missing = run("new", "x", "--like", "9-99")
    assert missing.exit_code == 2 and "no problem '9-99'" in missing.stderr and not (tmp_path / "x.yaml").exists()


def test_the_assignments_of_the_demo_hold_the_whole_chapters() -> None:
    for name in ASSIGNMENTS:
        sheet = load_assignment(data_dir("problems") / f"{name}.yaml")
        chapter = {e.id for e in entries() if e.path.parent.name == name.removeprefix("assignment-")}
        assert {problem.id for problem in sheet.problems} == chapter, name


# -- refusals -------------------------------------------------------------------------------------------------------


def refused(result: Result) -> str:
    assert result.exit_code == 2 and result.stdout == "" and "Traceback" not in result.stderr
    (line,) = result.stderr.splitlines()
    return line


@pytest.mark.parametrize("words", [("solve",), ("exact",), ("report", "-o", "x.pdf"), ("draw", "-o", "x.svg")])
def test_a_locked_mechanism_is_refused_in_one_line_that_names_it(
    run: Run, tmp_path: Path, words: tuple[str, ...]
) -> None:
    line = refused(run(words[0], slider(tmp_path, phi="168 deg"), *words[1:]))
    assert "slider.yaml, line 9, column 1: loads: locked" in line
    assert [p.name for p in tmp_path.iterdir()] == ["slider.yaml"]


def test_a_friction_circle_larger_than_its_link_is_refused(run: Run, tmp_path: Path) -> None:
    line = refused(run("solve", slider(tmp_path, rho="90 mm")))
    assert "slider.yaml, line" in line or "slider: " in line


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('size: "?"', "size: 3 N*m", "unknown"),
        ("size: 1000 N", 'size: "?"', "unknown"),
        ("on: 3, at: C", "on: 7, at: C", "7"),
        ("rho: 6 mm", "rho: -6 mm", "-6 mm"),
        ("3-4: {phi: 8 deg}", "3-4: {f: -0.1}", "-0.1"),
    ],
)
def test_bad_loads_are_refused_with_their_line(run: Run, tmp_path: Path, old: str, new: str, said: str) -> None:
    path = slider(tmp_path)
    path.write_text(path.read_text("utf-8").replace(old, new), encoding="utf-8")
    line = refused(run("solve", path))
    assert re.match(r"vecpoly: .*slider\.yaml, line \d+", line) and said in line


def test_bad_data_of_a_device_are_refused_with_their_line(run: Run, tmp_path: Path) -> None:
    run("new", "train", "--like", "5-6")
    text = (tmp_path / "train.yaml").read_text("utf-8").replace("0.95", "1.95")
    (tmp_path / "train.yaml").write_text(text, encoding="utf-8")
    assert re.search(r"train\.yaml, line \d+.*1\.95", refused(run("solve", "train.yaml")))


# -- the page that everybody reads ------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["README.md", "README.zh.md"])
def test_the_readme_prints_the_forces_that_the_program_gives(name: str) -> None:
    text = (Path(__file__).resolve().parents[2] / name).read_text(encoding="utf-8")
    a = load("4-3a").solve().answers
    for key, symbol in (("R_32", "R₃₂"), ("R_43", "R₄₃")):
        assert f"| {symbol} | {a[key].reading.mm:.1f} mm | {a[key].drawn:.4g} N | {a[key].exact:.5g} N |" in text
    assert f"| M | | {-a['M'].drawn:.4g} N·m ↻ | {-a['M'].exact:.4g} N·m ↻ | |" in text
    assert f"| η | | {a['eta'].drawn:.4g} | {a['eta'].exact:.4g} | |" in text


@pytest.mark.parametrize("name", ["README.md", "README.zh.md"])
def test_the_lines_of_the_readme_are_those_of_the_library(name: str) -> None:
    text = (Path(__file__).resolve().parents[2] / name).read_text(encoding="utf-8")
    for problem in ("4-3a", "5-5"):
        for line in load(problem).text.splitlines():
            if line.startswith(("  F:", "  M:", "data:", "  A:", "  3-4:")):
                assert line.strip() in text
