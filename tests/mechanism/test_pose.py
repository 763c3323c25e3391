"""Claims about a problem with its drive elsewhere: it is assembled there as it is on the way there."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import often
from vecpoly import oracle
from vecpoly.cycle.pose import posed
from vecpoly.names import At
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem

MOVING = ["3-9", "3-11", "3-12", "4-3a", "A-27", "six-bar-dynamic", "geared-five-bar", "rack-lift"]


def off_the_way(problem: Problem, there: Problem) -> float:
    """How far a letter lies from where it is on the way there, as a part of the mechanism's size."""
    moved = there.mechanism
    way, own = oracle.solve(problem.mechanism, moved.drive.position), oracle.solve(moved)
    letters = [At(letter) for link in moved.links for letter in link.points]
    return max(abs(complex(own.position(at)) - complex(way.position(at))) for at in letters) / moved.scale


@settings(max_examples=often(12))
@given(name=st.sampled_from(MOVING), share=st.floats(0.01, 0.99))
def test_wherever_the_drive_is_put_the_assembly_is_that_of_the_way_there(name: str, share: float) -> None:
    problem = load(name)
    low, high = oracle.spans(problem.mechanism)[0]
    there = next(posed(problem, low + share * (high - low)))
    assert there is not None and off_the_way(problem, there) < 1e-9


def test_at_its_own_position_a_problem_is_itself() -> None:
    for name in MOVING:
        problem = load(name)
        assert next(posed(problem, problem.mechanism.drive.position)) == problem


FOUR_BARS = """\
id: t
title: test
frame: {A: [0 mm, 0 mm], D: [100 mm, 0 mm]}
links:
  1: {AB: 30 mm}
  2: {BC: 90 mm}
  3: {DC: 85 mm}
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
branch: [C above AD]
find: [v_C]
"""


def test_a_statement_that_holds_no_more_gives_way() -> None:
    problem = loads(FOUR_BARS.replace("above AD", "right of D").replace("DC: 85", "DC: 45"))
    moved = [there for there in posed(problem, np.radians([30.0, 120.0, 180.0, 270.0])) if there is not None]
    assert len(moved) == 4 and max(off_the_way(problem, there) for there in moved) < 1e-9
    assert [there.mechanism.branches == problem.mechanism.branches for there in moved] == [True, False, False, False]


def test_where_nothing_can_be_assembled_there_is_no_problem() -> None:
    problem = loads(FOUR_BARS.replace("BC: 90", "BC: 40"))  # B reaches 130 mm from D, and 40 + 85 = 125
    assert next(posed(problem, np.pi)) is None and next(posed(problem, np.radians(70.0))) is not None


def test_what_else_a_problem_says_stays() -> None:
    problem = load("4-3a")
    there = next(posed(problem, problem.mechanism.drive.position + 0.3))
    assert there is not None and replace(there, subject=problem.subject) == problem


@pytest.mark.parametrize("name", MOVING)
def test_many_positions_are_those_taken_one_by_one(name: str) -> None:
    problem = load(name)
    low, high = oracle.spans(problem.mechanism)[0]
    where = np.linspace(low, high, 7)[1:-1]
    assert list(posed(problem, where)) == [next(posed(problem, q)) for q in where]
