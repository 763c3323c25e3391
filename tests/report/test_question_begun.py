"""What a frame of a question begins with rests on no datum: the axes of an end view, the numbers on a polygon of
centres; nothing that is to be drawn."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn
from vecpoly.board.construction import Figure
from vecpoly.board.paper.marks import AngleMark, Arc, Point, Role, Segment, Vector
from vecpoly.report.question.blank import framed


def figure(name: str, view: str, called: str = "") -> Figure:
    figures = drawn(name).construction.figures
    return next(one for one in figures if one.view.name == view and one.name.startswith(called))


@pytest.mark.parametrize("name", ["rotor-bolt-circle", "6-1", "6-4", "engine-four"])
def test_an_end_view_begins_with_its_axes_and_tells_no_mass(name: str) -> None:
    _, marks = framed(figure(name, "end-view"), (150.0, 120.0), ())
    assert {mark.label for mark in marks if isinstance(mark, Point)} <= {"O", "x", ""}
    lines = [mark for mark in marks if isinstance(mark, Segment)]
    assert len(lines) == 2 and all(mark.role is Role.CENTRE for mark in lines)
    assert not any(isinstance(mark, Vector | AngleMark | Arc) for mark in marks)


@pytest.mark.parametrize(("name", "links"), [("3-1a", 4), ("3-12", 6), ("3-1c", 3)])
def test_a_polygon_of_centres_begins_with_the_numbers_of_the_links_and_no_line(name: str, links: int) -> None:
    polygons = [one for one in drawn(name).construction.figures if one.name == "centre polygon"]
    for one in polygons:
        _, marks = framed(one, (150.0, 60.0), ())
        labels = [mark.label for mark in marks if isinstance(mark, Point)]
        assert labels == [str(n) for n in range(1, links + 1)]
        assert not any(isinstance(mark, Segment | Vector) for mark in marks)
    assert polygons or name == "3-12"
