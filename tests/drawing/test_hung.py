"""Supports stand where they cover no link: below as a rule, above a link that hangs, and stay so as the crank turns."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import AngleMark, Ground, Mark, Role, Segment
from vecpoly.drawing.hung import WAYS, hung

BELOW, ABOVE, LEFT, RIGHT = WAYS


def bar(to: complex) -> Segment:
    return Segment(a=0j, b=to, role=Role.LINK)


def side(*marks: Mark) -> complex:
    """On which side the support of a pivot at the origin stands among these marks."""
    return next(mark.down for mark in hung((Ground(at=0j, down=BELOW), *marks)) if isinstance(mark, Ground))


@pytest.mark.parametrize("to", [30 + 0j, 30j, -30 + 0j, 20 + 20j, 25 - 12j])
def test_a_support_stands_below_a_link_that_rises_or_lies(to: complex) -> None:
    assert side(bar(to)) == BELOW


@pytest.mark.parametrize("to", [-30j, 5 - 30j, -8 - 30j])
def test_a_link_that_hangs_has_its_support_above(to: complex) -> None:
    assert side(bar(to)) == ABOVE


def test_a_link_that_runs_through_above_and_below_has_its_support_beside_it() -> None:
    assert side(bar(-30j), bar(30j)) == LEFT


def test_a_support_never_stands_on_the_ray_of_an_angle() -> None:
    angle = AngleMark(at=0j, radius=8.0, start=0.0, sweep=1.0, label="φ")
    assert side(bar(-30j), bar(30j), angle) != 1 + 0j


def test_a_support_that_was_put_on_a_side_on_purpose_stays() -> None:
    [ground, _] = hung((Ground(at=0j, down=LEFT), bar(-30 + 0j)))
    assert isinstance(ground, Ground) and ground.down == LEFT


def test_supports_stay_as_they_stand_where_the_crank_has_turned() -> None:
    held = (Ground(at=3j, down=ABOVE),)
    [ground, _] = hung((Ground(at=0j, down=BELOW), bar(30 + 0j)), held)
    assert ground == Ground(at=0j, down=ABOVE)


@pytest.mark.parametrize(("name", "above"), [("three-legged-plate", 1), ("three-positions", 2), ("3-9", 0)])
def test_of_the_library_those_hang_that_a_draughtsman_would_hang(name: str, above: int) -> None:
    problem = drawn(name)
    view = View.MECHANISM if problem.figures(View.MECHANISM) else problem.construction.figures[0].view
    marks = hung(problem.figures(view)[0].marks)
    assert sum(isinstance(mark, Ground) and mark.down == ABOVE for mark in marks) == above
