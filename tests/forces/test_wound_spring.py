"""A torsion spring that is wound by more than half a turn is refused where it would leap, with the same spring told
otherwise."""

from __future__ import annotations

import re

import numpy as np
import pytest

from vecpoly import loads, solve
from vecpoly.errors import EquilibriumError

SWINGING = """
id: wound
title: {zh: 扭簧, en: A torsion spring on a rocker}
frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm]}
links: {1: {AB: 60 mm}, 2: {BC: 180 mm}, 3: {DC: 120 mm}}
input: {link: 1, phi: 20 deg, omega: 10 rad/s cw}
branch: [C left of BD]
loads: {M_s: {spring: 3-4, k: 10 N*m/rad, SPRING}, M_1: {on: 1, size: "?"}}
find: [M_s, M_1]
"""


def told(spring: str) -> str:
    return SWINGING.replace("SPRING", spring)


def test_a_spring_that_would_leap_is_refused_with_the_same_spring_told_otherwise() -> None:
    with pytest.raises(EquilibriumError, match="passes 180°") as refusal:
        loads(told("phi_0: -60 deg")).cycle(n=181).column("M_s")
    same = re.search(r"write (phi_0: \S+ deg, preload: \S+ N\*m)", refusal.value.words.en)
    assert same is not None and refusal.value.code == "wound"
    moments = np.array(loads(told(same[1])).cycle(n=181).column("M_s"))
    assert np.abs(np.diff(moments)).max() < 1.0 and np.ptp(moments) > 5.0
    here = [solve(loads(told(spring)), precise=False).answers["M_1"].exact for spring in ("phi_0: -60 deg", same[1])]
    assert here[0] == pytest.approx(here[1], rel=1e-5)


def test_a_spring_within_half_a_turn_is_as_it_was() -> None:
    moments = np.array(loads(told("phi_0: 60 deg")).cycle(n=181).column("M_s"))
    assert np.abs(np.diff(moments)).max() < 1.0
