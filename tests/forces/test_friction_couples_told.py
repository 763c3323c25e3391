"""Where moments are taken, the couple of friction at a pin is told before it is used."""

from __future__ import annotations

import re

import pytest

from vecpoly import load, loads
from vecpoly.algebra.formula import plain
from vecpoly.solution import solve

CROSSED = """
id: t
title: t
frame: {A: [0 mm, 0 mm], D: [-38.89 mm, 66.44 mm]}
links:
  1: {block: E}
  2: {block: E}
  3: {AB: 84.0864 mm}
joints: [1 slides on AB of 3, 2 slides on line through D at 64 deg]
branch: []
input: {link: 3, phi: 162.1958 deg, omega: 4 rad/s}
loads:
  F: {on: 2, at: E, size: 399 N, direction: -99 deg}
  F_1: {on: 1, at: E, size: 200 N, direction: -30 deg}
  M: {on: 3, size: "?"}
friction: {A: {rho: 2 mm}, E: {rho: 1.962345 mm}}
find: [M, R_42]
"""


@pytest.mark.parametrize("name", ["crossed", "4-3a"])
def test_a_couple_of_friction_that_is_reckoned_with_is_told(name: str) -> None:
    """h_42 = M_f12/R_42 was printed, and nowhere what M_f12 was."""
    steps = solve(loads(CROSSED) if name == "crossed" else load(name), repeats=0, precise=False).construction.steps
    used = [n for n, step in enumerate(steps) if any("M_f" in plain(one) for one in step.formulas)]
    told = [n for n, step in enumerate(steps) if "$M_{fij}$ = $ρ R_{ij}$" in step.words.zh]
    assert bool(used) is bool(told) is (name == "crossed") and told[:1] < (used[:1] or [1])
    assert not [step.words.zh for step in steps if re.search(r"= \d+\.\d{4,} mm", step.words.zh)]
