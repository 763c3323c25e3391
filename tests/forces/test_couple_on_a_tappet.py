"""A tappet that bears a couple alone: nothing presses at its contact, and its guide passes the couple on."""

from __future__ import annotations

import pytest

from tests.generators.equilibrium import in_equilibrium
from vecpoly import loads

TAPPET = """
id: x
title: x
frame: {O: [0 mm, 0 mm]}
links:
  1: {OC: 15 mm, disc: C, radius: 40 mm}
  2: {block: B, disc: B, radius: 6 mm}
joints: [2 slides on x = 5 mm, 1 touches 2 at T]
input: {link: 1, phi: 32 deg, omega: 7.0 rad/s ccw}
branch: [B above C]
loads:
  M_q: {on: 2, size: 24 N*m}
  X: {on: 1, size: "?"}
"""
LEVER = (
    TAPPET.replace("frame: {O: [0 mm, 0 mm]}", "frame: {O: [0 mm, 0 mm], D: [90 mm, 10 mm]}")
    .replace("2: {block: B, disc: B", "2: {DB: 80 mm, disc: B")
    .replace("2 slides on x = 5 mm, ", "")
)


def test_at_the_contact_of_a_tappet_under_a_couple_nothing_presses() -> None:
    """R_12 was asked where nothing is asked, and not found."""
    solution = loads(TAPPET).solve(by="exact")
    assert solution.answers["R_12"].drawn == 0 == solution.answers["R_32"].drawn
    assert solution.answers["R_32"].exact == pytest.approx(0.0, abs=1e-9)
    words = [step.words.zh for step in solution.construction.steps]
    assert any("力偶由构件 3 与 2 间的移动副承受" in one for one in words)
    assert in_equilibrium(solution) == ""


@pytest.mark.parametrize("more", ["", "  F_1: {on: 2, at: B, size: 50 N, direction: 20 deg}\n"])
def test_a_lever_under_a_couple_presses_there(more: str) -> None:
    text = LEVER.replace("  X:", f"{more}  X:").replace("24 N*m", "8 N*m")
    solution = loads(text).solve(by="exact")
    assert solution.answers["R_12"].drawn == pytest.approx(abs(solution.answers["R_12"].exact), rel=1e-9)
    assert solution.answers["R_12"].drawn > 1 and in_equilibrium(solution) == ""
