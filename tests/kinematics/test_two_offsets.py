"""A guide that passes neither its pivot nor the pin of its block: the step tells the radius that is drawn."""

from __future__ import annotations

import pytest

from vecpoly import loads
from vecpoly.board.paper.marks import Arc, Point

BOTH = """
id: x
title: x
frame: {{A: [0 mm, 0 mm], C: [0 mm, -110 mm]}}
links:
  1: {{AB: 50 mm}}
  3: {{CD: 200 mm, slot: {{through: C, angle: 0 deg from CD, left: {left} mm}}}}
  2: {{block: B}}
joints: [2 slides in 3 with B {off}]
input: {{link: 1, phi: 30 deg, omega: 10 rad/s}}
branch: [D above C]
find: [omega_3]
"""


@pytest.mark.parametrize(
    ("left", "off", "told", "mm"),
    [(12, "8 mm left", "之和", 20.0), (-12, "8 mm left", "之差", 4.0), (12, "8 mm right", "之差", 4.0)],
)
def test_the_radius_of_an_arc_of_two_offsets_is_told_as_their_sum_or_difference(
    left: int, off: str, told: str, mm: float
) -> None:
    """e was called the radius, whichever way the guide passed the pivot."""
    construction = loads(BOTH.format(left=left, off=off)).solve(by="exact").construction
    (step,) = [one.words.zh for one in construction.steps if "为半径作弧，过" in one.words.zh]
    assert told in step and "$e/μ_l$" not in step
    figure = construction.figures[0]
    (pin,) = [mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label == "B"]
    assert "r = e" not in [mark.label for mark in figure.marks if isinstance(mark, Point)]
    radii = [mark.radius for mark in figure.marks if isinstance(mark, Arc) and abs(mark.centre - pin) < 1e-9]
    assert mm / 1e3 / figure.scale.value in [pytest.approx(radius) for radius in radii]
