"""Whoever answers with another solution that serves as well is right, and is told which one it is."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tests.grading.cases import key_of, marked, problem_of
from vecpoly.designs.base import Design
from vecpoly.grading.marking.solutions import other_keys
from vecpoly.grading.told.named import Told

NAME = "two-solutions"
OTHER = {"BC": "97.8", "AD": "163.1"}  # of solution 2; solution 1 has AD = 80.9


def test_a_coherent_set_of_answers_of_another_solution_is_right_and_has_all_points() -> None:
    sheet = marked(NAME, OTHER)
    assert all(sheet[key].is_right for key in OTHER) and not sheet.roots and not sheet.slips
    (said,) = (one for one in sheet.messages if one.id is Told.OTHER_SOLUTION)
    assert "solution 2" in said.words.en and "第 2 个解" in said.words.zh
    assert sum(sheet[key].earned.total for key in OTHER) == sum(key_of(NAME)[key].points.total for key in OTHER)


def test_of_the_solution_of_the_key_nothing_more_is_said() -> None:
    sheet = marked(NAME, {"BC": "97.8", "AD": "80.9"})
    assert all(one.is_right for one in sheet.findings if one.written.raw)
    assert not [one for one in sheet.messages if one.id is Told.OTHER_SOLUTION]


@pytest.mark.parametrize("wrong", [{"BC": "128"}, {"AD": "120"}])
def test_values_that_are_of_no_one_solution_are_not_right(wrong: dict[str, str]) -> None:
    sheet = marked(NAME, OTHER | wrong)
    assert sheet.roots and not [one for one in sheet.messages if one.id is Told.OTHER_SOLUTION]


def test_a_length_on_paper_is_held_against_that_of_the_same_solution() -> None:
    (length,) = (one for number, key in other_keys(problem_of(NAME), key_of(NAME)) for one in [key["AD mm"]])
    theirs = key_of(NAME)["A'D"]
    assert (length.exact, length.mm, length.allowed) == (theirs.exact, theirs.mm, theirs.allowed)
    assert marked(NAME, OTHER | {"AD mm": f"{length.exact:.1f}"})["AD mm"].is_right


def test_where_a_solution_is_chosen_or_several_are_asked_for_no_other_one_stands_for_it() -> None:
    problem = problem_of(NAME)
    assert isinstance(problem.subject, Design)
    second = problem.subject.model_copy(update={"take": 2})
    assert not list(other_keys(replace(problem, subject=second), key_of(NAME)))
    assert not list(other_keys(problem, replace(key_of(NAME), solutions=(1, 2))))
