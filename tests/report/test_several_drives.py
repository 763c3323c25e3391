"""A mechanism of two degrees of freedom: both drives are named, and both first vectors start from one pole."""

from __future__ import annotations

from vecpoly import loads
from vecpoly.report.statement.structure import structure

FIVE_BAR = """
id: x
title: x
frame: {A: [0 mm, 0 mm], D: [150 mm, 0 mm]}
links:
  1: {AB: 50 mm}
  2: {BC: 130 mm}
  3: {EC: 120 mm}
  4: {DE: 45 mm}
input:
  - {link: 1, phi: 60 deg, omega: 5 rad/s ccw}
  - {link: 4, phi: 80 deg, omega: 3 rad/s ccw, alpha: 4 rad/s^2}
branch: [C left of BE]
find: [v_C, a_C]
"""


def test_all_drives_are_named() -> None:
    """Link 1 alone was said to drive a mechanism of two degrees of freedom."""
    told = structure(loads(FIVE_BAR))
    assert "= 2；构件 1、4 为原动件，其余为" in told.zh and "= 2. Links 1 and 4 drive" in told.en


def test_a_pole_is_taken_once() -> None:
    """It was taken anew for the vector of the second drive."""
    steps = [step.words.zh for step in loads(FIVE_BAR).solve().construction.steps]
    for pole in ("p", "p′"):
        assert sum(f"取极点 ${pole}$" in words for words in steps) == 1
    assert any("一致；作 $pe$ 代表" in words for words in steps)
