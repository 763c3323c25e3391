"""Where crank and rod are in one line is asked of a crank with a rod, and not of a cam, whose rod is another one at
every place."""

from __future__ import annotations

import pytest

from vecpoly import loads
from vecpoly.errors import ProblemFileError
from vecpoly.mechanism.asked.centres import crank_groups

CAM = """
id: x
title: x
frame: {O: [0 mm, 0 mm], A: [-80 mm, 0 mm]}
links:
  1: {cam: {about: O, follower: {roller: 8 mm, arm: {OA: 80 mm, AB: 70 mm, side: left}}, r0: 45 mm, turns: cw,
      motion: [rise 9 deg in 111 deg sine, dwell 20 deg, return in 114 deg sine, dwell 115 deg]}}
  2: {AB: 70 mm}
  3: {disc: B, radius: 8 mm}
joints: [1 touches 3 at T]
input: {link: 1, phi: -60 deg, omega: 7 rad/s ccw}
find: [v_B]
"""
DISC = """
id: x
title: x
frame: {A: [0 mm, 0 mm], D: [90 mm, 0 mm]}
links:
  1: {AO: 20 mm, disc: O, radius: 45 mm}
  2: {DE: 70 mm, disc: E, radius: 12 mm}
joints: [1 touches 2 at T]
input: {link: 1, phi: 60 deg, omega: 7 rad/s ccw}
branch: [E left of OD]
find: [phi_E_extended, phi_E_overlapped]
"""


def test_of_the_follower_of_a_plate_cam_no_limits_of_a_crank_are_asked() -> None:
    """phi_B_overlapped ended in a traceback: the follower comes to rest over a whole dwell, by no crank and rod."""
    assert crank_groups(loads(CAM).mechanism) == ()
    with pytest.raises(ProblemFileError, match="phi_B_overlapped"):
        loads(CAM.replace("find: [v_B]", "find: [phi_B_overlapped]"))


def test_of_the_follower_of_an_eccentric_disc_they_are() -> None:
    answers = loads(DISC).solve(by="exact").answers
    assert answers["phi_E_extended"].exact != pytest.approx(answers["phi_E_overlapped"].exact, abs=1.0)
