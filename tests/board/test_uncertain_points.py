"""A meeting of two lines is called uncertain only where a flat crossing really finds a point."""

from __future__ import annotations

import cmath
from math import radians

import pytest

from tests.flat_positions import FLAT
from vecpoly import load
from vecpoly.board.board import Board
from vecpoly.board.construction import Scale, View
from vecpoly.board.hand import hand
from vecpoly.plane import Line
from vecpoly.solution import Solution, solve
from vecpoly.words import Words


def remarked(apart: complex, degrees: float) -> str:
    """What the board remarks when two lines, one starting `apart` from the other, meet at this angle."""
    board = Board(hand("exact"), {View.MECHANISM: Scale(symbol="μ_l", value=0.001, unit="m")})
    board.step(Words("", ""), View.MECHANISM)
    along = cmath.rect(1, radians(degrees))
    assert board.meet(Line(0j, 1 + 0j), Line(apart, along), "two lines") == pytest.approx(
        apart - along * (apart.imag / along.imag)
    )
    return board.steps[-1].words.en


@pytest.mark.parametrize(
    ("degrees", "uncertain"), [(14.9, True), (9.0, True), (171.0, True), (15.2, False), (90.0, False)]
)
def test_lines_that_cross_at_less_than_15_degrees_make_an_uncertain_point(degrees: float, uncertain: bool) -> None:
    assert ("poorly defined" in remarked(30 + 10j, degrees)) == uncertain


@pytest.mark.parametrize("degrees", [2.0, 9.0, 171.0])
def test_lines_that_start_at_one_point_meet_there_for_certain(degrees: float) -> None:
    assert remarked(0j, degrees) == ""


@pytest.fixture(scope="module")
def shaper() -> Solution:
    return solve(load("six-bar-dynamic"), repeats=0)


def test_forces_that_all_act_at_the_ram_s_pin_need_no_crossing(shaper: Solution) -> None:
    (ram,) = [step for step in shaper.construction.steps if step.words.en.startswith("Isolate link 5")]
    assert "pass through $E$, so $R_{65}$ must" in ram.words.en and "均过 $E$，故 $R_{65}$ 必过 $E$" in ram.words.zh
    assert "poorly defined" not in ram.words.en and "不易准确" not in ram.words.zh and "cross" not in ram.words.en


def test_a_flat_crossing_that_finds_a_point_is_still_told(shaper: Solution) -> None:
    (rocker,) = [step for step in shaper.construction.steps if step.words.en.startswith("Isolate link 3")]
    assert "meet at only 9°" in rocker.words.en and "交角仅 9°" in rocker.words.zh


def test_several_flat_crossings_of_a_step_are_told_in_one_sentence() -> None:
    (step,) = [step for step in load(FLAT).solve().construction.steps if "$M^{(3)}$" in step.words.en[:40]]
    assert step.words.en.count("(Lines meet at only") == step.words.en.count("poorly defined") == 1
    assert "11° and 8°" in step.words.en and step.words.zh.count("不易准确") == 1 and "11°、8°" in step.words.zh
