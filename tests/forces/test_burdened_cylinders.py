"""A cylinder whose links carry loads or masses, or in which something rubs, is a group like any other."""

from __future__ import annotations

import pytest

from tests.at_once import exactly
from tests.drawn_library import drawn
from tests.forces.hung import hung
from vecpoly import Problem, load, loads, problem, solve
from vecpoly.problem.values.vary import data_of


def held(loaded: str) -> Problem:
    return hung("cylinder", "piston", "phi: 75 deg, omega: 3 rad/s", loaded)


def test_a_thrust_on_a_loaded_cylinder_is_drawn_as_it_is_computed() -> None:
    solution = solve(
        held(
            'loads: {F_c: {cylinder: 4-5, size: 800 N}, M_b: {on: 4, size: 30 N*m}, M_1: {on: 1, size: "?"}}\n'
            "friction: {A: {rho: 5 mm}, F: {rho: 3 mm}, 4-5: {f: 0.1}}\n"
            "find: [M_1, M_1_0, R_12, R_53, R_64, R_45, eta]\n"
        ),
        by="exact",
        repeats=0,
    )
    assert not solution.suspect
    for answer in solution.answers.values():
        assert answer.drawn == pytest.approx(answer.exact, rel=1e-9)


def test_a_thrust_that_is_sought_is_put_on_trial_where_its_own_cylinder_rubs() -> None:
    rubbing = "friction: {D: {rho: 4 mm}, F: {rho: 3 mm}, 4-5: {f: 0.1}}\n"
    solution = solve(
        held(
            'loads: {F_c: {cylinder: 4-5, size: "?"}, M_1: {on: 1, size: 40 N*m}}\n'
            + rubbing
            + "find: [F_c, F_c_0, R_53, R_64, eta]\n"
        ),
        by="exact",
        repeats=0,
    )
    thrust, ideal = solution.answers["F_c"], solution.answers["F_c_0"]
    assert thrust.drawn == pytest.approx(thrust.exact, rel=1e-9) and ideal.drawn == pytest.approx(ideal.exact, rel=1e-9)
    assert abs(thrust.drawn - ideal.drawn) > 1.0
    assert any("by trial" in step.words.en for step in solution.construction.steps)


def test_masses_that_vanish_leave_the_thrust_of_a_two_force_member() -> None:
    light = data_of(load("boom-thrust")) | {"find": ["F_c", "R_31", "R_42", "R_41"]}
    masses = light["masses"] | {3: {"mass": "1e-9 kg"}}
    alone, burdened = (exactly(problem(data)).answers for data in (light, light | {"masses": masses}))
    assert [burdened[key].drawn for key in alone] == pytest.approx([one.drawn for one in alone.values()], rel=1e-6)


def test_two_cylinders_on_one_pin_are_groups_of_their_own() -> None:
    solution = exactly(
        loads(
            """
id: two
title: two
frame: {A: [0 mm, 0 mm], D: [450 mm, -350 mm], G: [-300 mm, -300 mm]}
links: {1: {AC: 1150 mm}, 2: {cylinder: D}, 3: {piston: C}, 4: {cylinder: G}, 5: {piston: C}}
joints: [3 slides in 2, 5 slides in 4]
input: {cylinder: 2-3, length: 900 mm, v: 0.12 m/s}
branch: [C left of AD]
loads:
  Q: {on: 1, at: C, size: 2 kN, direction: 250 deg}
  F_2: {cylinder: 4-5, size: 500 N}
  F_c: {cylinder: 2-3, size: "?"}
masses: {2: {mass: 60 kg, centre: {along: D, at: 300 mm}}, 4: {mass: 40 kg, centre: {along: G, at: 300 mm}}}
weight: yes
friction: {A: {rho: 5 mm}, C: {rho: 4 mm}, 4-5: {f: 0.1}}
find: [F_c, F_c_0, R_31, R_51, R_61, R_62, R_64]
"""
        )
    )
    for answer in solution.answers.values():
        assert answer.drawn == pytest.approx(answer.exact, rel=1e-9), answer.key


def test_where_a_cylinder_inside_drives_it_is_said_from_which_link_the_groups_are_taken_off() -> None:
    construction = drawn("boom-heavy-cylinder").construction
    (said,) = (step.words for step in construction.steps if "原动力作用于构件 2、3 之间" in step.words.zh)
    assert "改取构件 1 为原动件拆组" in said.zh and "The drive acts between links 2 and 3" in said.en
    assert "the groups are taken off from link 1" in said.en
