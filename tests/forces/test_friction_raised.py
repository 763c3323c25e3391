"""Friction is raised as a whole: f of slides and ρ of pins in step, and past a reaction that changes sides."""

from __future__ import annotations

import pytest

from tests.forces.test_pins_in_slots import SCALES, agreeing, exact_hand
from tests.laws import few
from vecpoly.errors import LockedError
from vecpoly.problem.load import loads
from vecpoly.solution import solve

# Slides that are steep against the pins help here: with φ = 30° at the one or the other the mechanism moves or is
# locked. Raised by their angles the slides came to lag behind the circles, and it was locked at 74 % of the friction.
STEEP_SLIDES = """
id: x
title: a leap of det(1 − G) where a reaction changes sides
frame: {A: [0 mm, 0 mm], E: [17.6 mm, 126.1 mm], I: [275.7 mm, -21.3 mm]}
links:
  1: {AB: 20.2 mm, K: {along: AB, at: -104.3 mm, left: -40.3 mm}}
  2: {CD: 93.7 mm, F: {along: CD, at: -44.6 mm, left: -210.2 mm}, G: {along: CD, at: 117.2 mm, left: -44.1 mm},
      H: {along: CD, at: -5.5 mm, left: 41.2 mm}, J: {along: CD, at: 94.8 mm, left: 0.5 mm}}
  3: {block: E}
  4: {block: H}
  5: {KJ: 72.6 mm}
joints: [3 slides on FG with E 2.2 mm left, 4 slides on line through I at 154.2 deg]
input: {link: 1, phi: 169 deg, omega: 10 rad/s}
guesses: {C: [120 mm, 75 mm], D: [39 mm, 29 mm], F: [56 mm, 280 mm], G: [-3 mm, 56 mm], H: [145 mm, 42 mm],
          J: [38 mm, 28 mm]}
loads:
  F_q: {on: 5, at: K, size: 568 N, direction: 112 deg}
  X_b: {on: 1, size: "?"}
friction: {A: {rho: 2.35 mm}, E: {rho: 5.32 mm}, K: {rho: 6.55 mm}, 3-2: {phi: %s deg}, 4-6: {phi: %s deg}}
find: [X_b, X_b_0, R_32, R_25, R_64, R_51]
"""


@pytest.mark.parametrize("angles", few([(47.25, 60.08), (30, 60.08), (40, 55)], 3))
def test_where_steep_slides_help_they_are_raised_in_step_with_the_pins(angles: tuple[float, float]) -> None:
    """With the first two of these det(1 − G) leaps from 0.10 to −0.85 where R_32 changes sides; nothing else does."""
    solution = exact_hand(STEEP_SLIDES % angles)
    assert agreeing(solution) == 6
    assert solution.answers["X_b"].drawn / solution.answers["X_b_0"].drawn == pytest.approx(0.86, abs=0.02)


def test_where_the_same_slides_help_less_it_is_locked() -> None:
    with pytest.raises(LockedError, match="friction"):
        exact_hand(STEEP_SLIDES % (47.25, 30))


# With all of its friction at once the lines of action met far off, in another equilibrium than that which grows from
# none: X_b was −34.2 N in place of −19.4 N.
LONG_LEVER = """
id: x
title: two equilibria without a couple that has to be found
frame: {A: [0 mm, 0 mm], D: [-48.42 mm, -78.83 mm]}
links:
  2: {block: C}
  1: {AB: 62.2539 mm}
  3: {BC: 182.6315 mm, E: {along: BC, at: 97 mm, left: -38 mm}}
joints: [2 slides on line through D at -48 deg]
branch: [C right of BD]
input: {link: 1, phi: -1.0429 deg, omega: -12 rad/s, alpha: 30 rad/s^2}
loads:
  F_q0: {on: 3, at: B, size: 303 N, direction: 16 deg}
  X_b: {on: 1, size: "?"}
masses:
  1: {mass: 3.09 kg, inertia: 0.0037 kg*m^2, centre: {along: AB, at: 113 mm}}
  3: {mass: 0.75 kg, inertia: 0.0195 kg*m^2, centre: {along: BC, at: 67 mm}}
weight: no
friction: {A: {rho: 24.48888 mm}, B: {rho: 30.78275 mm}, C: {rho: 6.065003 mm}, 2-4: {phi: 58.12715 deg}}
"""


def test_a_reaction_that_would_leap_is_led_there_by_less_friction() -> None:
    solution = exact_hand(LONG_LEVER)
    assert agreeing(solution) and solution.answers["X_b"].drawn == pytest.approx(-19.353775145761, rel=1e-9)


LOADED_BARS = """
id: x
title: two loaded bars, solved by moments, and so with the couples of their pins
frame: {A: [0 mm, 0 mm], D: [120 mm, 0 mm]}
links: {1: {AB: 40 mm}, 2: {BC: 110 mm, E: {along: BC, at: 50 mm}}, 3: {DC: 80 mm, G: {along: DC, at: 30 mm}}}
input: {link: 1, phi: 60 deg, omega: 10 rad/s}
branch: [C above D]
loads:
  F_p: {on: 2, at: E, size: 300 N, direction: 250 deg}
  F_q: {on: 3, at: G, size: 200 N, direction: 10 deg}
  M_1: {on: 1, size: "?"}
friction: {B: {rho: 4 mm}, C: {rho: 4 mm}, D: {rho: 4 mm}}
find: [M_1, R_12, R_23]
"""


def test_what_all_couples_do_to_each_other_is_found_in_one_pass_as_in_one_pass_for_each() -> None:
    """Beside repeated drawings the couples are moved one by one, else all at once by as many hands."""
    problem = loads(LOADED_BARS + SCALES)
    together, apart = (solve(problem, by="exact", repeats=n, precise=False).answers for n in (0, 2))
    assert [answer.drawn for answer in together.values()] == pytest.approx(
        [answer.drawn for answer in apart.values()], rel=1e-9
    )
