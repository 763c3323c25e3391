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


# What the load and the friction couples leave for link 5 turns round as X_b grows: for a while the resultant of link 2
# all but touches the circle at G, and no tangent from where it meets the line of link 5 is to be relied on.
THROUGH_THE_CIRCLE = """
id: x
title: a resultant through a friction circle
frame: {A: [0 mm, 0 mm], H: [61.786 mm, 95.237 mm], J: [118.636 mm, 157.438 mm]}
links:
  1: {AB: 23.86 mm, F: {along: AB, at: -154.029 mm, left: -83.88 mm}}
  2: {CD: 84.534 mm, E: {along: CD, at: 69.055 mm, left: -54.054 mm},
      G: {along: CD, at: -2.812 mm, left: -82.807 mm}, I: {along: CD, at: 20.965 mm, left: -46.377 mm}}
  3: {FE: 56.465 mm}
  4: {HG: 59.969 mm}
  5: {JI: 60.468 mm}
input: {link: 1, phi: 186 deg, omega: -8 rad/s}
guesses: {C: [77.692 mm, 191.687 mm], D: [137.387 mm, 131.833 mm], E: [88.183 mm, 104.622 mm],
          G: [17.074 mm, 135.202 mm], I: [59.659 mm, 144.093 mm]}
loads:
  F_q0: {on: 3, at: E, size: 284 N, direction: -69 deg}
  F_q1: {on: 2, at: I, size: 290 N, direction: 42 deg}
  F_q2: {on: 2, at: G, size: 680 N, direction: -179 deg}
  X_b: {on: 1, size: "?"}
friction: {A: {rho: 9.56 mm}, F: {rho: 11.53 mm}, E: {rho: 2.8 mm}, G: {rho: 1.53 mm}}
find: [X_b, X_b_0, R_13, R_23, R_42, R_52]
"""


def test_a_resultant_that_passes_through_a_friction_circle_on_trial_is_no_lock() -> None:
    solution = exact_hand(THROUGH_THE_CIRCLE)
    assert agreeing(solution) == 6
    assert solution.answers["X_b"].drawn / solution.answers["X_b_0"].drawn > 50
