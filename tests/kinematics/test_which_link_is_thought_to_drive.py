"""A link that hardly turns while the cylinder acts is not thought to drive: another is, from which nothing is
magnified."""

from __future__ import annotations

from tests.generators.judge import gap
from vecpoly import Problem, loads, solve

NEAR_ITS_DEAD_POINT = """
id: inside
title: inside
frame: {A: [0 mm, 0 mm], D: [300 mm, 0 mm]}
links:
  1: {AB: 208 mm, P: {along: AB, at: 52 mm, left: 13 mm}}
  2: {BC: 103 mm}
  3: {DC: 316.076455 mm, Q: {along: DC, at: 49 mm, left: 45 mm}}
  4: {piston: P}
  5: {cylinder: Q}
joints: [4 slides in 5]
input: {cylinder: 4-5, length: LENGTH mm, v: -0.05 m/s, a: 0.2 m/s^2}
branch: [C left of BD]
guesses: {B: [-70.60 mm, -195.65 mm], C: [20.46 mm, -147.52 mm]}
find: [v_C, a_C, omega_2, omega_3, alpha_2, alpha_3]
"""


def at(length: str) -> Problem:
    return loads(NEAR_ITS_DEAD_POINT.replace("LENGTH", length))


def test_near_the_dead_point_of_one_link_another_is_thought_to_drive_and_nothing_is_lost() -> None:
    drawn = solve(at("283.24383"), by="drafting")
    assert "link 3 drive instead" in " ".join(step.words.en for step in drawn.construction.steps if step.words)
    for one in drawn.answers.values():
        assert abs(one.deviation) <= 0.01 * abs(one.exact), one.key
    exact = solve(at("283.24383"), by="exact", repeats=0)
    assert all(gap(one) <= 1e-9 * abs(one.exact) for one in exact.answers.values())


def test_elsewhere_the_first_link_is_thought_to_drive() -> None:
    words = " ".join(step.words.en for step in solve(at("275"), by="exact").construction.steps if step.words)
    assert "link 1 drive instead" in words
