"""Reactions and equivalents asked of one mechanism: what acts is told once, what is zero is told, and where a length is
too short the step says so that uses it."""

from __future__ import annotations

import re

from vecpoly import loads
from vecpoly.algebra.formula import plain
from vecpoly.board.construction import Step

FOUR_BAR = """
id: x
title: x
frame: {A: [0 mm, 0 mm], D: [140 mm, 0 mm]}
links:
  1: {AB: 40 mm}
  2: {BC: 120 mm, E: {along: BC, at: 3 mm}}
  3: {DC: 80 mm}
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw, alpha: 0 rad/s^2}
branch: [C left of BD]
loads:
  M_s: {spring: 1-3, k: 4 N*m/rad, phi_0: 0 deg}
  Q: {on: 3, at: C, size: 90 N, direction: 180 deg, while: C moves right}
  M_1: {on: 1, size: "?"}
MASSES
find: [FIND]
"""


def _steps(masses: str = "", find: str = "M_1, R_12, J_e, M_e") -> tuple[Step, ...]:
    text = FOUR_BAR.replace("MASSES", masses).replace("FIND", find)
    return loads(text).solve().construction.steps


def test_what_a_spring_and_a_window_do_is_told_once_for_reactions_and_equivalents() -> None:
    """The equivalent moment measured the spring again, in the same words."""
    words = [step.words.zh for step in _steps()]
    assert len([one for one in words if "$M_s$" in one and "量角器" in one]) == 1
    assert len([one for one in words if "$C$ 点" in one and "运动" in one]) <= 1
    assert len({*words}) == len(words)


def test_an_equivalent_inertia_of_nothing_is_told() -> None:
    """The step said how J_e is found, and not that it is zero."""
    (none,) = [step.words.zh for step in _steps(find="J_e") if "动能等效" in step.words.zh]
    assert none.endswith("各构件不计质量，故 $J_{e}$ = 0。")
    at_rest = _steps("masses: {1: {mass: 2 kg, centre: A}}", find="J_e")
    (still,) = [step.words.zh for step in at_rest if "动能等效" in step.words.zh]
    assert still.endswith("各质量都没有动能，故 $J_{e}$ = 0。")
    assert "No mass has kinetic energy" in next(step.words.en for step in at_rest if "J_{e}" in step.words.en)


def test_the_step_that_uses_a_length_says_that_it_is_too_short() -> None:
    """An answer is read off the finished drawing: the last step said it, of the moment M_e, and not that of v_EB."""
    steps = _steps(find="v_EB, M_1, M_e")
    (said,) = [step for step in steps if re.search(r"\$be\$ ≈ [\d.]+ mm", step.words.zh)]
    assert any("v_EB" in plain(line) and "be" in plain(line) for line in said.formulas)
    assert said is not steps[-1] and "过短" in said.words.zh
