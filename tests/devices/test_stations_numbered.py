"""What stands at the places of a diagram: the stations of a cam beyond its roller, round angles where a curve jumps."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import drawn
from tests.label_faults import text_of
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import Arc, Note, Point
from vecpoly.drawing.figure import drawing
from vecpoly.methods.diagrams.axes import MOST, STEPS, angle_steps


def cam(name: str) -> Figure:
    """The profile of a cam."""
    return next(one for one in drawn(name).figures(View.MECHANISM) if not one.name)


@pytest.mark.parametrize("name", ["cam-undercut", "cam-roller-offset"])
def test_each_station_of_a_roller_has_its_number_beyond_all_its_circles(name: str) -> None:
    figure = cam(name)
    numbers = [m for m in figure.marks if isinstance(m, Point) and re.fullmatch(r"\d+", m.label)]
    radius = min(m.radius for m in figure.marks if isinstance(m, Arc))
    rollers = [m for m in figure.marks if isinstance(m, Arc) and m.radius == pytest.approx(radius)]
    assert len(numbers) > 10
    assert all(abs(number.at - circle.centre) > circle.radius for number in numbers for circle in rollers)


def test_no_number_of_a_station_needs_a_leader() -> None:
    labels = [one for one in drawing(cam("cam-undercut")).labels if text_of(one).isdigit()]
    assert len(labels) == 23 and all(one.foot is None for one in labels)


@pytest.mark.parametrize(("corners", "step"), [((), 45), ((120.0, 360.0), 60), ((90.0,), 45), ((7.0,), 45)])
def test_angles_are_written_where_a_curve_has_its_corners_if_round_ones_are_there(
    corners: tuple[float, ...], step: int
) -> None:
    assert angle_steps(360.0, corners) == step and step in STEPS and 360 / step <= MOST


def test_the_angle_at_which_the_power_of_a_shaper_jumps_stands_on_the_axis() -> None:
    notes = [m.words.en for one in drawn("7-4").construction.figures for m in one.marks if isinstance(m, Note)]
    assert "120°" in notes
