"""The thrust of a cylinder between two moving links, found by virtual power and by the lever, is the same thrust."""

from __future__ import annotations

import pytest

from tests.at_once import exactly
from tests.laws import few
from vecpoly import Problem, load, loads, problem, solve
from vecpoly.board.paper.marks import Vector
from vecpoly.problem.values.vary import data_of

BETWEEN = """
id: off-hinge
title: {zh: 油缸装于两个运动构件之间, en: A cylinder between two moving links}
frame: {A: [0 mm, 0 mm], D: [400 mm, 0 mm]}
links:
  1: {AB: 300 mm, E: {along: AB, at: 150 mm, left: 40 mm}}
  2: {BC: 450 mm}
  3: {DC: 350 mm, F: {along: DC, at: 120 mm, right: 30 mm}}
  4: {cylinder: E}
  5: {piston: F}
joints: [5 slides in 4]
input: {cylinder: 4-5, length: 463 mm, v: SPEED}
branch: [C left of BD, B above AD]
loads: {Q: {on: 2, at: C, size: 400 N, direction: TURNED}, F_c: {cylinder: 4-5, size: "?"}}
find: [F_c, F_c_power, F_c_lever, R_16, R_36, R_45, R_54]
"""


def between(speed: str, turned: str) -> Problem:
    return loads(BETWEEN.replace("SPEED", speed).replace("TURNED", turned))


@pytest.mark.parametrize("speed", few(["-0.2 m/s", "0.05 m/s"], 2))
@pytest.mark.parametrize("turned", few(["-90 deg", "200 deg", "10 deg"], 2))
def test_a_thrust_between_two_moving_links_is_the_same_by_every_way(speed: str, turned: str) -> None:
    solution = exactly(between(speed, turned))
    assert not solution.suspect
    found = [solution.answers[key] for key in ("F_c", "F_c_power", "F_c_lever")]
    assert [one.drawn for one in found] == pytest.approx([found[0].exact] * 3, rel=1e-9)
    sideways = [solution.answers[key] for key in ("R_45", "R_54")]  # of piston and barrel
    assert [one.drawn for one in sideways] == [one.exact for one in sideways] == [0.0, 0.0]


def test_the_lever_has_both_ends_of_a_thrust_and_measures_between_their_lines() -> None:
    construction = solve(between("-0.2 m/s", "-90 deg"), by="exact", repeats=0, precise=False).construction
    pane = next(figure for figure in construction.figures if figure.name == "lever")
    arrows = [mark for mark in pane.marks if isinstance(mark, Vector) and mark.label[:4] == "F_{c"]
    assert len(arrows) == 2 and abs(sum(mark.b - mark.a for mark in arrows)) < 1e-9


def test_what_was_found_by_virtual_power_is_not_found_so_twice() -> None:
    solution = solve(between("-0.2 m/s", "-90 deg"), by="exact", repeats=0, precise=False)
    told = [step.words.en for step in solution.construction.steps if "y virtual power" in step.words.en]
    assert len(told) == 1


def test_a_cylinder_on_the_frame_has_the_lever_too() -> None:
    boom = load("boom-thrust")
    keys = ["F_c", "F_c_power", "F_c_lever"]
    solution = exactly(problem(data_of(boom) | {"find": keys}))
    assert [solution.answers[key].drawn for key in keys] == pytest.approx([solution.answers["F_c"].exact] * 3, rel=1e-9)
