"""The path along which an iterated group is followed keeps the assembly that it began with, and does not break off
where nothing ends."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from vecpoly import load, loads
from vecpoly.mechanism.model import Mechanism
from vecpoly.names import omega
from vecpoly.oracle import plan, planning, solve, spans
from vecpoly.oracle.run import STEP

# between 8.4° and 9.7° on from here the plate is swung round by half a radian within a hundredth of one of the crank
SHARP = """
id: sharp
title: a plate that is swung round at once
frame: {A: [0 mm, 0 mm], H: [35.230954810 mm, 71.437278601 mm], L: [124.482683322 mm, 91.370546858 mm]}
links:
  1: {AB: 31.690546114 mm, E: {along: AB, at: 83.306717319 mm, left: -49.111024066 mm}}
  2: {CD: 120.701029408 mm, F: {along: CD, at: -51.279429328 mm, left: -49.162869562 mm},
      G: {along: CD, at: 132.285199674 mm, left: -36.965920969 mm},
      I: {along: CD, at: 39.622063771 mm, left: -123.975193004 mm},
      J: {along: CD, at: 171.227271287 mm, left: 81.300403392 mm},
      K: {along: CD, at: 85.943201822 mm, left: 30.241772357 mm}}
  3: {block: H}
  4: {LK: 49.845698804 mm}
joints: [E runs in FG of 2, 3 slides on IJ]
input: {link: 1, phi: 108 deg, omega: 3 rad/s}
guesses: {C: [8.302 mm, 168.389 mm], D: [91.194 mm, 80.653 mm], F: [-62.650 mm, 171.901 mm]}
find: [omega_2]
"""
# gears whose loops close, at some positions, to twice a rounding error before the last step
RACK = """
id: rack
title: a gear on a rack that slides on a coupler
frame: {A: [0 mm, 0 mm], C: [108.17293318844918 mm, 75.50978309564306 mm]}
links:
  1: {AB: 67.06971471569204 mm, gear: B, radius: 33.0948428504353 mm}
  2: {BD: 137.9745288486532 mm}
  3: {CD: 80.4677894348709 mm}
  4: {block: E, rack: E, s: 22.48948101892752 mm}
joints: [4 slides on BD of 2 with E 33.0948428504353 mm right, 1 rolls on 4 at F]
branch: [D right of BC]
input: {link: 1, phi: 78.57049587584822 deg, omega: 4 rad/s cw}
find: [v_E]
"""


def mechanism(text: str) -> Mechanism:
    found = loads(text).mechanism
    assert isinstance(found, Mechanism)
    return found


def turned(mech: Mechanism, asked: NDArray[np.float64], link: str) -> NDArray[np.complex128]:
    """e^{iφ} of the link at these positions; NaN where the path to them is lost."""
    return planning.build(mech).bodies(asked, 0, strict=False)[link].unit


def test_a_path_of_long_strides_stays_on_the_assembly_that_one_of_short_strides_follows(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    mech = mechanism(SHARP)
    asked = mech.drive.position + np.radians(np.arange(0.0, 25.0, 2.0))
    long = turned(mech, asked, "2")
    monkeypatch.setattr(plan, "STEP", STEP / 16)
    short = turned(mech, asked, "2")
    assert np.isfinite(long).all()
    assert np.abs(long - short).max() < 1e-9


def test_a_loop_that_closes_with_its_last_step_is_closed() -> None:
    """Its gap was taken before that step: the range of such a mechanism fell into thirteen pieces."""
    [whole] = spans(mechanism(RACK))
    assert whole == pytest.approx((0.0, 2 * np.pi))


@pytest.mark.parametrize("name", ["three-legged-plate", "class-iii-slides"])
def test_the_range_of_a_class_iii_group_ends_at_dead_points_and_not_where_its_angle_is_0(name: str) -> None:
    mech = load(name).mechanism
    assert isinstance(mech, Mechanism)
    [(low, high)] = spans(mech)
    assert low <= mech.drive.position + 2 * np.pi <= high or low <= mech.drive.position <= high
    turn = 2 * np.pi * (high > mech.drive.position + 2 * np.pi)
    for end, inwards in ((low - turn, 1.0), (high - turn, -1.0)):
        rates = solve(mech, end + inwards * np.array([-1e-4, 1e-8, 1e-4]), order=1, strict=False).value(omega("2"))
        assert np.isnan(rates[0]) and abs(rates[1]) > 50 * abs(rates[2])
