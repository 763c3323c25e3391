"""A couple that goes on through blocks: every force that stands on no polygon is told by the one that it equals."""

from __future__ import annotations

from vecpoly import loads, solve
from vecpoly.algebra.formula import plain

CHAIN = """
id: passed
title: {zh: 力偶, en: A couple on a block in a slot}
frame: {A: [0 mm, 0 mm], D: [-37.91 mm, 116.78 mm], F: [-10.04 mm, -121.91 mm]}
links:
  1: {block: B}
  2: {slot: F}
  3: {AB: 49.3017 mm}
  4: {block: B}
  5: {slot: C}
  6: {block: B}
  7: {slot: C, E: {along: C, at: 111 mm}}
joints: [1 slides in 5, 5 slides on line through D at 1 deg turned 114 deg, 6 slides in 7, 4 slides in 2]
input: {link: 3, phi: 114.5591 deg, omega: 9 rad/s}
loads: {M_q: {on: 6, size: -31 N*m}, X_b: {on: 3, size: "?"}}
pins: {B: 4}
"""


def test_a_reaction_that_another_tells_is_not_measured_between_places_without_letters() -> None:
    solution = solve(loads(CHAIN), by="exact", repeats=0)
    lines = [plain(line) for step in solution.construction.steps for line in step.formulas]
    assert not [line for line in lines if "—" in line]
    assert [line for line in lines if line.startswith(("R_41 = R_76", "R_51 = R_76"))]
