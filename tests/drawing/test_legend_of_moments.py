"""The legend of a diagram of moments is true of every letter on it."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import IDS, drawn, given
from tests.each import Later, each
from vecpoly.board.construction import Figure
from vecpoly.board.paper.marks import Point, Role, Segment
from vecpoly.drawing.legend.letters import LETTERS, Letter
from vecpoly.figures.torque import TORQUE

NEAR = 0.05  # mm


def _moments(name: str) -> list[Figure]:
    return [one for one in drawn(name).construction.figures if one.view is TORQUE and one.name != "rays"]


def _told(figure: Figure, english: str) -> list[complex]:
    """Where the letters stand that the legend calls so."""
    (letter,) = (one for one in LETTERS if one.words.en == english)
    assert isinstance(letter, Letter) and letter.on(figure)
    return [
        mark.at for mark in figure.marks if isinstance(mark, Point) and re.compile(letter.written).fullmatch(mark.label)
    ]


def _curves(figure: Figure) -> list[list[Segment]]:
    """The segments of each curve, as its corners were joined one after the other."""
    found: list[list[Segment]] = []
    for mark in figure.marks:
        if isinstance(mark, Segment) and mark.role is Role.RESULT:
            if found and abs(found[-1][-1].b - mark.a) < NEAR:
                found[-1].append(mark)
            else:
                found.append([mark])
    return found


def _far(at: complex, line: Segment) -> float:
    along = line.b - line.a
    share = min(max(((at - line.a) * along.conjugate()).real / max(abs(along) ** 2, 1e-12), 0.0), 1.0)
    return abs(at - line.a - share * along)


def _is_lettered(name: str) -> bool:
    """Whether work is read between the curves: where the constant moment alone is asked, none of its ends is lettered,
    and the legend has none."""
    return any(_told(figure, "ends of the period") for figure in _moments(name)) or given(name).machine is not None


WITH_MOMENTS = Later(lambda: [name for name in IDS if _is_lettered(name)])


@each(WITH_MOMENTS)
def test_where_the_curves_are_said_to_meet_both_of_them_are(name: str) -> None:
    for figure in _moments(name):
        curves, places = _curves(figure), _told(figure, "the curves of both moments meet")
        assert len(curves) == 2 and places
        assert all(min(_far(at, line) for line in curve) < NEAR for at in places for curve in curves)


@each(WITH_MOMENTS)
def test_the_ends_of_the_period_are_where_the_curves_begin_and_end(name: str) -> None:
    for figure in _moments(name):
        ends = sorted(at.real for at in _told(figure, "ends of the period"))
        for curve in _curves(figure):
            assert ends == pytest.approx([curve[0].a.real, curve[-1].b.real], abs=NEAR)
