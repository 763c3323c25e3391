"""A reaction that leans by little in its slide presses on the side where its friction was laid."""

from __future__ import annotations

import pytest

from tests.forces.hung import hung
from vecpoly.problem.load import loads
from vecpoly.solution import solve

OLDHAM = """
id: oldham
title: t
frame: {A: [0 mm, 0 mm], D: [60 mm, 0 mm]}
links: {1: {slot: A}, 2: {block: K}, 3: {slot: D}}
joints: [2 slides in 1, 2 slides in 3 turned 90 deg]
input: {link: 1, phi: 40 deg, omega: 10 rad/s ccw, alpha: 4 rad/s^2}
loads: {M_3: {on: 3, size: -5 N*m}, M_1: {on: 1, size: "?"}}
friction: {1-2: {f: 0.1}, 2-3: {f: 0.1}}
masses: {2: {mass: 3 kg}}
weight: yes
find: [M_1, M_1_0]
"""


def test_a_disc_whose_slide_changes_sides_with_little_friction_is_not_called_locked() -> None:
    """Its velocity is drawn 0.1° off the guide; with a hundredth of the friction the reaction leans by less."""
    answers = solve(loads(OLDHAM)).answers
    assert answers["M_1"].exact == pytest.approx(5.395546, rel=1e-6)
    assert answers["M_1"].drawn == pytest.approx(5.395546, abs=answers["M_1"].expected_error)
    assert answers["M_1"].suspect is None


ALONG = """
loads: {F_c: {spring: A-F5, k: 1 N/mm, l_0: 100 mm}, M_1: {on: 1, size: "?"}}
masses: {4: {mass: 5 kg, inertia: 0.1 kg*m^2, centre: {along: A, at: 100 mm}}}
friction: {4-5: {f: 0.1}}
find: [M_1, M_1_0, R_45]
"""


def test_a_block_that_is_pulled_along_its_slot_is_not_called_locked() -> None:
    """Its slot bears next to nothing, and that reaction is short on paper."""
    answers = solve(hung("slot", "block", "phi: 40 deg, omega: 3 rad/s cw", ALONG)).answers
    assert answers["M_1"].drawn == pytest.approx(answers["M_1"].exact, abs=answers["M_1"].expected_error)
