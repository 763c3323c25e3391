"""An angle has two rays, on every figure of the library: none is told from nothing."""

from __future__ import annotations

import cmath

import pytest

from tests.drawn_library import drawn
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import AngleMark, Mark, Role, Segment
from vecpoly.drawing.rays import BEYOND, rayed

ANGLE = AngleMark(at=2 + 1j, radius=8.0, start=0.3, sweep=1.0, label="φ")


def added(*marks: Mark, view: View = View.MECHANISM) -> list[Segment]:
    return [mark for mark in rayed(view, (ANGLE, *marks))[1 + len(marks) :] if isinstance(mark, Segment)]


def ray(way: float, length: float = 20.0) -> Segment:
    return Segment(a=ANGLE.at, b=ANGLE.at + cmath.rect(length, way), role=Role.LINK)


def test_each_ray_that_is_missing_is_drawn_past_the_arc() -> None:
    assert [cmath.phase(one.b - one.a) for one in added()] == pytest.approx([0.3, 1.3])
    assert all(abs(one.b - one.a) == pytest.approx(8.0 + BEYOND) for one in added())


def test_a_ray_that_is_a_line_already_is_not_drawn_again() -> None:
    assert [cmath.phase(one.b - one.a) for one in added(ray(0.3))] == pytest.approx([1.3])
    assert not added(ray(0.3), ray(1.3))


def test_a_line_elsewhere_is_no_ray_of_it() -> None:
    assert len(added(ray(0.3, 4.0), ray(1.45))) == 2


def test_a_line_that_only_crosses_the_end_of_an_arc_is_no_ray_of_it() -> None:
    """The edge of another link over the end of φ of a driving link with an offset slot."""
    end, across = ANGLE.at + cmath.rect(ANGLE.radius, 1.3), cmath.rect(5.0, 2.3)
    assert len(added(ray(0.3), Segment(a=end - across, b=end + across, role=Role.LINK))) == 1


@pytest.mark.parametrize(("name", "count"), [("dead-centre", 0), ("cam-moves-arm", 1), ("3-9", 0)])
def test_of_the_library_angles_get_the_rays_that_they_lack(name: str, count: int) -> None:
    problem = drawn(name)
    view = View.MECHANISM if problem.figures(View.MECHANISM) else problem.construction.figures[0].view
    figures = problem.figures(view)[:1]
    assert [len(rayed(view, one.marks)) - len(one.marks) for one in figures] == [count]
