"""Two letters that all but coincide are told apart in an enlarged detail; a numbered series is not."""

from __future__ import annotations

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.board.paper.marks import Dot, Point
from vecpoly.drawing.details.knots import TWINS, Crowd, knots


def crowd(*places: complex) -> Crowd:
    """A figure of 100 mm with letters of their own there."""
    return Crowd(places, (), 100.0, (), places)


def test_two_letters_a_millimetre_apart_are_drawn_apart_and_two_at_five_are_not() -> None:
    (knot,) = crowd(0j, 1 + 0j, 60 + 40j).knots
    assert knot.holds(0j) and knot.holds(1 + 0j) and knot.factor >= 5.0
    assert not crowd(0j, 5 + 0j).knots and not crowd(0j, 0.1 + 0j).knots


def test_letters_of_a_numbered_series_are_told_by_their_neighbours() -> None:
    assert not Crowd((0j, 1 + 0j), (), 100.0).knots


@each(IDS)
def test_no_two_letters_of_a_construction_coincide_nearly_without_a_detail(name: str) -> None:
    for figure in drawn(name).construction.figures:
        own = Crowd.of(figure).own
        near = [(a, b) for n, a in enumerate(own) for b in own[:n] if TWINS[0] <= abs(a - b) <= TWINS[1]]
        assert all(any(knot.holds(a) and knot.holds(b) for knot in knots(figure)) for a, b in near)


def test_the_corner_and_the_foot_of_the_least_circle_are_told_apart() -> None:
    (figure,) = drawn("cam-least-circle").construction.figures
    at = {m.label: m.at for m in figure.marks if isinstance(m, Point) and m.dot is not Dot.NONE}
    assert any(knot.holds(at["D"]) and knot.holds(at["E"]) for knot in knots(figure))
