"""A compass leaves as much of a circle as its meetings need: whole circles about a linkage bury it."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from math import pi, tau

from hypothesis import given
from hypothesis import strategies as st

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.board.board import Board
from vecpoly.board.construction import View
from vecpoly.board.hand import hand
from vecpoly.board.paper.extent import bounds
from vecpoly.board.paper.ink import marks
from vecpoly.board.paper.marks import Arc, Mark, Point, Role
from vecpoly.board.scale import Scale

LINKAGES = ("8-4", "8-14", "8-15", "K-crank-rocker-BC", "K-slider-crank-AB", "K-slider-crank-BC")
FAR = 15.0  # mm that an arc stands out beyond all that it serves
ON = 0.01  # mm
VIEW = View.MECHANISM


@each(dict.fromkeys((*IDS, *LINKAGES)))
def test_no_construction_circle_makes_a_diagram_larger_than_its_points_links_and_named_circles(name: str) -> None:
    for figure in drawn(name).construction.figures:
        if figure.view is VIEW and (helpers := [one for one in figure.marks if is_helper(one, figure.marks)]):
            low, high = bounds([one for one in figure.marks if one not in helpers])
            least, most = bounds(helpers)
            beyond = low - least, most - high
            assert max(part for far in beyond for part in (far.real, far.imag)) < FAR, figure.name


def is_helper(mark: Mark, beside: tuple[Mark, ...]) -> bool:
    """Whether it is an arc that is constructed with, on which no name stands (η), and no centre of curvature."""
    if not isinstance(mark, Arc) or mark.role is not Role.CONSTRUCTION or mark.radius * mark.sweep < 2 * FAR:
        return False
    named = (one for one in beside if isinstance(one, Point))
    return not any(
        (one.label.startswith("η") and abs(abs(one.at - mark.centre) - mark.radius) < ON)
        or (one.label == "K" and abs(one.at - mark.centre) < ON)
        for one in named
    )


ways = st.lists(st.floats(-pi, pi), min_size=1, max_size=6)


@given(ways, st.floats(5.0, 200.0), st.complex_numbers(max_magnitude=300.0))
def test_arcs_pass_all_meetings_and_end_near_one_of_them(at: list[float], radius: float, centre: complex) -> None:
    points = [centre + cmath.rect(radius, way) for way in at]
    left = list(arcs_past(points, radius, centre))
    for way in at:
        assert any(inside(way, arc) for arc in left)
    for arc in left:
        assert 0 < arc.sweep <= tau
        for end in (arc.start, arc.start + arc.sweep):
            assert arc.sweep == tau or min(abs(cmath.phase(cmath.exp(1j * (end - way)))) for way in at) <= pi / 4 + 1e-9


def arcs_past(points: list[complex], radius: float, centre: complex) -> Iterator[Arc]:
    """The arcs that the compass leaves."""
    board = Board(hand("exact"), {VIEW: Scale.of(VIEW, 1.0)})
    board.arcs_past(VIEW, centre, radius, *points)
    return (mark for mark in marks(board.acts).get(VIEW, ()) if isinstance(mark, Arc))


def inside(way: float, arc: Arc) -> bool:
    """Whether a direction lies within an arc's sweep."""
    return (way - arc.start) % tau <= arc.sweep + 1e-9 or (arc.start - way) % tau < 1e-9
