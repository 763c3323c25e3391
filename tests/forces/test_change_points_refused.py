"""A parallelogram in one line is at its change point: no reaction has a value there, and what is refused says so."""

from __future__ import annotations

import math

import pytest

import vecpoly
from vecpoly.errors import VecpolyError
from vecpoly.oracle.forces import forces

FLAT = """
id: t
title: t
frame: {{A: [0 mm, 0 mm], D: [100 mm, 0 mm]}}
links: {{1: {{AB: 40 mm}}, 2: {{BC: 100 mm}}, 3: {{DC: 40 mm}}}}
input: {{link: 1, phi: {phi} deg, omega: 10 rad/s ccw}}
branch: [ABCD parallelogram]
loads: {{{load}, M_1: {{on: 1, size: "?"}}}}
{friction}find: [M_1]
"""
LOADS = (
    "M_3: {on: 3, size: 5 N*m cw}",
    "F_3: {on: 3, at: C, size: 5 N, direction: 90 deg}",
    "F_2: {on: 2, at: B, size: 5 N, direction: 90 deg}",
)
RUBBED = "friction: {A: {rho: 3 mm}, C: {rho: 3 mm}}\n"


@pytest.mark.parametrize("phi", [0, 180, -180])
@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("friction", ["", RUBBED])
def test_a_flat_parallelogram_under_loads_is_sent_to_another_position(phi: int, load: str, friction: str) -> None:
    with pytest.raises(VecpolyError) as refused:
        vecpoly.solve(vecpoly.loads(FLAT.format(phi=phi, load=load, friction=friction)))
    assert "position" in str(refused.value) and "locked" not in str(refused.value)
    assert "位置" in refused.value.words.zh and "自锁" not in refused.value.words.zh


@pytest.mark.parametrize("load", LOADS[:2])
def test_a_tenth_of_a_degree_beside_it_the_reactions_have_their_values(load: str) -> None:
    problem = vecpoly.loads(FLAT.format(phi=179.9, load=load, friction=""))
    assert problem.loads is not None
    found = forces(problem.mechanism, problem.loads).value("M_1")
    pull = 5.0 if load.startswith("M") else -5 * 0.04 * math.cos(math.radians(179.9))
    assert found.real == pytest.approx(pull, rel=1e-6)
