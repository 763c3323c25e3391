"""Places: how two coordinates are read, in which unit, and what is said of a wrong one."""

from __future__ import annotations

import pytest

from tests.grading.cases import key_of, problem_of
from vecpoly import loads, solve
from vecpoly.grading.compare.outcome import Finding, Outcome
from vecpoly.grading.derive.keyed import answer_key
from vecpoly.grading.key import Kind
from vecpoly.grading.reading.written import State, written
from vecpoly.grading.student import check_answers


def said(answer: str, problem: str = "D-1") -> Finding:
    (one,) = check_answers(problem_of(problem), [answer]).answers
    return one


@pytest.mark.parametrize(
    "text",
    [
        "(-31.9, 0.5)", "-31.9, 0.5", "-31.9,0.5 mm", "-31.9 0.5", "-31.9 mm, 0.5 mm", "（−31.9，0.5）mm", "-31,9; 0,5",
        "(-31,9; 0,5) mm", "(-31,9, 0.5)", "x = -31.9, y = 0.5", "P(-31.9, 0.5)",
    ],
)  # fmt: skip
def test_two_coordinates_are_read_with_and_without_brackets(text: str) -> None:
    assert written(text).at == (-31.9, 0.5)


@pytest.mark.parametrize("text", ["31,9", "1.234,5", "12 rad/s cw", "0.49 m/s 210°", "-0.126"])
def test_what_may_be_one_number_is_no_pair(text: str) -> None:
    assert written(text).at is None and written(text).state is State.READ


def test_of_a_comma_between_two_whole_numbers_nobody_knows() -> None:
    assert written("1,234").state is State.UNREADABLE
    assert "two coordinates are asked" in said("P_13=31,9").messages[0].words.en


def test_a_place_is_in_mm_where_no_unit_is_written_and_its_error_is_told_in_mm() -> None:
    assert said("P_13=(-31.9, 0)").outcome is Outcome.RIGHT
    assert said("P_13=(-0.0319, 0) m").outcome is Outcome.RIGHT
    assert "off by 10 mm" in said("P_13=(-31.9, 10)").messages[0].words.en


@pytest.mark.parametrize(
    ("place", "told"),
    [
        ("(-319, 0)", "off by 10^1"),
        ("(-31934, 0)", "off by 10^3"),
        ("(31.9, 0)", "The sign of a coordinate is wrong"),
        ("(17.76, 0) mm", "$P_{14}P_{34}$ divided between its ends"),
    ],
)
def test_a_wrong_place_is_told_why(place: str, told: str) -> None:
    assert told in said(f"P_13={place}").messages[0].words.en


@pytest.mark.parametrize(
    ("answer", "what"),
    [("omega_ratio_13=0.2853", "$ω_{1}/ω_{3}$ is worked with"), ("omega_3=35.1 ccw", "$ω_{3}$ is worked with")],
)
def test_a_ratio_of_distances_of_centres_that_is_turned_over_is_named(answer: str, what: str) -> None:
    (sentence,) = (one.words.en for one in said(answer).messages)
    assert what in sentence and "upside down" in sentence


def test_a_velocity_found_from_an_own_angular_velocity_follows_it() -> None:
    """ω₂ of the centres is a step: whoever has it wrong, and goes on rightly, has v_C right."""
    checked = check_answers(problem_of("D-1"), ["omega_2=3.1 cw", "v_C=0.2022"])
    assert [one.outcome for one in checked.answers] == [Outcome.WRONG, Outcome.RIGHT]
    assert "omega_2" in key_of("D-1")["v_C"].needs


FAR = """
extends: 3-2
id: far-centres
links: {1: {AB: 56 mm}}
input: {phi: 145 deg}
"""


def test_a_place_on_a_second_diagram_is_read_no_finer_than_its_scale() -> None:
    """Centres that do not fit at μ_l are drawn once more at μ_l′: T of P_14, which is a pivot, was 0 there, and half a
    millimetre of the paper wrong."""
    problem = loads(FAR)
    key = answer_key(problem)
    figures = solve(problem, by="exact", repeats=0, precise=False).construction.figures
    (second,) = {one.scale.value for one in figures if one.scale.symbol == "μ_l′"}
    places = [one for one in key.quantities if one.kind is Kind.PLACE]
    assert second > key.scales["mu_l"] and len(places) == 7
    assert all(one.allowed >= key.allowance.floor * second for one in places)
    assert key["P_14"].allowed == key.allowance.floor * second
    checked = check_answers(problem, ["P_14=(0.5, 0.3)", "P_34=(121, 0)"])
    assert checked.right and "allowed ±0 " not in str(checked)
