"""A pin in a slot presses on the side of the slot: R_ij of the two links;
the block that kinematics thinks there is named nowhere."""

from __future__ import annotations

import json
from math import cos, radians, sin, sqrt

import numpy as np
import pytest

from tests.texts import SIX_BAR
from vecpoly import loads
from vecpoly.errors import NoSlipSenseError, ProblemFileError
from vecpoly.foundation.slotted import replace
from vecpoly.oracle.forces import forces
from vecpoly.problem.load import load
from vecpoly.solution import Solution, solve

STANDING = """
id: standing
title: a pin of the frame in a moving slot
frame: {A: [0 mm, 0 mm], P: [120 mm, 30 mm]}
links: {1: {AB: 50 mm}, 2: {slot: B, E: {along: B, at: 250 mm}}}
joints: [P runs in 2]
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
"""
LOADS = 'loads: {F: {on: 2, at: E, size: 100 N, direction: 180 deg}, M_1: {on: 1, size: "?"}}\n'
TRAMMEL = """
id: trammel
title: two pins in two fixed slots
frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm]}
links: {1: {DC: 60 mm}, 2: {CE: 160 mm}, 3: {EF: 100 mm, G: {along: EF, at: 150 mm}}}
joints: [E runs in y = 0 mm, F runs in x = 0 mm]
input: {link: 1, phi: 70 deg, omega: 2 rad/s ccw}
branch: [E left of C, F above A]
loads: {F: {on: 3, at: G, size: 100 N, direction: 180 deg}, M_1: {on: 1, size: "?"}}
"""
HELD = """
id: held
title: a link that a pin in its slot holds fast
frame: {A: [0 mm, 0 mm], C: [120 mm, 0 mm], D: [40 mm, 50 mm]}
links: {1: {DB: 30 mm}, 2: {slot: A}, 3: {block: E}, 4: {BE: 70 mm}}
joints: [C runs in 2, 3 slides along 2]
input: {link: 1, phi: 20 deg, omega: 10 rad/s ccw}
branch: [E right of B]
loads: {F: {on: 3, at: E, size: 100 N, direction: 240 deg}, M_1: {on: 1, size: "?"}}
"""
SCALES = "scales: {mu_l: 0.001 m/mm, mu_v: 0.01 (m/s)/mm, mu_a: 0.1 (m/s^2)/mm, mu_F: 5 N/mm}\n"


def exact_hand(text: str) -> Solution:
    """At scales that are given: what this hand draws is right at any, and to choose them takes two more drawings."""
    given = text if "scales:" in text else f"{text.rstrip()}\n{SCALES}"
    return solve(loads(given), by="exact", repeats=0, precise=False)


def agreeing(solution: Solution) -> int:
    """How many answers there are, all drawn as exact."""
    largest = max(abs(one.exact) for one in solution.answers.values())
    assert all(abs(one.drawn - one.exact) <= 1e-9 * largest for one in solution.answers.values())
    return len(solution.answers)


def test_the_pin_presses_on_the_slot_at_the_friction_angle_through_its_centre() -> None:
    solution = solve(load("crank-pin-in-slot"), by="exact", repeats=0, precise=False)
    assert agreeing(solution) == 6
    found = solution.answers["R_12"]
    assert found.drawn_vector is not None and found.reading.acts is not None
    slot = complex(*(50e-3 * np.cos(radians(20)), 50e-3 * np.sin(radians(20)) + 140e-3))
    lean = abs(np.angle(found.drawn_vector / (1j * slot)))
    assert min(lean, np.pi - lean) == pytest.approx(radians(8), abs=1e-9)
    assert found.reading.acts.point == pytest.approx(50e-3 * np.exp(1j * radians(20)), abs=1e-12)


def test_no_block_is_named_in_the_answers_or_the_steps() -> None:
    solution = solve(load("crank-pin-in-slot"))
    assert "pinB" not in json.dumps(solution.as_json(), ensure_ascii=False)
    told = " ".join(step.words.zh + step.words.en for step in solution.construction.steps)
    assert "pinB" not in told and "Pin $B$ of link 1 runs in the slot of link 2" in told


def test_a_pin_of_the_frame_has_the_frames_number_in_forces_and_in_kinematics() -> None:
    assert agreeing(exact_hand(f"{STANDING}{LOADS}find: [M_1, R_23, R_32, R_13, R_12]\n")) == 5
    moving = exact_hand(STANDING + "find: [v_P2P3, ak_P2P3, ar_P2P3, omega_2]\n")
    assert agreeing(moving) == 4 and set(moving.answers) == {"v_P2P3", "ak_P2P3", "ar_P2P3", "omega_2"}


def test_what_is_asked_where_nothing_is_said_has_the_pressing_links() -> None:
    assert {ask.rel.key for ask in loads(STANDING + LOADS).asks} == {"M_1", "R_13", "R_12", "R_23"}


