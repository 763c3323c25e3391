"""Where three forces meet, and the resultant of several known ones, are drawn on the diagram and named in the step."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2, pi

import pytest

import vecpoly
from tests.drawn_library import drawn
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Mark, Point, Role, Segment, TurnArrow

MET = "problems/machines/"
AT_ONE = """
id: one
title: loads at one point of the rocker
frame: {A: [0 mm, 0 mm], D: [120 mm, 0 mm]}
links: {1: {AB: 40 mm}, 2: {BC: 110 mm}, 3: {DC: 80 mm, E: {along: DC, at: 45 mm, left: 20 mm}}}
branch: [C left of BD]
input: {link: 1, phi: 50 deg, omega: 10 rad/s ccw}
find: [M_1, R_12, R_43]
loads:
  M_1: {on: 1, size: "?"}
  F: {on: 3, at: E, size: 300 N, direction: 180 deg}
  Q: {on: 3, at: E, size: 80 N, direction: -90 deg}
"""


def _diagram(name: str) -> tuple[vecpoly.Solution, dict[str, complex], tuple[Mark, ...]]:
    solution = vecpoly.load(f"{MET}{name}.yaml").solve()
    figure = solution.construction.figure(View.MECHANISM)
    assert figure is not None
    return solution, {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}, figure.marks


def _lines_through(at: complex, marks: Sequence[Mark]) -> set[int]:
    """Directions (degrees) of the lines of action that pass through a point."""
    lines = [m for m in marks if isinstance(m, Segment) and m.role is Role.DIRECTION]
    through = [m for m in lines if abs(((m.b - m.a).conjugate() * (at - m.a)).imag) / abs(m.b - m.a) < 1e-3]
    return {round(atan2((m.b - m.a).imag, (m.b - m.a).real) % pi * 180 / pi) for m in through}


@pytest.mark.parametrize(("name", "letters"), [("boom-thrust", "K"), ("hand-lever", "KO")])
def test_three_lines_of_action_pass_through_the_lettered_meeting_point(name: str, letters: str) -> None:
    solution, points, marks = _diagram(name)
    told = "".join(step.words.zh for step in solution.construction.steps)
    for letter in letters:
        assert f"${letter}$" in told
        assert len(_lines_through(points[letter], marks)) == 3


def test_two_parallel_forces_are_laid_off_interchanged_and_their_resultant_divides_the_line_between_them() -> None:
    solution, points, marks = _diagram("boom-thrust")
    one, two = points["E"], points["S_1"]
    at = one + (two - one) * 17658 / (17658 + 9000)  # Q EX = G XS
    assert _lines_through(at, marks) >= {90}
    assert [step for step in solution.construction.steps if "截取另一力" in step.words.zh]
    assert any(letter.startswith("P_") for letter in points)


@pytest.mark.parametrize("name", ["shaper-cut", "six-bar-dynamic"])
def test_a_resultant_has_the_letter_of_its_link_and_that_of_forces_through_one_pin_is_not_drawn(name: str) -> None:
    figure = drawn(name).construction.figure(View.MECHANISM)
    assert figure is not None
    letters = [mark.label for mark in figure.marks if isinstance(mark, Point) and mark.label.startswith("P")]
    assert letters == ["P_{3}"]


def test_an_inner_couple_stands_on_its_link_and_not_on_the_group() -> None:
    solution = vecpoly.load(f"{MET}guided-couple.yaml").solve()
    turning = {
        figure.title.en: {m.label for m in figure.marks if isinstance(m, TurnArrow)}
        for figure in solution.construction.figures
        if figure.view is View.BODY
    }
    assert turning["Free body of group 2-3"] == {"M_{2}"}
    assert turning["Free body of link 2"] == {"M_{2}", "M_{R32}"}
    assert turning["Free body of link 3"] == {"M_{R23}"}


def test_forces_at_one_point_have_their_resultant_through_it() -> None:
    solution = vecpoly.loads(AT_ONE).solve(by="exact")
    figure = solution.construction.figure(View.MECHANISM)
    assert figure is not None
    (at,) = (mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label == "E")
    (end,) = (mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label == "P_{3}")
    assert abs(end - at) < 60  # mm: the line of the resultant is drawn about the point
    (said,) = (step.words for step in solution.construction.steps if "的合力 $P_{3}$" in step.words.zh)
    assert "过各力的公共作用点" in said.zh and "through their common point" in said.en
    for answer in solution.answers.values():
        assert abs(answer.drawn - answer.exact) <= 1e-9 * abs(answer.exact)
