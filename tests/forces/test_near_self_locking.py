"""Near self-locking two sets of senses may each agree with themselves: the mechanism moves by those that a smaller
friction leads to."""

from __future__ import annotations

import numpy as np
import pytest

from tests.forces.test_pins_in_slots import agreeing, exact_hand
from tests.generators.acting.locking import times
from tests.laws import few
from vecpoly import loads
from vecpoly.cycle import cycle
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


@pytest.mark.parametrize("factor", few([1.0, 4.0, 7.0, 9.9], 3))
def test_as_friction_grows_the_balancing_load_on_trial_is_found(factor: float) -> None:
    assert agreeing(exact_hand(times(COUPLER, factor) + "find: [X, R_12, R_23, R_34, R_14]\n")) == 5


def test_driven_by_that_load_the_crank_is_locked() -> None:
    with pytest.raises(LockedError):
        exact_hand(SHORT_ARM.replace("omega: -12", "omega: 12"))


# What the load and the couples leave for link 5 turns as X_b grows: the resultant of link 2 all but touches G's circle.
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


# The resultant of the plate passes through the circle at G at first, and moments must solve the group; with the couples
# that moments leave it would pass beside it, where lines of action need no couples: they took turns for ever.
TAKING_TURNS = """
id: x
title: lines of action and moments by turns
frame: {A: [0 mm, 0 mm], F: [151.685 mm, -3.44 mm], G: [92.712 mm, 62.807 mm]}
links:
  1: {AB: 48.954 mm, J: {along: AB, at: 89.133 mm, left: 123.095 mm}}
  2: {CD: 37.633 mm, E: {along: CD, at: -18.236 mm, left: 63.562 mm}, H: {along: CD, at: 39.217 mm, left: 104.675 mm},
      I: {along: CD, at: -54.458 mm, left: -54.894 mm}, K: {along: CD, at: -125.604 mm, left: -45.961 mm},
      L: {along: CD, at: 40.945 mm, left: 116.597 mm}}
  3: {FE: 117.379 mm}
  4: {block: G}
  5: {block: J}
joints: ["4 slides on HI with G 17.337 mm left", "5 slides on KL"]
input: {link: 1, phi: 17 deg, omega: 10 rad/s}
guesses: {C: [49.9 mm, 76.3 mm], D: [56.8 mm, 39.3 mm], E: [109 mm, 105.9 mm], H: [160 mm, 57 mm],
          I: [-14.1 mm, 119.7 mm], K: [-18.4 mm, 191.3 mm], L: [172 mm, 57.5 mm]}
loads:
  F_q0: {on: 2, at: H, size: 512 N, direction: -28 deg}
  M_q1: {on: 2, size: -22 N*m}
  X_b: {on: 5, at: J, direction: -138 deg, size: "?"}
friction: {G: {rho: 1 mm}, E: {rho: 1.67 mm}}
find: [X_b, X_b_0, R_23, R_24, R_25, R_15]
"""


def test_a_group_that_moments_had_to_solve_stays_with_them() -> None:
    assert agreeing(exact_hand(TAKING_TURNS)) == 6


