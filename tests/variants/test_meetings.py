"""The gate looks at every meeting on the sheet: of ruled lines, of arcs, of a line and an arc."""

from __future__ import annotations

from cmath import exp
from math import acos, degrees, pi, radians

import pytest
from hypothesis import given
from hypothesis import strategies as st

import vecpoly
from vecpoly.board.acts import Meet
from vecpoly.board.hand import hand
from vecpoly.board.otherwise.amended import AS_DRAWN
from vecpoly.solution import constructed
from vecpoly.variants.look import least_meeting

FOUR_BAR = """
id: four-bar
title: {{zh: 铰链四杆机构, en: Four-bar linkage}}
frame: {{A: [0 mm, 0 mm], D: [300 mm, 0 mm]}}
links:
  1: {{AB: 100 mm}}
  2: {{BC: 250 mm}}
  3: {{CD: 200 mm}}
branch: [C above AD]
input: {{link: 1, phi: {phi:.9f} deg, omega: 10 rad/s ccw}}
find: [v_C]
"""


def meetings(phi: float) -> list[Meet]:
    problem = vecpoly.loads(FOUR_BAR.format(phi=phi))
    acts = constructed(problem, hand("exact"), AS_DRAWN).construction.acts
    return [act for act in acts if isinstance(act, Meet) and act.other is not None]


@given(st.floats(20.0, 340.0))
def test_two_arcs_meet_at_the_transmission_angle(phi: float) -> None:
    """Of arcs about B and D with radii BC and CD: the law of cosines in the triangle BCD."""
    b = 100 * exp(1j * radians(phi))
    between = acos((250**2 + 200**2 - abs(b - 300) ** 2) / (2 * 250 * 200))
    found = meetings(phi)
    assert len(found) == 2
    assert all(one.angle == pytest.approx(min(between, pi - between), abs=1e-8) for one in found)


def test_a_position_whose_arcs_graze_is_not_let_through() -> None:
    """BCD is nearly stretched at 174° of transmission angle, where both velocity directions still meet well."""
    problem = vecpoly.loads(FOUR_BAR.format(phi=180.0))
    acts = constructed(problem, hand("exact"), AS_DRAWN).construction.acts
    arcs = min(one.angle for one in meetings(180.0) if one.angle is not None)
    assert degrees(arcs) > 20 and least_meeting(acts) <= arcs
    near = vecpoly.loads(FOUR_BAR.format(phi=180.0).replace("CD: 200", "CD: 152"))
    acts = constructed(near, hand("exact"), AS_DRAWN).construction.acts
    assert degrees(least_meeting(acts)) < degrees(near.gate.meeting(pi)) == pytest.approx(20.0)
