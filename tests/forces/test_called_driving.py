"""Near a dead point a crank called driving helps the load over the friction; one that is not so called is locked."""

from __future__ import annotations

import numpy as np
import pytest

from tests.generators.equilibrium import in_equilibrium
from tests.laws import few
from vecpoly import loads, solve
from vecpoly.errors import LockedError
from vecpoly.oracle.forces import forces

TEXT = """
id: dead-point
title: dead point
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 150 mm}, 3: {block: C}}
joints: [3 slides on y = 0 mm]
input: {link: 1, phi: PHI deg, omega: 10 rad/s ccw}
branch: [C right of A]
loads:
  F: {on: 3, at: C, size: 400 N, direction: 0 deg}
  M_1: {on: 1, size: "?"ROLE}
friction: {3-4: {f: 0.1}, C: {rho: 4 mm}, A: {rho: 2 mm}, B: {rho: 3 mm}}
find: [M_1, M_1_0, R_12, R_41]
"""


def text(phi: float, role: str = ", role: driving") -> str:
    return TEXT.replace("PHI", str(phi)).replace("ROLE", role)


@pytest.mark.parametrize("phi", few([355.0, 357.5, 359.5], 3))
def test_a_crank_that_is_called_driving_helps(phi: float) -> None:
    found = solve(loads(text(phi)), by="exact")
    moment, ideal = found.answers["M_1"], found.answers["M_1_0"]
    assert moment.exact > 0 > ideal.exact  # it helps only against the friction
    assert in_equilibrium(found) == ""
    assert abs(moment.drawn - moment.exact) <= moment.expected_error


def test_one_that_is_not_called_so_is_locked() -> None:
    with pytest.raises(LockedError, match="let M_1 drive"):
        solve(loads(text(359.5, "")))


def test_over_the_cycle_no_place_is_left_out() -> None:
    problem = loads(text(355.0))
    assert problem.loads is not None
    found = forces(problem.mechanism, problem.loads, np.radians(np.arange(345.5, 360.0, 0.5)), strict=False)
    moments = found.value("M_1").real
    assert np.isfinite(moments).all() and (np.diff(moments) > 0).all()
