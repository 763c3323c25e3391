"""Flywheels where J_e or M bends sharply: near a change point, at the corners of a card, where loads begin to act."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vecpoly
from tests.at_once import exactly
from tests.laws import few, often
from vecpoly.solution import Solution, solve

ROCKER = """
id: x
title: near a change point
frame: {{A: [0 mm, 0 mm], D: [{base:.4f} mm, 0 mm]}}
links: {{1: {{AB: 77 mm}}, 2: {{BC: 213 mm}}, 3: {{CD: 269 mm}}}}
input: {{link: 1, phi: 151 deg, omega: 120 r/min ccw}}
branch: [C left of BD]
loads:
  M_q: {{on: 3, size: 306 N*m cw, during: [{first} deg, {last} deg]}}
  M_c: {{on: 1, size: constant}}
masses:
  2: {{mass: 7 kg, inertia: 0.017 kg*m^2, centre: {{along: BC, at: 106 mm}}}}
  3: {{mass: 5 kg, inertia: 0.051 kg*m^2, centre: {{along: DC, at: 134 mm}}}}
machine: {{n: 145 r/min, delta: 0.0669}}
find: [M_c, dW_max, J_F, J_F_areas]
"""
PISTON = """
id: x
title: a piston with a card
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 60 mm}, 2: {BC: 210 mm}, 3: {block: C}}
joints: [3 slides on y = 0 mm]
input: {link: 1, phi: 50 deg, omega: 100 r/min ccw}
branch: [C right of B]
loads:
  F: {on: 3, at: C, direction: 180 deg, LAW}
  M_d: {on: 1, size: constant}
masses: {3: {mass: 5 kg}}
machine: {n: 100 r/min, delta: 0.05}
find: [M_d, dW_max, J_F, J_F_areas, phi_max, phi_min]
"""
CARD = "size: {columns: [s (mm), F (N)], rows: [[0, 100], [40, 900], [80, 300], [121, 200]%s]}"
LAWS = {
    "a spring": CARD % "",
    "a card with two branches": CARD % ", [80, 100], [30, 50], [0, 100]",
    "part of a stroke": "size: 300 N, while: C moves left, between: [20 %, 70 %]",
}


def _agree(solution: Solution) -> None:
    for key, one in solution.answers.items():
        unit = one.reading.unit
        size = max(abs(two.exact) for two in solution.answers.values() if two.reading.unit == unit)
        miss = abs(one.deviation)
        assert min(miss, abs(360 - miss) if unit == "deg" else np.inf) <= 1e-9 * max(size, 1.0), key


@settings(max_examples=often(1), deadline=None)
@given(slack=st.floats(0.05, 20), first=st.integers(0, 359), long=st.integers(20, 200))
def test_near_a_change_point_drawing_and_oracle_have_the_same_flywheel(slack: float, first: int, long: int) -> None:
    text = ROCKER.format(base=269 + 77 - 213 + slack, first=first, last=(first + long) % 360)
    _agree(exactly(vecpoly.loads(text)))


@pytest.mark.parametrize("law", few(tuple(LAWS), 3))
def test_the_corners_of_a_table_over_the_stroke_are_found_on_paper(law: str) -> None:
    _agree(exactly(vecpoly.loads(PISTON.replace("LAW", LAWS[law]))))


def test_a_machine_that_is_slowest_at_0_degrees_has_lost_no_digits() -> None:
    found = solve(vecpoly.loads(PISTON.replace("LAW", LAWS["a spring"])), by="exact", repeats=0, precise=False)
    assert min(found.answers["phi_min"].exact, 360 - found.answers["phi_min"].exact) < 1e-6
    assert found.answers["phi_min"].digits > 7 and found.answers["phi_min"].suspect is None


# C above D holds in the given position alone: this is a drag link, and DC goes all the way round.
DRAG_LINK = """
id: x
title: a drag link
frame: {A: [0 mm, 0 mm], D: [40 mm, 0 mm]}
links: {1: {AB: 90 mm}, 2: {BC: 80 mm}, 3: {DC: 85 mm}}
branch: [C right of D]
input: {link: 1, phi: 60 deg, omega: 100 r/min ccw}
loads: {M_q: {on: 3, size: 30 N*m cw, during: [30 deg, 150 deg]}, M_c: {on: 1, size: constant}}
masses: {3: {mass: 5 kg, inertia: 0.01 kg*m^2, centre: C}}
weight: yes
machine: {n: 100 r/min, delta: 0.05}
find: [M_c, dW_max, J_F, phi_max]
"""
TOLD_GEAR = """
id: x
title: a gear whose phase is told
frame: {A: [0 mm, 0 mm], D: [90 mm, 0 mm]}
links:
  1: {gear: A, radius: 30 mm}
  2: {gear: D, radius: 60 mm, E: {DE: 30 mm, angle: 40 deg}}
joints: [2 rolls on 1 at H]
input: {link: 1, phi: 0 deg, omega: 100 r/min ccw}
loads: {M_q: {on: 2, size: 30 N*m, during: [30 deg, 150 deg]}, M_c: {on: 1, size: constant}}
masses: {2: {mass: 5 kg, centre: E}}
weight: yes
machine: {n: 100 r/min, delta: 0.05}
find: [M_c, J_F]
"""


def test_a_branch_statement_of_the_given_position_leads_round_the_whole_turn() -> None:
    _agree(exactly(vecpoly.loads(DRAG_LINK)))


def test_a_gear_whose_phase_is_told_in_one_position_rolls_on_through_the_two_turns_of_its_period() -> None:
    _agree(exactly(vecpoly.loads(TOLD_GEAR)))


def test_a_force_that_turns_with_the_crank_has_its_direction_in_every_place_of_the_period() -> None:
    text = DRAG_LINK.replace("{AB: 90 mm}", "{AB: 90 mm, E: {AE: 50 mm, angle: 40 deg from AB}}")
    text = text.replace("150 deg]}", "150 deg]}, F_t: {on: 1, at: B, size: 90 N, direction: along BE}")
    _agree(exactly(vecpoly.loads(text)))
