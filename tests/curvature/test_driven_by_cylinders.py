"""Curvatures do not ask what drives: a cylinder between two moving links as well as a crank."""

from __future__ import annotations

import numpy as np
import pytest

import vecpoly
from tests.laws import few
from vecpoly.solution import Solution

ROD = """
id: x
title: the rod of a cylinder
frame: {A: [0 mm, 0 mm], D: [450 mm, -350 mm]}
links:
  1: {AC: 1150 mm}
  2: {cylinder: D}
  3: {piston: C, E: {along: C, at: -300 mm, left: 150 mm}}
joints: [3 slides in 2]
input: {cylinder: 2-3, length: 900 mm, v: 0.12 m/s}
branch: [C left of AD]
method: curvature
"""
LIFTED = """
id: x
title: a four-bar that a cylinder lifts
frame: {A: [0 mm, 0 mm], D: [70 mm, 0 mm], G: [-40 mm, -20 mm]}
links:
  1: {AB: 35 mm, F: {along: AB, at: 20 mm, left: 15 mm}}
  2: {BC: 51 mm, E: {along: BC, at: 20 mm, left: 25 mm}}
  3: {DC: 69 mm}
  4: {cylinder: G}
  5: {piston: F}
joints: [5 slides in 4]
input: {cylinder: 4-5, length: 60 mm, v: 10 mm/s}
branch: [C left of BD, F left of GA]
method: curvature
"""


def _agreeing(text: str) -> Solution:
    solution = vecpoly.loads(text).solve(by="exact")
    for key, one in solution.answers.items():
        drawn, exact = (one.drawn_vector, one.exact_vector) if one.drawn_vector is not None else (one.drawn, one.exact)
        assert drawn is not None and exact is not None
        assert abs(drawn - exact) < 1e-9, key
    return solution


@pytest.mark.parametrize("way", few(["bobillier", "euler-savary", "hartmann", "aronhold"], 2))
def test_a_cylinder_or_the_lever_itself_may_drive_the_circle_is_the_same(way: str) -> None:
    asked = f"construction: {way}\nfind: [P_34, W_3, delta_3, p_OE, rho_E]\n"
    base = complex(450, -350)
    lever = np.angle(base) + np.arccos((1150**2 + abs(base) ** 2 - 900**2) / (2 * 1150 * abs(base)))
    driven = f"input: {{link: 1, phi: {np.degrees(lever):.13f} deg, omega: ccw}}"
    turned = ROD.replace("input: {cylinder: 2-3, length: 900 mm, v: 0.12 m/s}", driven)
    one, other = (_agreeing(text + asked) for text in (ROD, turned.replace("branch: [C left of AD]\n", "")))
    assert other.answers["rho_E"].drawn == pytest.approx(one.answers["rho_E"].drawn, rel=1e-9)
    assert other.answers["delta_3"].drawn == pytest.approx(one.answers["delta_3"].drawn, rel=1e-9)


@pytest.mark.parametrize("way", ["euler-savary", "hartmann"])
def test_a_coupler_that_is_lifted_has_its_circle_and_path(way: str) -> None:
    solution = _agreeing(f"{LIFTED}construction: {way}\nfind: [P_26, W_2, delta_2, p_OE, rho_E, lambda_2]\n")
    assert any("Trace the path of $E$" in step.words.en for step in solution.construction.steps)


def test_both_centrodes_roll_while_the_cylinder_lengthens() -> None:
    text = f"{ROD}find: [P_34, {{centrodes: 3, positions: 6, over: [800 mm, 1000 mm]}}]\n"
    answers = _agreeing(text).answers
    assert answers["L_f3"].drawn == pytest.approx(answers["L_m3"].drawn, rel=2e-3)  # chords of curves that roll