# Where the force of link 3 dies away as the friction grows, a second equilibrium agrees with itself: F on link 4 is
# 7.4 N there, and 8.2 N in the one that grew from none.
ANOTHER_EQUILIBRIUM = """
id: x
title: two equilibria with all of the friction
frame: {A: [0 mm, 0 mm], E: [121.814751966 mm, 186.934687994 mm], K: [66.983769373 mm, 96.669426925 mm]}
links:
  1: {AB: 30.969535280 mm, G: {along: AB, at: 267.872719130 mm, left: 37.838531488 mm}}
  2: {CD: 38.557980413 mm, F: {along: CD, at: -40.169667780 mm, left: -100.714984755 mm},
      H: {along: CD, at: 32.091560649 mm, left: -8.636058725 mm},
      I: {along: CD, at: -133.501665309 mm, left: 8.200332578 mm},
      J: {along: CD, at: -58.775201701 mm, left: 0.235810025 mm}}
  3: {slot: E}
  4: {KJ: 143.520498884 mm}
joints: ["F of 2 slides in 3 turned 101.048226607 deg", "G runs in HI of 2"]
input: {link: 1, phi: 52 deg, omega: 10 rad/s}
guesses: {C: [138.8 mm, 164.7 mm], D: [141.8 mm, 126.3 mm], F: [35.3 mm, 196.9 mm], H: [132.7 mm, 132 mm],
          I: [136.6 mm, 298.4 mm], J: [134.5 mm, 223.3 mm]}
loads:
  F_q0: {on: 4, at: J, size: 73 N, direction: 2 deg}
  F_q1: {on: 1, at: A, size: 421 N, direction: -115 deg}
  X_b: {on: 1, size: "?"}
friction: {A: {rho: 14.87034 mm}, E: {rho: 14.2238 mm}, K: {rho: 16.16341 mm}, J: {rho: 10.99112 mm}}
find: [X_b, X_b_0, R_54, R_24]
"""


def test_of_two_equilibria_that_is_drawn_which_grew_from_none() -> None:
    solution = exact_hand(ANOTHER_EQUILIBRIUM)
    assert agreeing(solution) == 4
    assert abs(solution.answers["R_54"].drawn) == pytest.approx(8.2068, rel=1e-4)


# A couple on a block between two inclined guides presses neither: what is left of the normal forces is rounding, and
# friction that multiplied it would bind or not as the rounding falls out.
COUPLE_ON_A_BLOCK = """
id: x
title: a couple on a block between two guides
frame: {A: [0 mm, 0 mm], E: [68.734025370 mm, 110.236747490 mm]}
links:
  1: {AB: 56.572725225 mm, I: {along: AB, at: -31.673444996 mm, left: -6.189081511 mm},
      J: {along: AB, at: -92.162958278 mm, left: -109.827967953 mm},
      M: {along: AB, at: -184.899107851 mm, left: -87.052334109 mm}}
  2: {CD: 40.265778367 mm, F: {along: CD, at: -58.251139362 mm, left: 73.728582466 mm},
      G: {along: CD, at: 114.090304152 mm, left: 2.743965570 mm},
      K: {along: CD, at: 15.588451172 mm, left: -10.149093643 mm},
      L: {along: CD, at: -78.630675211 mm, left: 64.166155289 mm},
      N: {along: CD, at: -37.090127818 mm, left: -35.682702069 mm},
      O: {along: CD, at: 7.469882666 mm, left: -161.890190768 mm}}
  3: {block: E}
  4: {block: H}
joints: ["3 slides on FG with E 11.2471 mm left", "4 slides on IJ", "4 slides on KL of 2 turned -177.777577000 deg",
         "M runs in NO of 2"]
input: {link: 1, phi: 164.0 deg, omega: 3 rad/s, alpha: -20 rad/s^2}
guesses: {C: [107.685 mm, 64.919 mm], D: [114.835 mm, 104.545 mm], F: [24.785 mm, 20.685 mm],
          G: [125.244 mm, 177.683 mm], K: [120.441 mm, 78.457 mm], L: [30.577 mm, -1.069 mm],
          N: [136.215 mm, 22.082 mm], O: [268.329 mm, 43.524 mm], H: [75.509 mm, 38.694 mm]}
loads: {M_q0: {on: 4, size: 6 N*m}, F_q1: {on: 2, at: D, size: 173 N, direction: 162 deg}, X_b: {on: 1, size: "?"}}
friction: {A: {rho: 0.60 mm}, E: {rho: 0.59 mm}, 4-1: {phi: 5 deg}, 4-2: {phi: 9 deg}}
"""


def test_what_presses_only_by_rounding_has_no_friction_and_locks_nowhere() -> None:
    balancing = cycle(loads(COUPLE_ON_A_BLOCK), 37).real("X_b")
    assert np.isfinite(balancing).all()
    assert balancing[-1] == pytest.approx(balancing[0], rel=1e-9)


