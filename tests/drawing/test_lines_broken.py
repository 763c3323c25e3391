"""A long fine line is broken off about a letter that finds no other place near what it names; a name of a line breaks
no other line, as it would be taken for that of the one it stands in."""

from __future__ import annotations

import pytest

from tests.label_faults import faults, leaders
from vecpoly.board.construction import Figure, Scale, View
from vecpoly.board.paper.marks import Dot, Mark, Point, Role, Segment, Vector
from vecpoly.drawing.figure import Bare, Drawing, drawing
from vecpoly.drawing.labels.ground import LONG, gives_way
from vecpoly.drawing.scene import Stroke
from vecpoly.words import Words

SCALE = Scale(symbol="μ_l", value=0.001, unit="m")


def grid(step: float, *marks: Mark, role: Role = Role.CONSTRUCTION, far: float = 40.0) -> Drawing:
    """These marks among upright and level lines, so far apart (mm)."""
    at = [k * step for k in range(-12, 12)]
    lines = [Segment(a=complex(x, -far), b=complex(x, far), role=role) for x in at]
    lines += [Segment(a=complex(-far, y), b=complex(far, y), role=role) for y in at]
    title = Words("机构运动简图", "Kinematic diagram")
    return drawing(Figure(view=View.MECHANISM, title=title, scale=SCALE, marks=(*lines, *marks)))


POINT = Point(at=1.2 + 1.4j, label="C", dot=Dot.POINT)


def test_a_letter_among_long_fine_lines_stands_beside_its_point_and_breaks_one_off() -> None:
    drawn = grid(3.4, POINT)
    assert not leaders(drawn) and not faults(drawn)
    assert len([item for item in drawn.obstacles if isinstance(item, Stroke)]) > 48


@pytest.mark.parametrize("role", [Role.LINK, Role.RESULT, Role.GIVEN])
def test_no_line_is_broken_off_that_is_no_fine_one(role: Role) -> None:
    drawn = grid(5.0, Point(at=1.2 + 1.4j, label="C_{12}", dot=Dot.POINT), role=role)
    assert len([item for item in drawn.obstacles if isinstance(item, Stroke)]) == 48


def test_a_short_line_is_not_broken_off() -> None:
    title = Words("机构运动简图", "Kinematic diagram")
    for long in (LONG - 1.0, LONG + 1.0):
        line = Segment(a=0j, b=long + 0j, role=Role.CONSTRUCTION)
        (stroke,) = Bare.of(Figure(view=View.MECHANISM, title=title, scale=SCALE, marks=(line,)), "en").items
        assert isinstance(stroke, Stroke) and gives_way(stroke) is (long > LONG)


def test_the_name_of_a_vector_between_two_lines_goes_farther_off() -> None:
    high, low = (Segment(a=-40 + y * 1j, b=40 + y * 1j, role=Role.CONSTRUCTION) for y in (3.4, -2.6))
    vector = Vector(a=-10 + 0j, b=10 + 0j, role=Role.RESULT, label="v_{CB}")
    title = Words("机构运动简图", "Kinematic diagram")
    drawn = drawing(Figure(view=View.MECHANISM, title=title, scale=SCALE, marks=(high, low, vector)))
    assert len([item for item in drawn.obstacles if isinstance(item, Stroke)]) == 3 and not faults(drawn)
