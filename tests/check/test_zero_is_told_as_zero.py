"""What is zero but for rounding is written as 0 in the JSON; a small value that is true stays."""

from __future__ import annotations

import pytest

import vecpoly
from tests.found import DEVICES
from vecpoly.answer import place_of
from vecpoly.check.precision import settled
from vecpoly.problem.load import loads
from vecpoly.report.answers.line import answer_line
from vecpoly.report.content import cautions
from vecpoly.solution import solve

TRAIN = """
id: train
title: t
frame: {A: [0 mm, 0 mm]}
links: {1: {gear: A, radius: 20 mm}, 2: {gear: B, radius: 20 mm, E: {BE: 10 mm, angle: 0 deg}}, 3: {AB: 40 mm}}
joints: [2 rolls on 1 at H]
input: [{link: 1, phi: 0 deg, omega: 5 rad/s ccw}, {link: 3, phi: 30 deg, omega: 2 rad/s cw%s}]
find: [a_E, omega_2, alpha_2]
"""


def test_an_acceleration_that_vanishes_is_zero_in_the_json() -> None:
    solution = solve(loads(TRAIN % ""))
    assert abs(solution.answers["alpha_2"].exact) < 1e-12
    told = solution.as_json()["answers"]["alpha_2"]
    assert (told["drawn"], told["exact"]) == (0, 0)


def test_nothing_that_vanishes_is_printed_by_powers_of_ten_with_a_sense() -> None:
    greatest = "277.84887978899616 mm"  # where the legs turn at their greatest rate
    solution = vecpoly.load("scissor-lift").vary(length=greatest).solve()
    for key in ("alpha_1", "alpha_2"):
        line = answer_line(solution.answers[key], solution, "en")
        assert line.result == "0 rad/s^2" and solution.answers[key].sense is None


def test_a_small_acceleration_that_is_true_is_no_zero() -> None:
    told = solve(loads(TRAIN % ", alpha: 1e-9 rad/s^2"), by="exact").as_json()["answers"]["alpha_2"]
    assert told["exact"] == pytest.approx(2e-9, rel=1e-4)


def test_only_what_scatters_as_much_as_itself_is_taken_for_zero() -> None:
    assert settled(2e-16, 1e-16, 1.0) == 0
    assert settled(2e-16, 1e-20, 1.0) == 2e-16  # it is told to four digits
    assert settled(1e-3, 1e-3, 1.0) == 1e-3  # no digit of it is sure, but it is no nothing beside 1
    assert settled(1e-17 + 2j, 1e-16, 2.0) == 2j


def test_a_coordinate_that_is_the_rounding_of_the_other_is_zero() -> None:
    assert place_of(0.15 + 8.9e-18j) == [0.15, 0.0]
    assert place_of(1e-9 + 1e-12j) == [1e-9, 1e-12]


def test_what_is_less_than_the_last_place_of_its_kind_is_zero_where_no_data_are_moved() -> None:
    assert settled(-1.4e-17, 0.0, 0.96) == 0.0
    assert settled(1e-12, 0.0, 0.96) == 1e-12


def test_of_a_train_whose_gear_is_held_no_count_is_doubted() -> None:
    solution = solve(loads(DEVICES["held-gear-of-a-train"]))
    assert solution.answers["v_C"].exact == 0.0
    assert cautions(solution, "en") == []
