"""A slider-crank whose loads depend on place and speed, as text; and what each claims by itself."""

from __future__ import annotations

from vecpoly.problem.load import loads
from vecpoly.problem.problem import Problem

PLAIN = """\
id: lawful
title: a slider-crank
frame: {A: [0 mm, 0 mm], D: [150 mm, 90 mm]}
links:
  1: {AB: 60 mm}
  2: {BC: 220 mm}
  3: {block: C}
joints: [3 slides on y = 0 mm]
input: {link: 1, phi: 50 deg, omega: 300 r/min ccw}
branch: [C right of B]
"""
UNKNOWN = 'M_1: {on: 1, size: "?"}'
CARD = "columns: [s (mm), p (MPa)], rows: [[0, 3], [30, 2], [120, 0.4], [60, 0.2], [0, 0.1]]"
ENGINE = f"F: {{on: 3, at: C, size: {{{CARD}, bore: 50 mm}}, direction: 180 deg}}"
CUT = "F: {on: 3, at: C, size: 3000 N, direction: 0 deg, while: C moves left, between: [5 %, 95 %]}"
SPRING = "F_s: {spring: D-C3, k: 5 N/mm, l_0: 80 mm, preload: 20 N, c: 50 N*s/m}"
COIL = "M_s: {spring: 4-2, k: 20 N*m/rad, phi_0: 10 deg, preload: 1 N*m, c: 0.1 N*m*s}"


def slider(*entries: str, unknown: str = UNKNOWN, more: str = "", find: str = "M_1", plain: str = PLAIN) -> Problem:
    """The slider-crank with these loads and the unknown one."""
    body = "".join(f"  {entry}\n" for entry in (*entries, unknown) if entry)
    return loads(f"{plain}loads:\n{body}{more}find: [{find}]\n")