BARE_LEG = """
id: x
title: a leg that bears a couple alone, its slides rub
frame: {A: [0 mm, 0 mm], I: [111 mm, 204 mm], M: [266 mm, 29 mm]}
links:
  1: {AB: 31 mm, F: {along: AB, at: 114 mm, left: -51 mm}, G: {along: AB, at: 230 mm, left: 30 mm}}
  2: {CD: 16 mm, E: {along: CD, at: -96 mm, left: -32 mm}, J: {along: CD, at: -88 mm, left: 55 mm},
      K: {along: CD, at: -10 mm, left: -37 mm}, L: {along: CD, at: 41 mm, left: -66 mm}}
  3: {block: E}
  4: {block: H}
  5: {ML: 114 mm}
joints: [3 slides on FG, 4 slides on line through I at -76 deg, 4 slides on JK of 2 turned 11 deg]
input: {link: 1, phi: 75 deg, omega: 3 rad/s}
guesses: {C: [159 mm, 109 mm], D: [172 mm, 99 mm], E: [63 mm, 141 mm], J: [122 mm, 205 mm],
          K: [128 mm, 85 mm], L: [152 mm, 32 mm], H: [125 mm, 145 mm]}
loads:
  F_q0: {on: 3, at: E, size: 41 N, direction: -142 deg}
  M_q1: {on: 3, size: 19 N*m}
  F_q2: {on: 1, at: G, size: 628 N, direction: 41 deg}
  X_b: {on: 1, size: "?"}
friction: {A: {rho: 0.42 mm}, M: {rho: 0.37 mm}, L: {rho: 0.47 mm}, 4-6: {phi: %d deg}, 4-2: {phi: %d deg}}
"""


@pytest.mark.parametrize("angles", few([(4, 4), (5, 6), (6, 12), (10, 8)], 2))
def test_slides_that_bear_nothing_do_not_make_the_mechanism_locked(angles: tuple[int, int]) -> None:
    """The two slides of link 4 press with no force in equilibrium, but on trial they do, on one side or the other."""
    solution = exact_hand(BARE_LEG % angles)
    assert solution.answers["R_24"].exact == pytest.approx(0.0, abs=1e-9)
    assert agreeing(solution) == 10


PAST_A_POLE = """
id: x
title: a slot, a bar and a rod with circles larger than any bearing
frame: {A: [0 mm, 0 mm], G: [181 mm, 78 mm], J: [-3 mm, 178 mm]}
links:
  1: {AB: 47 mm, E: {along: AB, at: -59 mm, left: -125 mm}}
  2: {CD: 17 mm, F: {along: CD, at: -136 mm, left: -94 mm}, H: {along: CD, at: 2 mm, left: -7 mm},
      I: {along: CD, at: -46 mm, left: -49 mm}}
  3: {slot: E}
  4: {slot: G}
  5: {JI: 103 mm}
joints: [F of 2 slides in 3 with F 8 mm right turned 133 deg, H of 2 slides in 4 turned 76 deg]
input: {link: 1, phi: 164 deg, omega: 8 rad/s cw}
guesses: {C: [111 mm, 54 mm], D: [113 mm, 37 mm], F: [4 mm, 180 mm], H: [105 mm, 51 mm], I: [58 mm, 95 mm]}
loads:
  F_q0: {on: 2, at: F, size: 766 N, direction: -156 deg}
  X_b: {on: 2, at: I, direction: 50 deg, size: "?"}
friction: {G: {rho: 71 mm}, J: {rho: 51 mm}, E: {rho: 39 mm}}
"""


def test_an_equilibrium_is_followed_past_friction_at_which_a_held_load_could_not_be_balanced() -> None:
    """At 58 % of it no size on trial changes what link 5 is short of: det(1 − G) is ∞ there, and passes no 0."""
    solution = exact_hand(PAST_A_POLE)
    assert agreeing(solution) == 10
    assert solution.answers["X_b"].exact == pytest.approx(878.85, rel=1e-4)
