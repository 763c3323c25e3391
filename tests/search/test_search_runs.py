"""Searches find what there is, the same on any number of processes, and say what they cannot."""

from __future__ import annotations

import re
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from vecpoly.cli.app import app
from vecpoly.errors import ProblemFileError, VecpolyError
from vecpoly.problem.load import load
from vecpoly.problem.values.made import problem
from vecpoly.search.path import PathSearch
from vecpoly.search.run import Found, run
from vecpoly.search.spec import load_search
from vecpoly.solution import solve
from vecpoly.words import Words, bare

NAME = Words.same("found")


def found(name: str, count: int = 20_000, jobs: int = 1) -> Found:
    return run(load_search(name)[0], "found", NAME, count=count, seed=3, jobs=jobs)


def value(one: Found, name: str) -> float:
    return next(m.value for m in one.measures if m.name.en == name)


def test_the_best_transmission_angle_is_that_of_the_oracle_s_synthesis() -> None:
    """Of a crank-rocker with K = 1.3 it grows as the swing shrinks: at 30° the closed form has the same angle."""
    data = {"K": "1.3", "CD": "100 mm", "swing": "30 deg", "best": "gamma_min"}
    told = problem({"id": "a", "title": "a", "synthesis": "crank-rocker", "data": data, "find": ["gamma_min"]})
    exact = solve(told, by="exact", repeats=0).answers["gamma_min"].exact
    assert value(found("search-transmission"), "minimum transmission angle") == pytest.approx(exact, abs=0.01)


def test_the_ellipse_is_followed_better_the_longer_it_is_searched() -> None:
    one = found("search-path")
    assert value(one, "RMS error") < 1.5 and value(one, "worst error") < 3 * value(one, "RMS error")
    assert one.refined <= one.first


@pytest.mark.parametrize("name", ["search-path", "search-dwell"])
def test_no_side_of_a_link_that_is_found_is_longer_than_allowed(name: str) -> None:
    """Nor a rod of a dwell where the file does not say so: ten cranks, not an arc of 4 m that is all but straight."""
    mech = found(name).problem.mechanism
    assert mech.links
    for link in mech.links:
        for (_, one), (_, other) in combinations(link.points.items(), 2):
            assert abs(other - one) <= 0.3 + 1e-6


def test_the_six_bar_rests_and_swings() -> None:
    one = found("search-dwell")
    assert value(one, "worst off the dwell") < 0.5 and value(one, "swing") > 29.0


def test_a_straight_line_is_followed_over_part_of_the_turn() -> None:
    line = tuple(complex(x) for x in np.linspace(-0.05, 0.05, 9))
    one = run(PathSearch(points=line, closed=False, gamma=0.5), "line", NAME, count=20_000, seed=3)
    assert value(one, "worst error") < 0.05


def test_what_is_found_does_not_depend_on_the_number_of_processes() -> None:
    one, two = (found("search-transmission", 120_000, jobs) for jobs in (1, 2))
    assert one.problem.text == two.problem.text


def test_a_curve_that_no_short_linkage_can_follow_is_refused() -> None:
    line = tuple(complex(x) for x in np.linspace(-0.05, 0.05, 9))
    with pytest.raises(VecpolyError, match="none of 5000 candidates"):
        run(PathSearch(points=line, closed=False, gamma=0.5, longest=0.001), "line", NAME, count=5000)


GOOD = """\
title: A dwell
search: dwell
data: {dwell: 120 deg, swing: 30 deg, AB: 30 mm}
candidates: 2000
"""


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("search: dwell", "search: dwel", "'dwel' is not one of"),
        ("dwell: 120 deg", "dwell: 1 deg", "must lie between 5 and"),
        ("AB: 30 mm", "AB: 30 deg", "AB"),
        ("AB: 30 mm", "AB: 30 mm, gamma_min: 95 deg", "gamma_min = 95 deg must lie between"),
        (", AB: 30 mm", "", "'AB' is missing"),
        ("candidates: 2000", "candidates: 2", "must be not below 1000"),
    ],
)
def test_a_fault_of_a_search_file_is_told_in_both_languages(tmp_path: Path, old: str, new: str, said: str) -> None:
    path = tmp_path / "dwell.yaml"
    path.write_text(GOOD.replace(old, new), encoding="utf-8")
    with pytest.raises(ProblemFileError, match=re.escape(said)) as refused:
        load_search(path)
    assert re.search("[\u4e00-\u9fff]", refused.value.words.zh)


def test_the_command_writes_a_problem_that_can_be_drawn(tmp_path: Path) -> None:
    out = tmp_path / "found.yaml"
    done = CliRunner().invoke(
        app, ["search", "search-dwell", "--candidates", "20000", "-j", "1", "-o", str(out), "--lang", "en"]
    )
    assert done.exit_code == 0, done.output
    assert "swing" in done.output
    lengths = {bare(one.symbol): one.text for one in load(out).given.lengths if one.words is None}
    beside = [bare(one.words.en) for one in load(out).given.lengths if one.words is not None]
    assert len(beside) == 1 and beside[0][1:] in done.output  # where the rod's pin lies on the coupler
    assert "l_AB" in lengths and all(f"{key} " in done.output and text in done.output for key, text in lengths.items())
    drawn = solve(load(out), repeats=0)
    assert not drawn.suspect and "omega_5" in drawn.answers


@pytest.mark.parametrize(("output", "said"), [("found.txt", "end the file's name so"), ("dwell.yaml", "destroy")])
def test_a_place_that_cannot_be_written_to_is_refused_before_the_search(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, output: str, said: str
) -> None:
    def begun(*_: object, **__: object) -> Found:
        raise AssertionError("the search has begun")

    monkeypatch.setattr("vecpoly.search.run.run", begun)
    path = tmp_path / "dwell.yaml"
    path.write_text(GOOD, encoding="utf-8")
    done = CliRunner().invoke(app, ["search", str(path), "-o", str(tmp_path / output)])
    assert done.exit_code == 2 and said in " ".join(done.output.split()), done.output
    assert path.read_text(encoding="utf-8") == GOOD


def test_a_search_that_finds_nothing_is_refused_in_words(tmp_path: Path) -> None:
    """It ended in a traceback."""
    file = tmp_path / "far.yaml"
    file.write_text(
        "title: Far\nsearch: path\ncandidates: 1000\n"
        'data: {points: ["(-50, 0) mm", "(-20, 0) mm", "(20, 0) mm", "(50, 0) mm"], '
        "closed: no, gamma_min: 30 deg, longest: 1 mm}\n",
        encoding="utf-8",
    )
    for lang, said in (("en", "far: none of 1000 candidates fulfils what is asked"), ("zh", "far：1000 个候选中没有")):
        done = CliRunner().invoke(app, ["search", str(file), "-j", "1", "--lang", lang])
        assert done.exit_code == 2 and isinstance(done.exception, SystemExit)
        assert said in " ".join(done.output.split())
