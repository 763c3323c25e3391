"""What stands at the places of a diagram: the stations of a cam beyond its roller, round angles where a curve jumps."""

from __future__ import annotations

import re
from typing import Any

import pytest

from tests.cam_cases import device
from tests.cam_cases import drawn as inverted
from tests.drawn_library import drawn
from tests.label_faults import text_of
from tests.laws import few
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import Arc, Curve, Note
from vecpoly.drawing.figure import drawing
from vecpoly.methods.diagrams.axes import MOST, STEPS, angle_steps


def cam(name: str) -> Figure:
    """The profile of a cam."""
    return next(one for one in drawn(name).figures(View.MECHANISM) if not one.name)


@pytest.mark.parametrize("name", ["cam-undercut", "cam-roller-offset"])
def test_each_station_of_a_roller_has_its_number_beyond_all_its_circles(name: str) -> None:
    figure = cam(name)
    numbers = [m for m in figure.marks if isinstance(m, Note) and m.words.en.isdigit()]
    radius = min(m.radius for m in figure.marks if isinstance(m, Arc))
    rollers = [m for m in figure.marks if isinstance(m, Arc) and m.radius == pytest.approx(radius)]
    assert len(numbers) > 10
    assert all(abs(number.at - circle.centre) > circle.radius for number in numbers for circle in rollers)


@pytest.mark.parametrize("name", ["cam-flat-face", "cam-flat-arm", "cam-heart", "cam-rocker"])
def test_all_stations_but_the_first_stand_outside_the_cam_on_their_rays(name: str) -> None:
    """Some stood inside the profile, some between two points; odd ones were missing."""
    figure = cam(name)
    notes = [m for m in figure.marks if isinstance(m, Note) and m.words.en.isdigit()]
    assert [int(m.words.en) for m in notes] == [*range(1, len(notes) + 1)] and len(notes) > 22
    labels = {text_of(one): one for one in drawing(figure).labels if text_of(one).isdigit()}
    curve = max(abs(z) for m in figure.marks if isinstance(m, Curve) for z in m.points)
    for note in notes:
        away = labels[note.words.en].centre - note.at
        assert (away * note.side.conjugate()).real > 0.7 * abs(away)
        assert abs(note.at) > 0.6 * curve


@pytest.mark.parametrize("name", ["cam-flat-face", "cam-roller-offset"])
def test_the_numbers_of_a_displacement_diagram_stand_under_their_ordinates(name: str) -> None:
    """Those at the ends of pieces stood beside the marks of the angles."""
    figure = next(one for one in drawn(name).construction.figures if one.view.name == "displacement")
    for label in drawing(figure).labels:
        if text_of(label).isdigit():
            assert abs((label.centre - label.want.own[0]).real) < 1.1


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


@pytest.mark.parametrize("turns", ["ccw", "cw"])
@pytest.mark.parametrize("follower", few([{"knife": "yes"}, {"arm": {"OA": "80 mm", "AB": "70 mm"}}], 2))
def test_the_stations_follow_each_other_in_the_sense_in_which_the_step_turns_the_follower_about_the_cam(
    turns: str, follower: dict[str, Any]
) -> None:
    by = "25 deg" if "arm" in follower else "30 mm"
    motion = [f"rise {by} in 120 deg cosine", "dwell 30 deg", "return in 120 deg parabolic", "dwell 90 deg"]
    made = inverted(device("cam", follower=follower, motion=motion, r0="35 mm", turns=turns))
    sheet = next(one for one in made.figures if one.view is View.MECHANISM)
    places = {m.words.en: m.at for m in sheet.marks if isinstance(m, Note) and m.words.en.isdigit()}
    (said,) = (one.words for one in made.steps if "Add $−ω$" in one.words.en)
    counter = (places["2"] / places["1"]).imag > 0
    assert re.search(r"(?:turns|goes round) (\S+), against", said.en)[1] == (  # type: ignore[index]
        "counter-clockwise" if counter else "clockwise"
    )
    assert re.search("按(.*)反转", said.zh)[1] == ("逆时针" if counter else "顺时针")  # type: ignore[index]
