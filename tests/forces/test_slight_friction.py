"""Friction that takes less than can be read off is no self-locking."""

from __future__ import annotations

import pytest

from tests.laws import few
from vecpoly import Problem, loads, solve
from vecpoly.errors import LockedError

SLIGHT = """
id: slight
title: {zh: 摩擦很小的曲柄滑块机构, en: A slider-crank with slight friction}
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 200 mm}, 3: {block: C}}
joints: [3 slides on y = 0 mm]
input: {link: 1, phi: PHI, omega: 10 rad/s cw}
branch: [C right of B]
loads: {Q: {on: 3, at: C, size: 500 N, direction: 180 deg, role: resisting}, M_1: {on: 1, size: "?", role: driving}}
friction: {C: {rho: RHO}}
find: [M_1, eta]
"""


def slight(phi: int, rho: str = "0.2 mm") -> Problem:
    return loads(SLIGHT.replace("PHI", f"{phi} deg").replace("RHO", rho))


@pytest.mark.parametrize("phi", few([31, 97, 153], 3))
def test_an_efficiency_that_is_read_above_one_by_the_error_of_drawing_is_an_answer(phi: int) -> None:
    exact, drawn = (solve(slight(phi), by=by) for by in ("exact", "drafting"))
    assert not exact.suspect and not drawn.suspect
    assert 0.9 < exact.answers["eta"].drawn <= 1.0
    eta = drawn.answers["eta"]
    assert abs(eta.drawn - eta.exact) <= eta.expected_error
    said = [step.words.en for step in drawn.construction.steps if "above 1 by the error of drawing" in step.words.en]
    assert len(said) == (eta.drawn > 1.0)


def test_one_of_them_is_read_above_one() -> None:
    tried = sorted(range(31, 160, 2), key=lambda phi: abs(phi - 91))  # one of the first is it
    assert any(solve(slight(phi)).answers["eta"].drawn > 1.0 for phi in tried)


@pytest.mark.parametrize("by", ["exact", "drafting"])
def test_what_friction_locks_is_refused_by_every_hand(by: str) -> None:
    text = SLIGHT.replace("PHI", "178 deg").replace("RHO", "40 mm").replace("role: resisting", "role: driving")
    locked = text.replace("10 rad/s cw", "10 rad/s ccw").replace(
        'size: "?", role: driving', 'size: "?", role: resisting'
    )
    with pytest.raises(LockedError):
        solve(loads(locked), by=by)
