"""Centres lead on from a link whose motion against the frame is known: where a cylinder or a motor between two moving
links drives, another link is thought to, with the rate that a trial polygon gives."""

from __future__ import annotations

import pytest

from tests.forces.test_pins_in_slots import agreeing, exact_hand

BOOM = """
id: x
title: a boom lifted by a cylinder
frame: {A: [0 mm, 0 mm], D: [450 mm, -350 mm]}
links: {1: {AC: 1150 mm}, 2: {cylinder: D}, 3: {piston: C}}
joints: [3 slides in 2]
input: {cylinder: 2-3, length: 900 mm, v: 0.12 m/s, a: 0 m/s^2}
branch: [C left of AD]
method: centres
"""
GATE = """
id: x
title: a gate on a guide pushed by a cylinder
frame: {A: [50 mm, 20 mm], D: [-101 mm, 7 mm]}
links: {1: {block: C, E: {CE: 80 mm, angle: 40 deg from line}}, 2: {piston: D}, 3: {cylinder: C}}
joints: [1 slides on line through A at 26.6 deg, 2 slides in 3]
input: {cylinder: 2-3, length: 156.2 mm, v: 0.3 m/s, a: 0.2 m/s^2}
guesses: {C: [54.5 mm, 22.2 mm]}
method: centres
"""
MOTOR = """
id: x
title: a motor in the hinge of crank and coupler
frame: {A: [0 mm, 0 mm], D: [300 mm, 0 mm]}
links: {1: {AB: 120 mm}, 2: {BC: 260 mm}, 3: {DC: 180 mm}}
input: {link: 2, on: 1, phi: 300 deg, omega: 2 rad/s ccw}
branch: [C above AD]
method: centres
"""


@pytest.mark.parametrize(
    ("text", "links"), [(BOOM, "123"), (GATE, "23"), (MOTOR, "123")], ids=["boom", "gate", "motor"]
)
def test_velocities_follow_from_the_centres_where_a_cylinder_or_a_motor_drives(text: str, links: str) -> None:
    solution = exact_hand(text + f"find: [{', '.join(f'omega_{link}' for link in links)}]\n")
    assert agreeing(solution) == len(links)
    assert all(abs(answer.exact) > 1e-3 for answer in solution.answers.values())
    told = [step.words.en for step in solution.construction.steps]
    assert sum("a trial polygon with" in text for text in told) == 1


def test_the_centres_themselves_need_no_velocity() -> None:
    assert agreeing(exact_hand(BOOM + "find: [centres]\n")) == 6
