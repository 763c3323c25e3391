"""The curved arrow of a moment lies on no circle about its pivot and on no other curved arrow."""

from __future__ import annotations

from math import pi

import pytest

from tests.drawn_library import drawn
from vecpoly.board.paper.arrow_radius import clear_radius
from vecpoly.board.paper.bodies import GearMark
from vecpoly.board.paper.marks import Arc, Mark, Role, TurnArrow
from vecpoly.report.acting import acting

WHEEL = GearMark(centre=0j, radius=13.3, step=1)
ARROW = TurnArrow(at=0j, radius=16.0, start=0.0, ccw=True, label="M", step=1)
HALF = Arc(centre=0j, radius=13.0, start=0.0, sweep=pi / 2, role=Role.CENTRE, step=1)


@pytest.mark.parametrize(
    ("marks", "size"), [((), 13.0), ((HALF,), 13.0), ((WHEEL,), 16.0), ((WHEEL, ARROW), 19.0), ((ARROW,), 13.0)]
)
def test_it_stands_farther_out_where_something_is_in_its_way(marks: tuple[Mark, ...], size: float) -> None:
    assert clear_radius(marks, 0j, 13.0) == size
    assert clear_radius(marks, 30j, 13.0) == 13.0


def test_two_moments_about_one_pivot_are_told_apart_on_the_sketch() -> None:
    found = drawn("planetary-reactions")
    (figure, *_) = found.construction.figures
    marks = acting(found.problem.mechanism, found.problem.loads, figure, figure)  # type: ignore[arg-type]
    radii = {one.label: one.radius for one in marks if isinstance(one, TurnArrow)}
    assert len(radii) == 2 and abs(radii["M_{1}"] - radii["M_{3}"]) >= 2.5
