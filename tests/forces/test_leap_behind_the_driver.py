"""A leap to another equilibrium shows in the group that leapt, however much larger the reactions of the driver are."""

from __future__ import annotations

import numpy as np
import pytest

from tests.forces.test_pins_in_slots import agreeing, exact_hand
from tests.generators.acting.locking import times
from tests.laws import few
from vecpoly import loads
from vecpoly.oracle.forces import forces

# R_51 is ten times R_12: at about a third of this friction block 3 comes to press on the other side of its guide, and
# beside it there is another equilibrium, which no longer moves at 97 %. The drawing was led there, and locked; the
# analytic solution went the one way or the other, with the friction of the file as it happened to be.
BEHIND_THE_DRIVER = """
id: x
title: a block that comes to press on the other side of its guide
frame: {A: [0 mm, 0 mm], D: [76.46 mm, 119.93 mm], F: [90.94 mm, 139.81 mm]}
links:
  3: {block: C}
  1: {AB: 88.6319 mm}
  4: {CG: 121.93 mm}
  2: {BC: 99.6679 mm}
joints: [3 slides on line through D at -6 deg, G runs in line through F at 49 deg]
branch: [C right of BD, G right of CF]
input: {link: 1, phi: 29.0356 deg, omega: 9 rad/s}
loads:
  M_q: {on: 2, size: -13 N*m}
  F_q: {on: 4, at: G, size: 379 N, direction: 10 deg}
  X: {on: 1, at: B, size: "?", direction: -152 deg}
find: [X, R_12, R_43, R_53, R_54]
friction:
  A: {rho: 20.67075 mm}
  B: {rho: 10.53413 mm}
  C: {rho: 27.03098 mm}
  3-5: {phi: 70.30298 deg}
  4-5: {phi: 54.26482 deg}
"""


def test_as_friction_grows_the_exact_reactions_grow_without_a_leap() -> None:
    problems = [loads(times(BEHIND_THE_DRIVER, factor)) for factor in np.linspace(0.4, 1.05, 27)]
    found = [forces(one.mechanism, one.loads) for one in problems if one.loads is not None]
    pressed = np.array([complex(one.value("R_12")) for one in found])
    assert np.abs(np.diff(pressed)).max() < 0.1 * np.abs(pressed).max()


@pytest.mark.parametrize("factor", few([0.36, 0.95, 0.98, 1.0, 1.05], 2))
def test_the_drawing_is_led_to_the_same_equilibrium(factor: float) -> None:
    assert agreeing(exact_hand(times(BEHIND_THE_DRIVER, factor))) == 5
