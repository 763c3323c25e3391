"""Friction is raised as a whole: f of slides and ρ of pins in step, and past a reaction that changes sides."""

from __future__ import annotations

import pytest

from tests.forces.test_pins_in_slots import agreeing, exact_hand
from tests.laws import few
from vecpoly.errors import LockedError

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


@pytest.mark.parametrize("angles", few([(47.25, 60.08), (30, 60.08), (40, 55)], 2))
def test_where_steep_slides_help_they_are_raised_in_step_with_the_pins(angles: tuple[float, float]) -> None:
    """With the first two det(1 − G) leaps from 0.10 to −0.85 where R_32 changes sides; nothing else does."""
    solution = exact_hand(STEEP_SLIDES % angles)
    assert agreeing(solution) == 6
    assert solution.answers["X_b"].drawn / solution.answers["X_b_0"].drawn == pytest.approx(0.86, abs=0.02)


def test_where_the_same_slides_help_less_it_is_locked() -> None:
    with pytest.raises(LockedError, match="friction"):
        exact_hand(STEEP_SLIDES % (47.25, 30))
