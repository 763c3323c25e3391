"""The axes of a cam's diagram are numbered in degrees, and so is their scale: round in °/mm, as a rule lays it off."""

from __future__ import annotations

from math import radians

import pytest

from tests.drawn_library import drawn
from vecpoly.board.construction import Scale, View
from vecpoly.board.place import view_named
from vecpoly.drawing.figure import scale_box
from vecpoly.report.content import scales

CAMS = ("cam-heart", "cam-rocker", "cam-roller-offset", "cam-flat-face")


@pytest.mark.parametrize("name", CAMS)
def test_the_angle_of_a_cam_is_laid_off_by_a_round_scale_in_degrees(name: str) -> None:
    solution = drawn(name).solution
    (figure,) = [one for one in solution.construction.figures if one.scale.across is not None]
    told = figure.scale.right.told
    assert told.unit == "°" and told.value in (2.0, 2.5, 3.0)
    assert figure.scale.right.value == pytest.approx(radians(told.value))
    assert f"{told.value:g} °/mm" in scales(solution, "zh") and "rad/mm" not in scales(solution, "en")


def test_a_scale_that_is_multiplied_by_is_told_in_radians() -> None:
    scale = Scale.of(view_named("torque"), 20.0, 0.05)
    assert scale.right.told == scale.right and scale.right.per_mm == "rad/mm"
    assert scale.told == scale


def test_lengths_are_told_as_they_are() -> None:
    scale = Scale.of(View.MECHANISM, 0.002)
    assert scale.told is scale and scale_box(scale).width > 0
