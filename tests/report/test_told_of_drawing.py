"""What a reader must know to read a figure is told: vectors drawn side by side, a parallelogram and its letters."""

from __future__ import annotations

from itertools import combinations

import pytest

from tests.drawn_library import drawn
from tests.each import each
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Mark, Point, Vector
from vecpoly.report.content import statement

CYLINDERS = ("excavator-boom", "tipper", "lift-gate", "boom-thrust")


def coincide(name: str) -> bool:
    """Whether two vectors of a polygon that are not one lie on each other."""
    figures = [figure for figure in drawn(name).construction.figures if not figure.view.bodies]
    return any(_covers(one, other) for f in figures for one, other in combinations(_vectors(f.marks), 2))


def _vectors(marks: tuple[Mark, ...]) -> list[Vector]:
    found = [mark for mark in marks if isinstance(mark, Vector) and abs(mark.b - mark.a) > 2]
    return list({(mark.a, mark.b): mark for mark in found}.values())


def _covers(one: Vector, other: Vector) -> bool:
    ends = [(end - one.a) / (one.b - one.a) for end in (other.a, other.b)]
    inside = min(1.0, max(z.real for z in ends)) - max(0.0, min(z.real for z in ends))
    return all(abs(z.imag) * abs(one.b - one.a) < 0.1 for z in ends) and inside * abs(one.b - one.a) > 1.5


@each(("excavator-boom", "6-2", "7-1", "5-1", "3-9", "8-1", "3-3", "A-16"))
def test_vectors_that_are_drawn_side_by_side_are_told_of(name: str) -> None:
    assert bool(statement(drawn(name).solution, "zh")["doubled"]) is coincide(name)


@pytest.mark.parametrize("name", CYLINDERS)
def test_every_corner_of_a_parallelogram_of_velocities_has_a_letter(name: str) -> None:
    (figure,) = drawn(name).figures(View.VELOCITY)
    letters = [mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label]
    tips = [mark.b for mark in figure.marks if isinstance(mark, Vector)]
    assert all(min(abs(tip - at) for at in letters) < 0.1 for tip in tips)
