"""Claims about what the terminal tells: what is small, what is nothing, what is rejected."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from typer.testing import CliRunner

from vecpoly import load
from vecpoly.cli import app
from vecpoly.cli.sources import group_told, source_told
from vecpoly.methods.devices.registry import device_methods
from vecpoly.methods.registry import methods
from vecpoly.methods.synthesis.registry import design_methods

FOUR_BAR = """
id: creeping
title: creeping
frame: {A: [0 mm, 0 mm], D: [300 mm, 0 mm]}
links: {1: {AB: 100 mm}, 2: {BC: 250 mm}, 3: {DC: 200 mm}}
input: {link: 1, phi: 60 deg, omega: RATE rad/s ccw}
branch: [C above BD]
find: [omega_3, v_C]
"""


@pytest.mark.parametrize("command", ["solve", "exact", "cycle"])
def test_a_mechanism_that_creeps_does_not_stand_still(command: str, tmp_path: Path) -> None:
    """All values are those of 1 rad/s with another power of ten (they were 0 below 1e-9)."""
    told = {}
    for rate in ("1", "1e-12"):
        path = tmp_path / "creeping.yaml"
        path.write_text(FOUR_BAR.replace("RATE", rate), "utf-8")
        shown = CliRunner().invoke(app, [command, str(path)]).stdout.replace("−", "-")
        rows = [row.split() for row in shown.splitlines() if row.startswith((" ω_3", " v_C", " |v_C|"))]
        told[rate] = [float(row[2 if command == "cycle" else 1]) for row in rows]
    assert len(told["1"]) == 2
    assert told["1e-12"] == pytest.approx([1e-12 * value for value in told["1"]], rel=1e-3, abs=0)


def test_what_stands_still_for_a_moment_is_nothing() -> None:
    shown = CliRunner().invoke(app, ["cycle", "3-14"]).stdout
    row = next(line for line in shown.splitlines() if line.startswith(" |v_C|"))
    assert row.split()[4:] == ["0", "30°"]


def test_a_candidate_that_is_no_solution_is_told_with_its_reason() -> None:
    for lang, why in (
        ("en", "Candidate 2 rejected: C_1 and C_2 do not lie on one side of AD"),
        ("zh", "候选解 2 舍去："),
    ):
        assert why in CliRunner().invoke(app, ["solve", "8-5", "--lang", lang]).stdout


def test_what_is_remarked_of_an_answer_stands_in_the_terminal_and_in_json() -> None:
    shown = CliRunner().invoke(app, ["solve", "3-14"]).stdout
    assert "ω_2: the link only translates" in shown
    told = json.loads(CliRunner().invoke(app, ["solve", "3-14", "--json", "-"]).stdout)["answers"]["omega_2"]
    assert told["remark"] == {"zh": "该构件作平动", "en": "the link only translates"}


def test_the_direction_of_what_creeps_is_told_in_json(tmp_path: Path) -> None:
    path = tmp_path / "creeping.yaml"
    path.write_text(FOUR_BAR.replace("RATE", "1e-12"), "utf-8")
    told = json.loads(CliRunner().invoke(app, ["solve", str(path), "--json", "-"]).stdout)["answers"]["v_C"]
    assert told["exact_direction_deg"] == pytest.approx(told["direction_deg"], abs=0.2)


def test_exact_tells_a_sense_as_solve_does_and_nothing_twice() -> None:
    """It had −1.995 where solve had 1.9952 cw, and a^k_B3B2, which is asked in two ways, on two lines."""
    shown = CliRunner().invoke(app, ["exact", "3-9", "--lang", "zh"]).stdout
    assert [row.split()[1:] for row in shown.splitlines() if row.startswith(" ω_2")] == [["1.99524", "rad/s", "顺时针"]]
    assert (
        json.loads(CliRunner().invoke(app, ["exact", "3-9", "--json", "-"]).stdout)["answers"]["omega_2"]["sense"]
        == "cw"
    )
    assert CliRunner().invoke(app, ["exact", "3-7a"]).stdout.count("a^k_B3B2") == 1


def test_places_are_told_in_the_unit_in_which_they_are_checked() -> None:
    shown = CliRunner().invoke(app, ["exact", "D-2"]).stdout
    row = next(row for row in shown.splitlines() if row.startswith(" P_24"))
    place = row[row.index("(") : row.index(")") + 1]
    assert CliRunner().invoke(app, ["check", "D-2", f"P_24={place}"]).exit_code == 0


@pytest.mark.parametrize("like", ["engine-card", "B-24"])
def test_a_copy_has_the_tables_that_it_reads(like: str, tmp_path: Path) -> None:
    file = tmp_path / "mine.yaml"
    assert CliRunner().invoke(app, ["new", str(file), "--like", like]).exit_code == 0
    assert load(file).files


def test_the_library_lists_what_is_no_problem_with_its_command() -> None:
    shown = CliRunner().invoke(app, ["list"]).stdout
    assert "vecpoly design design-shaper" in shown and "vecpoly search search-dwell" in shown
    assert not any(line != line.rstrip() for line in shown.splitlines())


def test_a_copy_is_told_with_the_command_that_takes_it(tmp_path: Path) -> None:
    for like, command in (("design-press", "design"), ("search-path", "search"), ("5-5", "solve")):
        told = CliRunner().invoke(app, ["new", str(tmp_path / f"{command}.yaml"), "--like", like]).stderr
        assert f"vecpoly {command} " in told


def test_what_is_printed_is_told_as_it_is_printed() -> None:
    """It was "26 deg", off by −1.46 %, and "2 rad/s cw" beside −1.9952 rad/s."""
    shown = CliRunner().invoke(app, ["check", "3-2", "3-9", "--lang", "zh"]).stdout
    assert " 26° " in shown and " −0.38° " in shown and "deg" not in shown and "^2" not in shown
    assert "2 rad/s（顺时针）" in shown and "1.9952 rad/s 顺时针" in shown


@pytest.mark.parametrize(
    ("words", "command"),
    [("search shaper-cut", "solve"), ("design search-dwell", "search"), ("solve design-press", "design")],
)
def test_a_file_of_another_kind_is_told_with_the_command_that_takes_it(words: str, command: str) -> None:
    told = CliRunner().invoke(app, words.split())
    assert told.exit_code == 2 and f"the command is: vecpoly {command} " in told.stderr
    assert len(told.stderr.splitlines()) == 1


def test_the_list_of_methods_speaks_one_language() -> None:
    """In Chinese English words stay for what is written in a file (the kinds of devices and designs); in English none
    of the other tongue."""
    every = [
        *(one.source for one in methods()), *(one.source for one in device_methods()),
        *(one.source for one in design_methods()),
    ]  # fmt: skip
    assert not [one for one in every if re.search("[a-z]{4}", source_told(one, "zh"))]
    assert not [one for one in every if re.search("[\u4e00-\u9fff]", source_told(one, "en"))]
    assert not [one for one in methods() if re.search("[a-z]{4}", group_told(one.group, "zh"))]
