"""A swinging block with numbers that differ from student to student."""

from __future__ import annotations

from functools import cache

import vecpoly
from vecpoly.problem.problem import Problem
from vecpoly.variants.draw import Variant, variants
from vecpoly.variants.pilot import Pilot, pilot
from vecpoly.variants.seeds import Seed

TEXT = """\
id: block
title: {zh: 摇块机构, en: A swinging block}
extends: 3-9
scales: null
printed: null
errata: null
find: [v_C2B, v_C2C3, omega_3, v_E, at_C2B, alpha_3, a_E]
vary:
  AB: 24 mm .. 40 mm by 2 mm
  x_C: -120 mm .. -80 mm by 5 mm
  phi: 0 deg .. 355 deg by 5 deg
  omega: 8 rad/s cw .. 12 rad/s cw by 0.5 rad/s
"""


@cache
def block(gate: str = "") -> Problem:
    return vecpoly.loads(TEXT + (f"gate: {{{gate}}}\n" if gate else ""))


def seed(student: str) -> Seed:
    return Seed(assignment="homework", problem="block", student=student)


@cache
def piloted() -> Pilot:
    return pilot(block())


@cache
def given(student: str) -> Variant:
    return next(variants(block(), seed(student), piloted().standard))
