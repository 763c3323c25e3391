"""Near self-locking two sets of senses may each agree with themselves: the mechanism moves by those that a smaller
friction leads to."""

from __future__ import annotations

import pytest

from tests.forces.test_pins_in_slots import agreeing, exact_hand
from tests.generators.acting.locking import times
from vecpoly.errors import LockedError

# The force on the crank has the arm 0.741 mm about A, less than the friction circle's radius: by the one side of the
# circle X = M / (h + ρ), by the other X = −M / (ρ − h), which would have to help.
SHORT_ARM = """
id: x
title: a force with a short arm
frame: {A: [0 mm, 0 mm], D: [0 mm, 20 mm]}
links: {1: {AB: 42.1 mm}, 2: {BC: 60 mm}, 3: {DC: 50 mm}}
branch: [C right of BD]
input: {link: 1, phi: -118 deg, omega: -12 rad/s}
loads: {M: {on: 1, size: -8 N*m}, X: {on: 1, at: B, size: "?", direction: -117 deg}}
friction: {A: {rho: 1.21 mm}}
"""
COUPLER = """
id: x
title: balanced on the coupler
frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm]}
links: {1: {AB: 60 mm}, 2: {BC: 180 mm}, 3: {DC: 120 mm}}
input: {link: 1, phi: 70 deg, omega: 8 rad/s ccw}
branch: [C above AD]
loads:
  M_1: {on: 1, size: 20 N*m}
  M_3: {on: 3, size: -12 N*m}
  X: {on: 2, size: "?"}
friction:
  A: {rho: 2 mm}
  B: {rho: 3 mm}
  C: {rho: 2.5 mm}
  D: {rho: 2 mm}
"""


def test_a_load_whose_arm_is_shorter_than_the_friction_circle_is_moved() -> None:
    answers = exact_hand(SHORT_ARM + "find: [X, X_0]\n").answers
    assert answers["X_0"].drawn == pytest.approx(8000 / 0.73474, rel=1e-4)  # h = 42.1 mm · sin 1°
    assert answers["X"].drawn == pytest.approx(8000 / (0.73474 + 1.21), rel=1e-4)


@pytest.mark.parametrize("factor", [1.0, 4.0, 7.0, 9.9])
def test_as_friction_grows_the_balancing_load_on_trial_is_found(factor: float) -> None:
    assert agreeing(exact_hand(times(COUPLER, factor) + "find: [X, R_12, R_23, R_34, R_14]\n")) == 5


def test_driven_by_that_load_the_crank_is_locked() -> None:
    with pytest.raises(LockedError):
        exact_hand(SHORT_ARM.replace("omega: -12", "omega: 12"))
