"""Claims about the door: what a user holds is the same data as inside the house,
with what reaches into every part of it."""

from __future__ import annotations

import pickle
from copy import deepcopy

import pytest

import vecpoly
from tests.laws import few
from vecpoly import solution as inside
from vecpoly.problem.load import load as plain_load
from vecpoly.record import to_json
from vecpoly.words import Lang


@pytest.mark.parametrize("name", ["3-9", "4-3a", "5-1"])
def test_what_a_user_holds_equals_what_is_inside(name: str) -> None:
    problem, plain = vecpoly.load(name), plain_load(name)
    assert problem == plain and plain == problem and hash(problem) == hash(plain)
    solution, within = problem.solve(by="exact"), inside.solve(plain, by="exact")
    assert solution == within and within == solution
    assert solution.construction == vecpoly.from_json(to_json(within.construction), vecpoly.Construction)


def test_other_data_are_not_equal() -> None:
    assert vecpoly.load("3-9") != plain_load("3-8")
    assert vecpoly.load("3-9") != "3-9"


def test_what_a_user_holds_survives_pickle_and_copies() -> None:
    solution = vecpoly.load("3-9").solve()
    for again in (pickle.loads(pickle.dumps(solution)), deepcopy(solution)):
        assert again == solution
        assert (
            type(again) is vecpoly.Solution
            and type(again.problem) is vecpoly.Problem
            and type(again.construction) is vecpoly.Construction
        )


def test_the_problems_of_an_assignment_can_be_solved() -> None:
    sheet = vecpoly.load_assignment("problems/assignment-ch5.yaml")
    assert all(type(problem) is vecpoly.Problem for problem in sheet.problems)


def test_a_loaded_problem_takes_a_students_readings() -> None:
    ours, theirs = (
        vecpoly.load("3-9").solve(by="exact", readings=readings).answers["omega_2"].drawn
        for readings in (None, {"bc2": "30 mm"})
    )
    assert theirs == pytest.approx(ours * 30 / 40.922, rel=1e-3)


@pytest.fixture(params=["zh", "en"])
def lang(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Lang:
    chosen: Lang = "zh" if request.param == "zh" else "en"
    monkeypatch.setenv("VECPOLY_LANG", chosen)
    return chosen


@pytest.mark.parametrize("name", few(["3-9", "4-3a", "5-1", "2-5"], 3))
def test_a_notebook_shows_pictures_whose_letters_need_no_font(name: str, lang: Lang) -> None:
    problem = vecpoly.load(name)
    solution = problem.solve()
    for shown in (
        problem._repr_html_(),
        problem._repr_svg_(),
        solution._repr_html_(),
        solution._repr_svg_(),
        solution.construction._repr_html_(),
    ):
        assert "<svg" in shown and "<path" in shown
        assert "<text" not in shown and "font-family" not in shown


def test_a_notebook_speaks_the_readers_language(lang: Lang) -> None:
    problem = vecpoly.load("3-9")
    solution = problem.solve()
    said = {"zh": ("已知", "精确值", "各步的作图动作"), "en": ("Given", "Exact", "The acts of every step")}
    shown = (problem._repr_html_(), solution._repr_html_(), solution.construction._repr_html_())
    assert all(word in page for word, page in zip(said[lang], shown, strict=True))
    if lang == "en":
        assert not any("\u4e00" <= letter <= "\u9fff" for page in shown for letter in page)


def test_a_notebook_shows_a_suspect_solution_in_red() -> None:
    from dataclasses import replace

    from vecpoly.words import Words

    solution = vecpoly.load("3-9").solve()
    warned = replace(
        solution, construction=replace(solution.construction, warning=Words("不可信", "not to be trusted"))
    )
    assert "not to be trusted" in warned._repr_html_() and "not to be trusted" not in solution._repr_html_()
