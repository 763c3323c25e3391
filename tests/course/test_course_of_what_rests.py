"""A course report of links that never turn: a rate that is zero all along has no share to be told in per cent."""

from __future__ import annotations

from tests.course.test_course_numbers import Recorder
from vecpoly.findings.study.study import study
from vecpoly.problem.load import loads
from vecpoly.report.course.checks.tolerances import section
from vecpoly.solution import solve

SLOT_ABOUT_A = """
id: linkage
title: a slot turns about A and carries a bar along it
frame: {A: [20.6010112 mm, -58.7156209 mm], B: [20.6716391 mm, 97.8538702 mm]}
links:
  1: {slot: A}
  2: {BC: 29.0603188 mm, D: {along: BC, at: 75.5021856 mm}}
  3: {CA: 130.050939 mm, E: {along: CA, at: 14.8874254 mm}}
joints: []
input: {link: 1, phi: 65.0768733 deg, omega: 40 r/min cw, alpha: 5 rad/s^2}
branch: [C left of B]
find: [omega_2, alpha_2, omega_3, alpha_3]
"""


def test_a_rate_that_is_zero_all_along_has_no_share_of_its_greatest_value() -> None:
    press = Recorder()
    section(study(solve(loads(SLOT_ABOUT_A), repeats=0)), press)
    cells = [cell for row in press.lines for cell in row[2:]]
    assert "—" in cells and any(cell.endswith(" mm") for cell in cells)
