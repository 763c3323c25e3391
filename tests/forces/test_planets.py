"""Forces on planets and their arms: equilibrium of arm, planet and the gear that several planets share."""

from __future__ import annotations

from math import cos, radians, tan

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vecpoly
from tests.forces.test_pins_in_slots import agreeing, exact_hand
from tests.laws import often
from vecpoly.problem.load import load
from vecpoly.solution import solve

TRAINS = """
id: x
title: two trains on one sun
frame: {A: [0 mm, 0 mm]}
links:
  1: {gear: A, radius: 20 mm, alpha: %s deg}
  2: {gear: B, radius: 15 mm}
  3: {AB: 35 mm, phi: 60 deg}
  4: {gear: C, radius: 23 mm}
  5: {AC: 43 mm, phi: 190 deg}
joints:
  - 2 rolls on 1 at H
  - 2 rolls inside circle about A of 50 mm at K
  - 4 rolls on 1 at L
  - 4 rolls inside circle about A of 66 mm at N
input: {link: 1, phi: 0 deg, omega: 20 rad/s ccw}
loads: {M_3: {on: 3, size: %s N*m}, M_5: {on: 5, size: %s N*m}, X: {on: %s, size: "?"}%s}
"""


@settings(max_examples=often(3))
@given(alpha=st.floats(0, 40), three=st.floats(-90, 90).filter(lambda m: abs(m) > 1), five=st.floats(1, 90))
def test_each_planet_bears_half_its_arms_moment_at_either_pitch_point(alpha: float, three: float, five: float) -> None:
    """R^t = M / (2 l) at H and at K; the sun bears the sum of its tangential forces times its radius. α is the sun's;
    the teeth of the ring have 20°."""
    found = exact_hand(TRAINS % (alpha, three, five, 1, "") + "find: [R_12, R_62, R_32, R_14, X]\n").answers
    assert found["R_12"].drawn == pytest.approx(abs(three) / 0.07 / cos(radians(alpha)), rel=1e-9)
    assert found["R_62"].drawn == pytest.approx(abs(three) / 0.07 / cos(radians(20)), rel=1e-9)
    bearing = abs(three) / 0.07 * abs(complex(2, tan(radians(20)) - tan(radians(alpha))))
    assert found["R_32"].drawn == pytest.approx(bearing, rel=1e-9)
    assert found["R_14"].drawn == pytest.approx(five / 0.086 / cos(radians(alpha)), rel=1e-9)
    assert found["X"].drawn == pytest.approx(-0.02 * (three / 0.07 + five / 0.086), rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("link", [1, 2, 3, 5])
def test_the_balancing_load_may_act_on_any_link_of_either_train(link: int) -> None:
    on_planet = ", F: {on: 4, at: C, size: 300 N, direction: 20 deg}"
    text = TRAINS % (20, -30, -18, link, on_planet) + "find: [X, R_12, R_32, R_63, R_14, R_64, R_54, R_65, R_61]\n"
    assert agreeing(exact_hand(text)) == 9


def test_a_train_without_load_presses_on_nothing() -> None:
    text = TRAINS % (20, -30, -18, 1, "") + "find: [R_12, R_14, R_54]\n"
    found = exact_hand(text.replace("M_5: {on: 5, size: -18 N*m}, ", "")).answers
    assert found["R_14"].drawn == found["R_54"].drawn == 0 < found["R_12"].drawn


def test_friction_of_pins_asks_more_of_the_sun() -> None:
    text = TRAINS % (20, -30, -18, 1, "") + "friction: {A: {rho: 1 mm}, B: {rho: 2 mm}, C: {rho: 2 mm}}\n"
    solution = exact_hand(text + "find: [X, X_0, R_12, R_32, R_63, R_14, R_54, R_65]\n")
    assert agreeing(solution) == 8
    assert solution.answers["X"].drawn > solution.answers["X_0"].drawn > 0


def test_the_sheet_tells_why_one_pair_of_teeth_is_alone_in_its_moment_equation() -> None:
    steps = vecpoly.load("two-trains-one-sun").solve(by="exact").construction.steps
    assert any(
        "R_{64}$ passes through $N$" in step.words.en and "R_{64}$ 过节点 $N$" in step.words.zh for step in steps
    )


def test_a_planet_between_sun_and_ring_is_told_as_what_stands_in_the_way_and_the_arm_as_the_driver_instead() -> None:
    solution = solve(load("planetary-reactions"), by="exact", repeats=0, precise=False)
    (said,) = (one.words for one in solution.construction.steps if "link 3 is taken as the driver" in one.words.en)
    assert "from link 1 the mechanism has planet gears." in said.en and "含有行星轮系" in said.zh
    assert "only class II groups and single gears, which" in said.en and "Ⅱ 级杆组和单个齿轮组成" in said.zh
