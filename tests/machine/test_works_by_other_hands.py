"""What a hand reads as nothing another may read as something: the expected error of a zero is none."""

from __future__ import annotations

from vecpoly import loads, solve

NEAR = """\
id: near
title: near a dead point of link 2
frame: {A: [0 mm, 0 mm], F: [-40.994329417 mm, 156.637027419 mm], G: [-82.024249804 mm, 85.583743087 mm]}
links:
  1: {AB: 51.479753699 mm, H: {along: AB, at: -103.243889395 mm, left: -172.488388409 mm}}
  2: {CD: 64.972323935 mm, E: {along: CD, at: 48.149929041 mm, left: 54.685641926 mm}}
  3: {FC: 78.157992761 mm}
  4: {GD: 111.853066931 mm}
  5: {HE: 70.799024780 mm}
input: {link: 1, phi: 161.0 deg, omega: 3 rad/s, alpha: 0 rad/s^2}
guesses: {C: [35.662 mm, 171.884 mm], D: [27.680 mm, 107.404 mm], E: [84.018 mm, 117.380 mm]}
loads: {M_q: {on: 2, size: -238 N*m}}
weight: no
find: [M_e]
"""


def test_a_moment_that_does_no_work_by_this_hand_has_an_expected_error() -> None:
    found = solve(loads(NEAR), repeats=40).answers["M_e"]
    assert found.drawn == 0 and 0 < abs(found.exact) < found.expected_error


def test_what_does_no_work_by_any_hand_has_none() -> None:
    still = NEAR.replace("M_q: {on: 2, size: -238 N*m}", "F_q: {on: 1, at: A, size: 10 N, direction: 20 deg}")
    found = solve(loads(still), repeats=40).answers["M_e"]
    assert found.drawn == found.exact == found.expected_error == 0
