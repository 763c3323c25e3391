"""Where the contact of a flat face is farthest from its guide: OP = ds/dφ, on the side on which the cam moves as the
follower does, P being the pole of the two."""

from __future__ import annotations

from cmath import rect
from math import pi, radians

import pytest

from vecpoly import loads, solve
from vecpoly.board.paper.marks import Point

CAM = """\
id: face
title: face
device: cam
data:
  follower: {flat: yes}
  r0: 50 mm
  turns: TURNS
  motion: [rise 20 mm in 120 deg cosine, dwell 30 deg, return in 120 deg parabolic, dwell 90 deg]
find: [b_rise, b_return]
"""


@pytest.mark.parametrize(("turns", "sense"), [("ccw", 1), ("cw", -1)])
def test_the_pole_lies_on_the_normal_of_the_contact_on_rise_and_return(turns: str, sense: int) -> None:
    """On the return it was drawn on the other side of O."""
    problem = loads(CAM.replace("TURNS", turns))
    (figure,) = (
        one for one in solve(problem, by="exact", repeats=0).construction.figures
        if any(isinstance(mark, Point) and mark.label == "P_1" for mark in one.marks)
    )  # fmt: skip
    at = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
    span, mm = radians(120), figure.scale.value
    rise, back = pi * 0.020 / (2 * span), -2 * 0.020 / span  # greatest ds/dφ: cosine at 60°, parabola at 210°
    for name, slope, degrees in (("P_1", rise, 60), ("P_2", back, 210)):
        turned = sense * slope / mm * rect(1.0, -sense * radians(degrees))
        assert at[name] - at["O"] == pytest.approx(turned, abs=0.05)
