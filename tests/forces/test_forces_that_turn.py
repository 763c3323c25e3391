"""Claims about a force whose direction is a ray of the driving link: an inertia force at constant speed."""

from __future__ import annotations

from dataclasses import replace
from math import radians

import numpy as np
import pytest

from tests.at_once import exactly
from tests.lawful import slider
from vecpoly import load
from vecpoly.cycle import cycle
from vecpoly.cycle.pose import posed
from vecpoly.errors import ProblemFileError

TABLE = "{columns: [phi (deg), F (N)], rows: [[0, 9], [360, 9]]}"
TURNING = "F: {on: 1, at: B, size: 90 N, direction: along AB}"


def test_the_inertia_force_of_a_cam_at_constant_speed_needs_no_moment_anywhere() -> None:
    problem = load("4-5")
    assert problem.loads is not None
    q, f = problem.loads.forces
    assert (q.direction, f.direction) == pytest.approx((radians(-83.0), radians(33.0)))
    turn = cycle(problem.mechanism, 36, problem.loads)
    without = cycle(problem.mechanism, 36, replace(problem.loads, forces=(q,)))
    assert turn.column("M_1") == pytest.approx(without.column("M_1"), rel=1e-9, nan_ok=True)
    pressed = turn.column("R_31") - without.column("R_31")
    moves = np.isfinite(pressed)
    assert moves.all()  # M_1 is called driving: where the loads drive too, it helps them over the friction
    assert pressed[moves] == pytest.approx(-140.0 * np.exp(1j * turn.phi[moves]), rel=1e-9)


def test_a_force_that_turns_is_drawn_as_it_is_reckoned_at_other_positions_too() -> None:
    own = slider(TURNING, "Q: {on: 3, at: C, size: 70 N, direction: 0 deg}", find="M_1, R_41")
    for problem in posed(own, np.radians([50.0, 130.0, 290.0])):
        assert problem is not None and problem.loads is not None
        assert problem.loads.forces[0].direction == pytest.approx(problem.mechanism.drive.position)
        for answer in exactly(problem).answers.values():
            assert answer.drawn == pytest.approx(answer.exact, rel=1e-9)


@pytest.mark.parametrize(
    ("entry", "zh", "en"),
    [
        (TURNING.replace("along AB", "along AX"), "点“X”不在构件 1 上", "point 'X' is not on link 1"),
        (TURNING.replace("along AB", "along AA"), "没有方向", "is no direction"),
        ("F: {on: 2, at: B, size: 90 N, direction: along BC}", "只有转动原动件上的力", "only a force on a"),
        (TURNING.replace("90 N", TABLE), "不能由表给出", "of a table"),
    ],
)
def test_a_force_that_cannot_turn_is_refused_with_the_reason(entry: str, zh: str, en: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        slider(entry)
    (fault,) = refused.value.faults
    assert zh in fault.words.zh and en in fault.words.en


def test_a_direction_along_a_ray_is_written_in_either_language_and_told_in_both() -> None:
    chinese = slider(TURNING.replace("along AB", "沿 AB"))
    assert slider(TURNING).loads == chinese.loads
    told = next(datum.words for datum in chinese.given.loads if datum.symbol == "F")
    assert told is not None
    assert "方向由 $A$ 指向 $B$，随构件 1 转动" in told.zh
    assert "directed from $A$ to $B$, turning with link 1" in told.en