def test_a_pin_in_a_slot_between_hinged_links_is_told_from_the_hinge_by_its_letter() -> None:
    answers = exact_hand(HELD).answers
    assert answers["R_25C"].drawn == pytest.approx(answers["R_25C"].exact, rel=1e-9)
    assert answers["R_25"].drawn == pytest.approx(answers["R_25"].exact, rel=1e-9)
    b = 40 + 30 * cos(radians(20)), 50 + 30 * sin(radians(20))
    share = (b[0] + sqrt(70**2 - b[1] ** 2)) / 120  # of the block on the slot: three parallel forces about A
    assert answers["R_25C"].drawn / answers["R_23"].drawn == pytest.approx(share, rel=1e-9)
    assert answers["R_25"].drawn / answers["R_23"].drawn == pytest.approx(1 - share, rel=1e-9)


def test_two_pins_of_one_link_are_told_apart_by_their_letters() -> None:
    solution = exact_hand(f"{TRAMMEL}pins: {{E: 3}}\n")
    assert {"R_43E", "R_43F"} <= set(solution.answers)
    assert agreeing(solution) == len(solution.answers) >= 5


@pytest.mark.parametrize(
    ("spoilt", "said", "gesagt"),
    [
        (f"{STANDING}{LOADS}friction: {{P: {{rho: 2 mm}}}}\n", "turns in no bearing", "不在轴承中转动"),
        (
            STANDING + 'loads: {M_1: {on: 1, size: "?"}, F: {on: pinP, at: P, size: 1 N, direction: 0 deg}}\n',
            "does not exist; known: 1, 2",
            "不存在",
        ),
        (STANDING + "find: [omega_pinP]\n", "", ""),
    ],
)
def test_the_block_cannot_be_loaded_asked_for_or_given_a_circle(spoilt: str, said: str, gesagt: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        loads(spoilt)
    assert said in refused.value.words.en and gesagt in refused.value.words.zh


@pytest.mark.parametrize("owner", ["2", "3", "4"])
def test_the_owner_of_a_pin_changes_no_group_and_no_balance(owner: str) -> None:
    own, plain = exact_hand(f"{SIX_BAR}pins: {{C: {owner}}}\n"), exact_hand(SIX_BAR)
    assert agreeing(own) == 8
    assert own.answers["M_1"].drawn == pytest.approx(plain.answers["M_1"].drawn, rel=1e-12)


@pytest.mark.parametrize("owner", ["2", "4"])
def test_friction_at_a_pin_that_is_given_away_settles(owner: str) -> None:
    rubbing = (
        "friction: {A: {rho: 3 mm}, B: {rho: 3 mm}, C: {rho: 4 mm}, D: {rho: 3 mm}, E: {rho: 3 mm}, F: {rho: 3 mm}}\n"
    )
    assert agreeing(exact_hand(f"{SIX_BAR}pins: {{C: {owner}}}\n{rubbing}")) == 10


ROLLING = 'loads: {M_3: {on: 3, size: 5 N*m}, M_1: {on: 1, size: "?"}}\n'


@pytest.mark.parametrize("base", ["geared-five-bar", "three-legged-plate"])
def test_reactions_are_drawn_where_gears_mesh_and_where_another_link_makes_class_ii_of_it(base: str) -> None:
    head = f"id: x\ntitle: x\nextends: {base}\n{ROLLING}"
    asked = [ask.rel.key for ask in loads(head + "find: null\n").asks]
    assert len(asked) > 6 and agreeing(exact_hand(head + "find: null\n")) == len(asked)


def test_friction_of_a_pin_on_the_side_of_a_slot_takes_its_share_of_the_power() -> None:
    """tan φ N v along the slot, by a third party's kinematics."""
    problem = load("crank-pin-in-slot")
    assert problem.loads is not None
    result = forces(problem.mechanism, replace(problem.loads, friction=replace(problem.loads.friction, pins={})))
    assert result.power_in == pytest.approx(result.power_out + result.loss, rel=1e-9)
    pin = 50e-3 * np.exp(1j * radians(20))
    slot = (pin + 140e-3j) / abs(pin + 140e-3j)
    assert result.loss > 0
    force, slip = result.value("R_12"), abs((np.conj(slot) * 10j * pin).real)
    assert result.loss == pytest.approx(abs((np.conj(slot) * force).real) * slip, rel=1e-9)


def test_friction_of_a_pin_that_does_not_slide_in_its_slot_has_no_sense() -> None:
    """The crank along the lever: the pin moves square to the slot."""
    problem = load("crank-pin-in-slot")
    assert problem.loads is not None
    with pytest.raises(NoSlipSenseError, match=r"pin B in the slot of 2.*choose another position"):
        forces(problem.mechanism, problem.loads, np.pi / 2)
