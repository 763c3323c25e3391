"""The name of a force stands nearer to its own line of action than to any other, its own without friction included."""

from __future__ import annotations

from functools import cache

import pytest
import shapely

from tests.laws import few
from tests.studies import solved
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Mark, Point, Role, Segment, Vector
from vecpoly.board.paper.tones import whose
from vecpoly.drawing.figure import Drawing, drawing
from vecpoly.drawing.labels.actions import line_of_action
from vecpoly.drawing.labels.want import Thing

PROBLEMS = ("4-3a", "4-3c", "4-5", "4-6", "winch-gears", "six-bar-dynamic")


@cache
def diagram(name: str) -> tuple[tuple[Mark, ...], Drawing]:
    """The marks of the kinematic diagram, and the diagram as it is drawn."""
    figure = next(one for one in solved(name).construction.figures if one.view is View.MECHANISM)
    return figure.marks, drawing(figure)


def lines(marks: tuple[Mark, ...]) -> list[Segment]:
    """The lines of action of the reactions."""
    return [m for m in marks if isinstance(m, Segment) and m.key.startswith("R_") and m.role in _LINES]


_LINES = (Role.DIRECTION, Role.IDEAL)
ONE = 1e-3  # mm from a line within which another lies on it, though it ends sooner


@pytest.mark.parametrize("name", few(PROBLEMS, 2))
def test_the_name_of_a_force_is_nearer_to_its_own_line_than_to_any_other(name: str) -> None:
    marks, drawn = diagram(name)
    named = [label for label in drawn.labels if label.want.thing is Thing.ACTION and label.foot is None]
    assert named
    for label in named:
        r, own = label.rect, shapely.LineString([(z.real, z.imag) for z in label.want.own])
        box = shapely.box(r.x0, r.y0, r.x1, r.y1)
        key = next(m.key for m in lines(marks) if {m.a, m.b} == set(label.want.own))
        for other in lines(marks):
            line = shapely.LineString([(other.a.real, other.a.imag), (other.b.real, other.b.imag)])
            same = whose(other.key) == whose(key) and line.buffer(ONE).contains(own)  # the tooth's, friction or not
            if other.key != key and not _are_one(other.key, key) and not same:
                assert box.distance(own) < box.distance(line), f"{key} by {other.key}"


def _are_one(one: str, other: str) -> bool:
    """R_12 and R_21 are one force."""
    return whose(one) == whose(other) and one.endswith("_0") == other.endswith("_0")


@pytest.mark.parametrize("name", PROBLEMS)
def test_every_line_of_a_reaction_has_a_name_on_the_diagram(name: str) -> None:
    """4-6: R_12 goes on where R_32 ends, in one line with it."""
    marks, _ = diagram(name)
    names = {m.key for m in marks if isinstance(m, Point | Vector) and m.label and m.key}
    assert [m.key for m in lines(marks) if not any(_are_one(m.key, key) for key in names)] == []
    points = [m for m in marks if isinstance(m, Point)]
    assert any(line_of_action(point, lines(marks)) for point in points)
