"""What drawings hardly tell from another value is held against the own length beside it."""

from __future__ import annotations

import pytest

from tests.grading.cases import key_of, problem_of
from vecpoly.grading.compare.outcome import Finding, Outcome
from vecpoly.grading.marking.marker import mark
from vecpoly.grading.rules import Rules
from vecpoly.grading.sheet import sheet_of
from vecpoly.grading.student import check_answers

LEGS = "plate-reactions"


def marked(problem: str, **given: str) -> dict[str, Finding]:
    return {one.key: one for one in check_answers(problem_of(problem), given).answers}


def test_these_values_are_demoted_and_rest_on_one_length_alone() -> None:
    force, speed = key_of(LEGS)["R_56"], key_of("klann-leg")["omega_2"]
    assert force.demoted and force.needs == ("cd",) and force.allowed > 0.3 * force.exact
    assert speed.demoted and speed.needs == ("bc",)


@pytest.mark.parametrize("force", ["95", "50"])
def test_a_force_within_the_scatter_of_drawings_is_wrong_where_the_own_length_says_otherwise(force: str) -> None:
    """5 N/mm × 14.6 mm = 73 N."""
    alone, beside = marked(LEGS, R_56=force)["R_56"], marked(LEGS, R_56=force, cd="14.6")["R_56"]
    assert alone.outcome is Outcome.RIGHT
    assert beside.outcome is Outcome.WRONG and not beside.earned.total
    assert [one.words.en for one in beside.messages][:2] == [
        "Not correct",
        "Does not agree with your own reading: 14.6 mm × 5 = 73 N",
    ]


def test_what_agrees_with_the_own_length_is_right_however_far_both_are_off() -> None:
    assert marked(LEGS, R_56="90", cd="18")["R_56"].outcome is Outcome.RIGHT


def test_a_wrong_length_is_no_witness_against_a_value() -> None:
    """One mistake costs once: the length is wrong, the force may stand."""
    found = marked(LEGS, R_56="73", cd="30")
    assert found["cd"].outcome is Outcome.WRONG and found["R_56"].outcome is Outcome.RIGHT


def test_a_speed_is_held_against_the_length_that_it_is_computed_from() -> None:
    exact = key_of("klann-leg")["bc"].exact
    length, speed = marked("klann-leg", bc=f"{exact:.1f}", omega_2="0.36 cw").values()
    assert length.outcome is Outcome.RIGHT and speed.outcome is Outcome.WRONG
    assert "follows −0.301 rad/s" in speed.messages[1].words.en


@pytest.mark.parametrize("force", ["60", "73", "95", "146"])
@pytest.mark.parametrize("length", ["10", "14.6", "18", "30"])
def test_it_is_so_whether_or_not_own_values_are_followed(force: str, length: str) -> None:
    """So that follow-through lowers no mark here either."""
    problem, key = problem_of(LEGS), key_of(LEGS)
    sheet = sheet_of(key, {"R_56": force, "cd": length})
    followed, alone = (
        mark(problem, key, lambda: (), sheet, Rules(following=following)).exactly for following in (True, False)
    )
    assert followed >= alone - 1e-9
