"""A centre at infinity is a direction: told from 0 to 180°, and its arrow points that way."""

from __future__ import annotations

import cmath
from math import degrees

import pytest

import vecpoly
from tests.drawn_library import drawn
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Dot, Point, Role, Segment, Vector

SHAPERS = ("3-1a", "3-1b", "3-1c", "3-1d", "3-1e", "A-27")


@pytest.mark.parametrize("name", SHAPERS)
def test_the_arrow_towards_a_centre_at_infinity_points_as_its_direction_is_told(name: str) -> None:
    text = vecpoly.load(name).text
    problem = vecpoly.loads(text[: text.index("find:")] + "find: [centres]\n")
    solution = vecpoly.solve(problem, by="exact", repeats=0, precise=False)
    marks = [mark for figure in solution.construction.figures for mark in figure.marks]
    endless = [one for one in solution.answers.values() if one.is_place and one.drawn_vector is None]
    assert endless
    arrows = [mark for mark in marks if isinstance(mark, Vector) and mark.role is Role.DIRECTION]
    for one in endless:
        letters = [m.at for m in marks if isinstance(m, Point) and m.dot is Dot.NONE and m.label == one.reading.symbol]
        (arrow,) = (min(arrows, key=lambda arrow: abs(arrow.b - at)) for at in letters)
        told = degrees(cmath.phase(arrow.b - arrow.a)) % 360.0
        assert 0.0 <= one.drawn < 180.0 and abs((told - one.drawn + 180.0) % 360.0 - 180.0) < 1e-6


@pytest.mark.parametrize("name", ["3-1e", "3-1c"])
def test_the_arrow_towards_a_centre_at_infinity_lies_on_no_bar(name: str) -> None:
    for figure in drawn(name).figures(View.MECHANISM):
        bars = [mark for mark in figure.marks if isinstance(mark, Segment) and mark.role is Role.LINK]
        for arrow in (mark for mark in figure.marks if isinstance(mark, Vector) and mark.role is Role.DIRECTION):
            for bar in bars:
                way = (bar.b - bar.a) / abs(bar.b - bar.a)
                tip, tail = ((end - bar.a) * way.conjugate() for end in (arrow.b, arrow.a))
                on = max(abs(tip.imag), abs(tail.imag)) < 1.0 and 0 < tip.real < abs(bar.b - bar.a)
                assert not on, (figure.name, arrow)
