"""What is read or given stands on the sheet at its place: the stroke, pressure angles, places of A that are tried."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import AngleMark, Dot, Point, Vector


@pytest.mark.parametrize("name", ["8-16", "K-slider-crank-BC"])
def test_the_stroke_has_its_dimension_between_the_limit_positions(name: str) -> None:
    sheet = drawn(name).figures(View.MECHANISM)[0]
    at = {mark.label: mark.at for mark in sheet.marks if isinstance(mark, Point)}
    lines = [mark for mark in sheet.marks if isinstance(mark, Vector) and abs((mark.a + mark.b) / 2 - at["H"]) < 1e-6]
    assert sorted(mark.a.real for mark in lines) == pytest.approx(sorted((at["C_1"].real, at["C_2"].real)))


@pytest.mark.parametrize("name", ["8-2a", "8-2b", "8-2e"])
def test_a_pressure_angle_that_is_read_has_its_value_at_its_arc(name: str) -> None:
    solution = drawn(name).solution
    (figure,) = drawn(name).figures(View.MECHANISM)
    arcs = {mark.key: mark.label for mark in figure.marks if isinstance(mark, AngleMark) and "=" in mark.label}
    assert len(arcs) == 2
    for key, label in arcs.items():
        assert float(label.split(" = ")[1].removesuffix("°")) == pytest.approx(solution.answers[key].drawn, abs=0.05)


def test_the_place_that_is_found_is_none_of_those_that_were_tried() -> None:
    figure = drawn("best-gamma").figures(View.MECHANISM)[0]
    at = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point) and mark.dot is not Dot.NONE}
    tried = [place for label, place in at.items() if label.rstrip("′").isdigit()]
    assert all(abs(at["A"] - place) > 4.0 for place in tried)
