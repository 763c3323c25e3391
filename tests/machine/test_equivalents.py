"""Equivalent inertia and moment of a mechanism: cases, energies that are differenced, refusals."""

from __future__ import annotations

import re
from dataclasses import replace
from textwrap import dedent

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vecpoly
from tests.at_once import exactly
from tests.laws import often
from tests.machine.engines import DATA, PISTON, engine
from vecpoly.algebra.formula import plain
from vecpoly.check.truth import exact_values
from vecpoly.errors import DeadPointError, ProblemFileError
from vecpoly.mechanism.asked.machine import equivalents
from vecpoly.oracle import solve
from vecpoly.oracle.machine import reduce
from vecpoly.problem.load import loads

B03 = DATA["B03"]["results"]
MOVING = [row for row in B03["table"] if row["m_e"] is not None]
LOADS = (PISTON, "M_1: {on: 1, size: 60 N*m cw}")
KEYS = ("J_e", "M_e", "m_e3", "F_e3")


@pytest.mark.parametrize("row", MOVING, ids=lambda row: f"{row['phi_deg']}")
def test_the_oracle_has_the_equivalents_of_the_case_at_every_position(row: dict[str, float]) -> None:
    values = exact_values(engine(KEYS, phi=row["phi_deg"], loads=LOADS))
    wanted = [row[key] for key in ("J_e", "M_e", "m_e", "F_e")]
    assert [values[key] for key in KEYS] == pytest.approx(wanted, rel=5e-9)


@pytest.mark.parametrize("omega", ["ccw", "1500 r/min ccw", "0.2 rad/s ccw"])
def test_equivalents_depend_on_ratios_of_velocities_alone(omega: str) -> None:
    answers = exactly(engine(KEYS, omega=omega, loads=LOADS)).answers
    row = next(row for row in MOVING if row["phi_deg"] == 50)
    wanted = [row[key] for key in ("J_e", "M_e", "m_e", "F_e")]
    assert [answers[key].drawn for key in KEYS] == pytest.approx(wanted, rel=1e-8)


@pytest.mark.parametrize("phi", [0.0, 180.0])
def test_no_mass_is_thought_on_a_slider_at_its_dead_centre(phi: float) -> None:
    problem = engine(["J_e", "m_e3"], phi=phi, loads=LOADS)
    with pytest.raises(DeadPointError, match="link 3 stands still") as refused:
        vecpoly.solve(problem)
    assert refused.value.numbers["link"] == "3"
    still = next(row for row in B03["table"] if row["phi_deg"] == phi)
    assert exact_values(engine(["J_e"], phi=phi, loads=LOADS))["J_e"] == pytest.approx(still["J_e"], rel=5e-9)


def test_exercise_7_1_comes_to_round_numbers_wherever_the_guide_is() -> None:
    answers = exactly(vecpoly.load("7-1")).answers
    assert [answers[key].drawn for key in ("J_e", "M_e")] == pytest.approx([0.05, -50.0], rel=1e-9)
    assert [answers[key].drawn for key in ("m_e5", "F_e5")] == pytest.approx([20.0, -1000.0], rel=1e-9)


def test_exercise_7_1_measures_no_ratio_of_a_velocity_to_itself_and_tabulates_no_single_mass() -> None:
    steps = vecpoly.solve(vecpoly.load("7-1"), by="exact", repeats=0, precise=False).construction.steps
    lines = [plain(line) for step in steps for line in step.formulas]
    assert "m_e5 = m_5 = 20.0 kg" in lines and not any(line.startswith("v_F/v_F") for line in lines)
    assert any(line.startswith("v_F/ω_1") for line in lines) and not any(step.listing for step in steps)


YOKE = """
    id: yoke
    title: t
    frame: {A: [0 mm, 0 mm]}
    links: {1: {AB: 45 mm}, 2: {block: B}, 3: {slot: C}}
    joints: [2 slides in 3, 3 slides on y = -60 mm turned 45 deg]
    input: {link: 1, phi: 134 deg, omega: ccw}
    masses: {3: {mass: 8 kg}}
    loads: {F: {on: 3, at: C, size: 100 N, direction: 30 deg}}
    find: [m_e3, F_e3]
"""


