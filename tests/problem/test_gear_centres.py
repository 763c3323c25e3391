"""The centre of mass of a gear is told as any of its points is."""

from __future__ import annotations

from cmath import rect
from math import radians

import pytest

from vecpoly.problem.load import loads

TEXT = """
id: gears
title: gears
frame: {A: [0 mm, 0 mm], D: [105 mm, 0 mm]}
links: {1: {gear: A, radius: 70 mm}, 2: {gear: D, radius: 35 mm}}
joints: [2 rolls on 1 at H]
input: {link: 1, phi: 0 deg, omega: 10 rad/s ccw}
masses: {2: {mass: 1.2 kg, inertia: 0.001 kg*m^2, centre: {CENTRE}}}
weight: yes
loads: {M_1: {on: 1, size: "?"}}
find: [M_1]
"""


@pytest.mark.parametrize("length", ["DS2", "S2D"])
def test_by_a_length_and_an_angle(length: str) -> None:
    mech = loads(TEXT.replace("CENTRE", f"{length}: 8 mm, angle: 190 deg")).mechanism
    (mass,) = loads(TEXT.replace("CENTRE", f"{length}: 8 mm, angle: 190 deg")).loads.masses  # type: ignore[union-attr]
    assert mech.link("2").points[mass.centre] == pytest.approx(rect(0.008, radians(190)))
