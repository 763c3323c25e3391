"""What moments about the special point say of the third leg is laid off on the polygon of a class III group: a number
of its own, that is read nowhere again."""

from __future__ import annotations

import pytest

import vecpoly
from tests.at_once import exactly
from vecpoly.algebra.formula import plain

THREE_SLIDES = """
id: three-slides
title: a central link with three slides
frame: {A: [0 mm, 0 mm], K: [160.35 mm, 161.15 mm]}
links:
  1: {AB: 25.87 mm, E: {along: AB, at: -12.54 mm, left: 206.56 mm}, H: {along: AB, at: 66.94 mm, left: 110.9 mm}}
  2:
    CD: 36.36 mm
    F: {along: CD, at: -120.26 mm, left: 50.75 mm}
    G: {along: CD, at: 84.97 mm, left: -104.7 mm}
    I: {along: CD, at: -63.26 mm, left: -20.51 mm}
    J: {along: CD, at: 153.66 mm, left: 40.22 mm}
    L: {along: CD, at: -61.97 mm, left: 144.57 mm}
  3: {block: E}
  4: {block: H}
  5: {slot: K}
joints:
  - 3 slides on FG with E 4.16 mm left
  - 4 slides on IJ
  - L of 2 slides in 5 with L 14.35 mm right turned -150.23 deg
input: {link: 1, phi: 339 deg, omega: 3 rad/s}
guesses: {C: [72 mm, 158 mm], D: [77 mm, 122 mm], L: [208 mm, 238 mm]}
loads: {F_q: {on: 2, at: C, size: 892 N, direction: -21 deg}, %s}
find: [%s, R_23, R_24, R_52, R_65]
"""


@pytest.mark.parametrize(
    ("load", "name"), [('M_1: {on: 1, size: "?"}', "M_1"), ('X_b: {on: 2, size: "?"}', "X_b")], ids=["driver", "plate"]
)
def test_what_moments_say_of_the_third_leg_is_not_read_again(load: str, name: str) -> None:
    """R_52 = 859.7 N by moments had “R_52 = μ_F bc = 860 N” below it."""
    found = exactly(vecpoly.loads(THREE_SLIDES % (load, name)))
    for answer in found.answers.values():
        assert answer.drawn == pytest.approx(answer.exact, rel=1e-8, abs=1e-8), answer.key
    steps = found.construction.steps
    lines = [plain(line) for step in steps for line in step.formulas]
    by_moments = [line for line in lines if line.startswith("R_") and "h_S" in line]
    assert len(by_moments) == 1
    symbol = by_moments[0].partition(" = ")[0]
    assert not [line for line in lines if line.startswith(f"{symbol} = μ_F")]
    assert not any(f"${symbol[:2]}{{{symbol[2:]}}}$" in step.words.zh.partition("量得")[2] for step in steps)