def test_a_yoke_at_an_angle_to_its_guide_moves_along_the_guide_and_not_along_its_slot() -> None:
    """m_e is its own mass, F_e what the force has along the guide."""
    values = exact_values(loads(dedent(YOKE)))
    assert (values["m_e3"], abs(values["F_e3"])) == pytest.approx((8.0, 100 * np.cos(np.pi / 6)), rel=1e-12)


@pytest.mark.parametrize("id", ["six-bar-dynamic", "slider-crank-dynamic", "4-7"])
def test_the_equivalent_moment_is_what_the_balancing_moment_holds_where_nothing_has_mass(id: str) -> None:
    problem = vecpoly.load(id)
    assert problem.loads is not None
    still = replace(problem.loads, inertia=False, friction=type(problem.loads.friction)())
    from vecpoly.mechanism.machine import known_of
    from vecpoly.oracle.forces import forces

    reduced = reduce(problem.mechanism, known_of(still))
    balanced = float(forces(problem.mechanism, still).value(still.unknown.name))
    to = next(one for one in equivalents(problem.mechanism) if one.link == still.unknown.link)
    assert float(reduced.load(to)[0]) == pytest.approx(-balanced, rel=1e-9)


@settings(max_examples=often(20))
@given(phi=st.floats(0.0, 6.28), rate=st.floats(-40.0, 40.0).filter(lambda w: abs(w) > 0.1))
def test_the_equivalent_link_has_the_energy_of_all_and_its_rate_is_the_difference(phi: float, rate: float) -> None:
    problem = engine(["J_e"], loads=LOADS)
    mech, machine = problem.mechanism, problem.machine
    assert machine is not None
    moving = replace(mech, drives=(replace(mech.drive, rate=rate),))
    motion = solve(moving, phi)
    energy = sum(
        one.mass * abs(complex(motion.velocity(one.centre))) ** 2 + one.inertia * float(motion.omega(one.link)) ** 2
        for one in machine.loads.masses
    )
    here, near = reduce(mech, machine.loads, phi), reduce(mech, machine.loads, np.array([phi - 1e-5, phi + 1e-5]))
    assert float(here.energy[0]) * rate**2 == pytest.approx(energy, rel=1e-12)
    assert float(here.rate[0]) == pytest.approx(float(np.diff(near.energy)[0]) / 2e-5, abs=1e-8)


@pytest.mark.parametrize(
    ("find", "more", "told"),
    [
        (["J_e9"], "", "no quantity of these loads"),
        (["J_F"], "", "needs to know how the machine runs"),
        (["J_F"], "machine: {delta: 0.05}", "the mean speed is missing"),
        (["J_F"], "machine: {n: 60 r/min, delta: 5}", "must lie between 0 and 1"),
        (["J_F"], "machine: {n: 60 r/min, delta: 0.05, J_F: 6 kg*m^2}", "give delta or J_F"),
        (["delta"], "machine: {n: 60 r/min, J_F: -6 kg*m^2}", "must not be negative; write 6 kg"),
        (["J_e"], "friction: {A: {rho: 3 mm}}", "equivalents know no friction"),
        (["omega_end"], "machine: {n: 60 r/min, start: {phi: 0 deg, omega: 0 rad/s}}", "does not go with n"),
    ],
)
def test_what_no_machine_can_answer_is_refused_in_words(find: list[str], more: str, told: str) -> None:
    with pytest.raises(ProblemFileError, match=told):
        engine(find, loads=LOADS, more=more + "\n")


BESIDE = """
id: x
title: equivalents beside an equilibrium
frame: {A: [0 mm, 0 mm], D: [257 mm, 0 mm]}
links: {1: {AB: 85 mm}, 2: {BC: 213 mm}, 3: {CD: 297 mm}}
branch: [C left of BD]
input: {link: 1, phi: 297 deg, omega: 88 r/min ccw}
loads: {M_q: {on: 3, size: 636 N*m cw}, X: {on: 1, size: "?"}}
masses:
  2: {mass: 3 kg, inertia: 0.05 kg*m^2, centre: {along: BC, at: 100 mm}}
  3: {mass: 6.8 kg, inertia: 0.0144 kg*m^2, centre: C}
weight: yes
"""


