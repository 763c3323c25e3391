"""A mass that stands at a hinge which leads outwards is shared by the hinges that lead to the frame."""

from __future__ import annotations

import cmath
from math import degrees, pi

import pytest

from vecpoly.problem.load import loads
from vecpoly.solution import solve

TEXT = """
id: outer-hinge
title: t
frame: {A: [0 mm, 0 mm], D: [150 mm, 0 mm]}
links: {1: {AB: 39 mm}, 2: {BC: 140 mm, E: {along: BC, at: 70 mm, left: 30 mm}}, 3: {DC: 90 mm}, 4: {EF: 130 mm}, 5: {block: F}}
joints: [5 slides on y = -30 mm]
input: {link: 1, phi: 304 deg, omega: 10 rad/s ccw}
branch: [C left of BD, F right of E]
masses: {2: {mass: 1 kg, inertia: 0.002 kg*m^2, centre: E}, 3: {rod: {diameter: 20 mm, density: 7800 kg/m^3}}}
counterweights: {1: {r: 40 mm}, 3: {r: 50 mm}}
find: [W_c1, theta_c1, W_c3, m_c]
"""  # noqa: E501


def test_a_mass_at_a_hinge_of_a_further_link_is_not_carried_away_from_the_frame() -> None:
    """Link 1 was said to carry no mass. S = B + z (C − B), so that 1 − z of it goes with AB and z with DC."""
    z, rod = complex(70, 30) / 140, 7800 * pi * 0.02**2 / 4 * 0.09
    first, third = -(1 - z) * 0.039, -(z * 0.09 + rod * 0.045)
    exact = {key: answer.exact for key, answer in solve(loads(TEXT), repeats=0).answers.items()}
    assert exact["W_c1"] == pytest.approx(abs(first), rel=1e-9)
    assert exact["theta_c1"] == pytest.approx(degrees(cmath.phase(first)) % 360, rel=1e-9)
    assert exact["W_c3"] == pytest.approx(abs(third), rel=1e-9)
    assert exact["m_c"] == pytest.approx(abs(first) / 0.04 + abs(third) / 0.05, rel=1e-9)
