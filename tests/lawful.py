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


EVERY = (  # every key of a load that depends on place and speed
    PLAIN.replace("BC: 220 mm", "BC: 220 mm, G: {along: BC, at: 90 mm, left: 30 mm}")
    + """\
loads:
  F: {on: 3, at: C, size: 300 N, direction: 0 deg, while: C moves left, between: [5 %, 95 %]}
  Q: {on: 3, at: C, size: 200 N, direction: 0 deg, during: [20 deg, 90 deg]}
  P:
    {on: 3, at: C, direction: 180 deg,
     size: {columns: [phi (deg), p (MPa)], rows: [[0, 1], [60, 2], [360, 1]], bore: 50 mm}}
  F_s: {spring: D-C3, k: 5 N/mm, l_0: 80 mm, preload: 20 N}
  F_d: {damper: D-G, c: 50 N*s/m}
  M_s: {spring: 2-4, k: 20 N*m/rad, phi_0: 10 deg}
  M_d: {on: 1, motor: [200 N*m, 2 N*m*s]}
find: [M_b]
"""
)
CHANGED = {  # key: the file, what stands there, what stands there instead
    "load.while": (EVERY, "while: C moves left", "while: C moves right"),
    "load.between": (EVERY, "[5 %, 95 %]", "[80 %, 95 %]"),
    "load.during": (EVERY, "[20 deg, 90 deg]", "[70 deg, 90 deg]"),
    "load.motor": (EVERY, "200 N*m", "210 N*m"),
    "load.spring": (EVERY, "spring: D-C3", "spring: D-G"),
    "load.damper": (EVERY, "damper: D-G", "damper: D-C3"),
    "load.k": (EVERY, "k: 5 N/mm", "k: 6 N/mm"),
    "load.l_0": (EVERY, "l_0: 80 mm", "l_0: 81 mm"),
    "load.phi_0": (EVERY, "phi_0: 10 deg", "phi_0: 11 deg"),
    "load.preload": (EVERY, "preload: 20 N", "preload: 21 N"),
    "load.c": (EVERY, "c: 50 N*s/m", "c: 60 N*s/m"),
    "table.table": (EVERY, "columns: [phi (deg), p (MPa)], rows: [[0, 1], [60, 2], [360, 1]]", "table: none.csv"),
    "table.columns": (EVERY, "[phi (deg), p (MPa)]", "[phi (rad), p (MPa)]"),
    "table.rows": (EVERY, "[60, 2]", "[60, 3]"),
    "table.area": (EVERY, "bore: 50 mm", "area: 900 mm^2"),
    "table.bore": (EVERY, "bore: 50 mm", "bore: 60 mm"),
}