@pytest.mark.parametrize("inertia", ["yes", "no"])
def test_weights_count_in_m_e_beside_an_equilibrium_and_inertia_couples_do_not(inertia: str) -> None:
    answers = exactly(vecpoly.loads(f"{BESIDE}inertia: {inertia}\nfind: [J_e, M_e, X]\n")).answers
    assert answers["M_e"].drawn == pytest.approx(answers["M_e"].exact, rel=1e-9)
    if inertia == "no":
        assert answers["X"].drawn == pytest.approx(-answers["M_e"].drawn, rel=1e-9)


def test_weights_count_in_the_diagram_of_moments_over_a_period() -> None:
    text = BESIDE.replace('X: {on: 1, size: "?"}', "M_c: {on: 1, size: constant}").replace(
        "size: 636 N*m cw}", ("size: 636 N*m cw, during: [249 deg, 61 deg]}")
    )
    run = "machine: {n: 176 r/min, delta: 0.11}\nfind: [M_c, dW_max, J_F]\n"
    for key, one in exactly(vecpoly.loads(text + run)).answers.items():
        assert one.drawn == pytest.approx(one.exact, rel=1e-9), key


def test_equivalents_of_a_rocker_that_just_turns_back_are_nothing_and_no_contradiction() -> None:
    """At its outer limit, the input written to nine decimals, the rocker still turns by a hundred-billionth."""
    problem = vecpoly.problem(
        {
            "id": "limit",
            "title": "limit",
            "frame": {"A": 0j, "D": 0.1 + 0.02j},
            "links": {1: {"AB": "30 mm"}, 2: {"BC": "80 mm"}, 3: {"DC": "60 mm"}},
            "input": {"link": 1, "phi": "43.914659528 deg", "omega": 10.0},
            "branch": ["C left of BD"],
            "loads": {"M_q": {"on": 3, "size": "86 N*m"}},
            "masses": {3: {"mass": "2 kg", "inertia": "0.008 kg*m^2", "centre": "D"}},
            "find": ["J_e", "M_e"],
        }
    )
    answers = problem.solve().answers
    assert 0.0 < abs(answers["M_e"].exact) < 1e-7
    assert [one.drawn for one in answers.values()] == [0.0, 0.0]
    assert not any(one.suspect for one in answers.values())


CLOCKWISE = engine(KEYS, omega="10 rad/s cw", loads=LOADS)


@pytest.mark.parametrize("name", ["7-1", "7-2b", "press-flywheel", "shaper-flywheel", "clockwise"])
def test_what_acts_on_the_equivalent_link_is_the_size_of_the_sum_of_powers_over_its_motion(name: str) -> None:
    """One rule in every step: no line turns the sum round, −P/ω here and +ΣP/ω there."""
    solution = exactly(CLOCKWISE if name == "clockwise" else vecpoly.load(name))
    lines = [plain(line) for step in solution.construction.steps for line in step.formulas]
    keys = [key for key in solution.answers if key.startswith(("M_e", "F_e"))]
    assert keys
    for key in keys:
        ((_, sums, *numbers),) = [line.split(" = ") for line in lines if line.startswith(f"{key} = ")]
        assert re.match(r"\(\|(ΣP|P_\w+)\|\)/", sums) and not any("−" in one for one in numbers), (sums, numbers)


@pytest.mark.parametrize("name", ["7-1", "clockwise"])
def test_the_rule_of_the_powers_is_one_and_says_once_how_velocities_are_measured(name: str) -> None:
    solution = exactly(CLOCKWISE if name == "clockwise" else vecpoly.load(name))
    rules = [step.words for step in solution.construction.steps if "功率等效" in step.words.zh]
    assert len(rules) == 2 and all("由 $ΣP$ 的正负判定" in one.zh and "$|ΣP|/" in one.en for one in rules)
    every = "".join(step.words.zh for step in solution.construction.steps)
    assert every.count("由速度多边形量得") == 2, "the ratios of J_e, and the velocities along the forces"
