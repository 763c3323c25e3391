"""A driven gear whose crank pin repeats the input's angle: the other gear rolls on all the same, through two turns."""

from __future__ import annotations

import numpy as np
import pytest

from tests.at_once import exactly
from vecpoly.methods.positions.laps import laps
from vecpoly.problem.load import loads

TEXT = """
id: two-gears
title: t
frame: {A: [0 mm, 0 mm], D: [90 mm, 0 mm]}
links:
  1: {gear: A, radius: 30 mm, B: {AB: 22 mm, angle: 200 deg}}
  2: {gear: D, radius: 60 mm, C: {DC: 25 mm, angle: 40 deg}}
  3: {CE: 130 mm}
  4: {BE: 140 mm}
joints: [2 rolls on 1 at H]
branch: [E right of BC]
input: {link: 1, phi: 200 deg, omega: 10 rad/s ccw}
loads: {M_r: {on: 2, size: 4 N*m cw}, F: {on: 3, at: E, size: 5 N, direction: 0 deg}, M_d: {on: 1, size: constant}}
machine: {n: 95 r/min, delta: 0.04}
find: [M_d, dW_max]
"""


def surplus() -> float:
    """Greatest surplus of work (J) over two turns: both loads have a potential, and M_d = −2 N·m takes the moment's."""
    phi = np.radians(200) + np.linspace(0, 4 * np.pi, 20001)
    b = 0.022 * np.exp(1j * phi)
    c = 0.09 + 0.025 * np.exp(1j * (np.radians(40) - (phi - phi[0]) / 2))
    far = np.abs(b - c)
    along = (0.13**2 - 0.14**2 + far**2) / (2 * far)
    e = c + (b - c) / far * (along + 1j * np.sqrt(0.13**2 - along**2))
    return float(np.ptp(5 * e.real))


def test_a_gear_rolls_on_where_the_driven_gear_repeats_the_position_of_the_input() -> None:
    problem = loads(TEXT)
    assert laps(problem.mechanism) == 2
    solution = exactly(problem)
    assert not solution.suspect
    assert solution.answers["M_d"].exact == pytest.approx(-2.0, rel=1e-6)
    assert solution.answers["dW_max"].exact == pytest.approx(surplus(), rel=1e-5)
    assert solution.answers["dW_max"].drawn == pytest.approx(surplus(), rel=0.01)
