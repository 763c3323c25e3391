"""Teeth have a pressure angle, and so has a driven link: where both are told each has a symbol of its own."""

from __future__ import annotations

import pytest

from vecpoly import loads
from vecpoly.board.construction import Construction

GEARED = """
id: x
title: x
frame: {A: [0 mm, 0 mm], C: [80 mm, 0 mm], G: [190 mm, 0 mm]}
links:
  1: {gear: A, radius: 30 mm}
  2: {gear: C, radius: 50 mm, D: {CD: 35 mm, angle: 70 deg}}
  3: {DH: 110 mm}
  4: {GH: 80 mm}
joints: [2 rolls on 1 at E]
input: {link: 1, phi: 0 deg, omega: 10 rad/s ccw}
branch: [H left of DG]
loads:
  M_4: {on: 4, size: 20 N*m cw}
  M_1: {on: 1, size: "?"}
"""


def _solved(find: str) -> Construction:
    return loads(f"{GEARED}find: [{find}]\n").solve(by="exact").construction


def _meshing(construction: Construction) -> list[str]:
    return [step.words.zh for step in construction.steps if "沿啮合线" in step.words.zh]


def _letters(construction: Construction) -> set[str]:
    return {label for figure in construction.figures for m in figure.marks if (label := getattr(m, "label", ""))}


def test_beside_the_pressure_angle_of_a_link_that_of_the_teeth_is_their_working_one() -> None:
    """Both were called α, 58° and 20°."""
    both = _solved("alpha, R_12, M_1")
    assert _meshing(both) and all("啮合角 $α'$ = 20°" in words for words in _meshing(both))
    assert "α'" in _letters(both) and "α" not in _letters(both)


@pytest.mark.parametrize("find", ["R_12, M_1", "gamma, R_12, M_1"])
def test_where_no_other_pressure_angle_is_told_that_of_teeth_is_alpha(find: str) -> None:
    alone = _solved(find)
    assert _meshing(alone) and all("压力角 $α$ = 20°" in words for words in _meshing(alone))
    assert "α" in _letters(alone)
