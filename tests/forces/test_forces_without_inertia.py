"""Where a mass has no acceleration in one position it has no inertia force there, and nothing else changes."""

from __future__ import annotations

import pytest

from vecpoly import oracle
from vecpoly.problem.load import loads
from vecpoly.solution import solve

TEXT = """
id: rest
title: rest
frame: {{A: [0 mm, 0 mm]}}
links: {{1: {{AB: 60 mm}}, 2: {{BC: 220 mm}}, 3: {{block: C}}}}
joints: [3 slides on y = 0 mm]
branch: [C right of B]
input: {{link: 1, phi: {phi!r} deg, omega: 20 rad/s ccw}}
loads: {{F: {{on: 3, at: C, size: 300 N, direction: 180 deg}}, M_1: {{on: 1, size: "?"}}}}
masses: {{3: {{mass: 2 kg, inertia: 0 kg*m^2, centre: C}}}}
find: [M_1, M_1_power, M_1_lever, F_I3, R_12]
"""


def without_acceleration() -> float:
    """The crank angle in degrees at which the slider's acceleration vanishes."""
    low, high = 60.0, 100.0
    for _ in range(80):
        middle = (low + high) / 2
        pull = complex(oracle.solve(loads(TEXT.format(phi=middle)).mechanism).acceleration("C")).real
        low, high = (middle, high) if pull < 0 else (low, middle)
    return low


def test_a_slider_without_acceleration_has_no_inertia_force_and_all_methods_agree() -> None:
    answers = solve(loads(TEXT.format(phi=without_acceleration())), by="exact").answers
    assert abs(answers["F_I3"].drawn) < 1e-6
    for key in ("M_1", "M_1_power", "M_1_lever", "R_12"):
        assert answers[key].drawn == pytest.approx(answers[key].exact, rel=1e-9), key
