"""A gear that meshes with nothing is drawn: its radius is given."""

from __future__ import annotations

from tests.drawn_library import drawn
from tests.found import FOUND
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import GearMark, Point
from vecpoly.problem.load import loads
from vecpoly.problem.problem import Problem

NAME = "gear-that-meshes-with-nothing"


def pitch_radii(view: View) -> list[float]:
    """The radii of the pitch circles about H (m)."""
    found = []
    for figure in drawn(NAME).figures(view):
        spots = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
        gears = (mark for mark in figure.marks if isinstance(mark, GearMark))
        found += [gear.radius * figure.scale.value for gear in gears if abs(gear.centre - spots["H"]) < 0.01]
    return found


def test_a_gear_that_meshes_with_nothing_is_drawn_about_its_centre() -> None:
    (radius,) = pitch_radii(View.MECHANISM)
    assert abs(radius - 0.049) < 1e-9


def idle(text: str) -> tuple[str, ...]:
    problem: Problem = loads(text)
    return tuple(circle.link for circle in problem.mechanism.idle)


def test_a_gear_that_meshes_with_another_is_not_idle_whichever_of_the_two_rolls() -> None:
    assert idle(FOUND[NAME]) == ("4",)
    assert idle(FOUND[NAME].replace("gear: H, radius: 49 mm", "X: {along: CH, at: 40 mm}")) == ()
