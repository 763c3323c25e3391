"""What a step or a datum says is said once, in a textbook's words, and is on the paper."""

from __future__ import annotations

import re

import pytest

import vecpoly
from tests.laws import few
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import AngleMark, Point, TurnArrow
from vecpoly.words import Lang

LIBRARY = "problems/machines/"


def _solved(name: str) -> vecpoly.Solution:
    return vecpoly.load(f"{LIBRARY}{name}.yaml").solve()


def _given(name: str, lang: Lang) -> str:
    given = vecpoly.load(f"{LIBRARY}{name}.yaml").given
    return "; ".join(datum.of(lang) for datum in (*given.lengths, *given.motion))


def _letters(solution: vecpoly.Solution, view: View) -> set[str]:
    figure = solution.construction.figure(view)
    assert figure is not None
    return {part.strip() for mark in figure.marks if isinstance(mark, Point) for part in mark.label.split(",")}


@pytest.mark.parametrize("name", ["rack-drives-pinion", "geared-five-bar", "crank-rack-pinion"])
def test_a_point_of_a_gear_is_set_out_once(name: str) -> None:
    told = [step.words.zh.count("$E$") for step in _solved(name).construction.steps if "定出 $E$" in step.words.zh]
    assert told and sum(told) == 1


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("elliptic-trammel", "$s_1$ counts to the right from the $y$ axis"),
        ("pinion-drives-rack", "$s_2$ counts to the right from the $y$ axis"),
        ("travel-doubler", "$s_5$ counts to the right from the $y$ axis"),
    ],
)
def test_a_given_travel_says_from_where_it_counts(name: str, said: str) -> None:
    assert said in _given(name, "en")


def test_no_length_is_negative_behind_the_start_of_a_line() -> None:
    assert "沿 $AE$ 的反向延长线距 $A$ 300 mm" in _given("tipper", "zh") and "−" not in _given("tipper", "zh")


@pytest.mark.parametrize("name", few(["dump-hoist", "scissor-lift"], 2))
def test_a_link_that_is_only_thought_to_drive_has_no_angle_and_no_arrow(name: str) -> None:
    figure = _solved(name).construction.figure(View.MECHANISM)
    assert figure is not None
    assert not [mark for mark in figure.marks if isinstance(mark, AngleMark | TurnArrow)]


@pytest.mark.parametrize("name", ["pinion-drives-rack", "planetary-sun-drives", "stepped-planet"])
def test_a_driving_gear_without_a_further_point_has_no_angle(name: str) -> None:
    solution = _solved(name)
    figure = solution.construction.figure(View.MECHANISM)
    assert figure is not None and not [mark for mark in figure.marks if isinstance(mark, AngleMark)]
    assert "作齿轮 1 的节圆" in solution.construction.steps[0].words.zh


def test_letters_that_a_step_measures_between_stand_on_the_polygon() -> None:
    assert {"c", "h"} <= _letters(_solved("rack-drives-pinion"), View.VELOCITY)


@pytest.mark.parametrize(("name", "letter"), [("elliptic-trammel", "O"), ("guided-couple", "D")])
def test_a_point_of_the_frame_that_carries_no_pin_is_lettered(name: str, letter: str) -> None:
    assert letter in _letters(_solved(name), View.MECHANISM)


def test_a_slider_at_constant_speed_leaves_its_letter_at_the_pole() -> None:
    told = [step.words.en for step in _solved("elliptic-trammel").construction.steps]
    assert "Slider 1 moves at constant speed: $a_{A}$ = 0, and $a^′$ lies at the pole $p′$." in told


def test_the_gate_says_whether_there_is_a_coriolis_term() -> None:
    from vecpoly.report.content import conclusions

    assert any("Coriolis acceleration" in told and "exists" in told for told in conclusions(_solved("lift-gate"), "en"))


@pytest.mark.parametrize("name", ["rack-lift", "pinion-drives-rack", "travel-doubler"])
def test_every_letter_on_the_polygons_of_a_rack_is_told_in_a_step(name: str) -> None:
    """p_2 stood beside h in the velocity polygon, and no step spoke of it."""
    solution = _solved(name)
    for view in (View.VELOCITY, View.ACCELERATION):
        if solution.construction.figure(view) is None:
            continue
        told = {part for step in solution.construction.steps for part in re.findall(r"\$([^$]+)\$", step.words.en)}
        own = {letter for letter in _letters(solution, view) if re.match("[ehp]_?\\d?\\^?′?$", letter)}
        assert own and own <= told | {"p", "p′"}
