"""A machine that runs at one speed on the average, and stands in the given position at another."""

from __future__ import annotations

import pytest

from tests.machine.engines import PRESS, machine
from vecpoly.check.paced import paced

SPEEDS = [
    ("120 r/min ccw", False),
    ("122 r/min cw", False),
    ("12.57 rad/s", False),
    ("130 r/min ccw", True),
    ("ccw", False),
]


@pytest.mark.parametrize(("omega", "told"), SPEEDS)
def test_a_speed_that_the_machine_never_has_is_told(omega: str, told: bool) -> None:
    text = PRESS.replace("omega: 120 r/min ccw", f"omega: {omega}")
    found = paced(machine(text, ("J_F",), "n: 120 r/min, delta: 0.05"))
    assert bool(found) == told
    if told:
        assert "runs at 130 r/min" in found[0].en and "at 120 r/min on the average" in found[0].en


def test_a_machine_let_go_from_a_state_has_no_mean_speed() -> None:
    run = "start: {phi: 0 deg, omega: 5 rad/s}, until: 90 deg"
    assert paced(machine(PRESS.replace("M_d: {on: 1, size: constant, role: driving}", ""), ("t_end",), run)) == ()
