"""Flywheels of linkages: work between the corners, Wittenbauer's tangents, the unevenness that a flywheel leaves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import often
from tests.machine.engines import DATA, PRESS, SHAPER, engine, machine
from vecpoly.check.precision import noise, sizes
from vecpoly.check.truth import exact_values, truth_of
from vecpoly.errors import EquilibriumError, NoMethodError
from vecpoly.oracle.machine.course import course
from vecpoly.oracle.machine.steady import evenness, with_flywheel
from vecpoly.problem.load import loads
from vecpoly.problem.problem import Problem
from vecpoly.solution import solve

KEYS = ("J_e", "M_e", "M_d", "dW_max", "J_F", "J_F_areas", "phi_max", "phi_min", "omega_max", "omega_min")
CASES = {"B07": (PRESS, "n: 120 r/min"), "B09": (SHAPER, "n: 60 r/min")}


@pytest.mark.parametrize("case", CASES)
def test_the_oracle_has_the_flywheel_of_the_case(case: str) -> None:
    text, speed = CASES[case]
    wanted, exact = DATA[case]["results"], exact_values(machine(text, KEYS, f"{speed}, delta: 0.05"))
    near = wanted["wittenbauer"]
    close = max(5e-9, 2 * DATA[case]["agreement"])  # printed to nine digits, found by sums of a million steps
    assert exact["M_d"] == pytest.approx(wanted["M_d_Nm"], rel=close)
    assert exact["dW_max"] == pytest.approx(wanted["dW_max_J"], rel=close)
    assert exact["J_F_areas"] == pytest.approx(wanted["J_F_areas"], rel=close)
    assert [exact[key] for key in ("J_F", "omega_max", "omega_min")] == pytest.approx(
        [near[key] for key in ("J_F", "omega_max", "omega_min")], rel=close
    )
    assert exact["phi_max"] == pytest.approx(near["phi_wmax_deg"], abs=2e-7)
    assert exact["phi_min"] == pytest.approx(near["phi_wmin_deg"], abs=2e-7)
    row = next(row for row in wanted["J_e_table"] if row["phi_deg"] == 120)
    assert [exact["J_e"], exact["M_e"]] == pytest.approx([row["J_e"], row["M_load"]], rel=close)


@pytest.mark.parametrize("case", CASES)
def test_a_flywheel_that_is_there_leaves_the_unevenness_of_the_case(case: str) -> None:
    text, speed = CASES[case]
    wanted = DATA[case]["results"]["with_given_J_F"]
    exact = exact_values(machine(text, ("delta", "omega_max", "omega_min"), f"{speed}, J_F: {wanted['J_F']} kg*m^2"))
    assert [exact[key] for key in ("delta", "omega_max", "omega_min")] == pytest.approx(
        [wanted[key] for key in ("delta", "omega_max", "omega_min")], rel=max(5e-9, 2 * DATA[case]["agreement"])
    )


def _press() -> Problem:
    return machine(PRESS, ("J_F",), "n: 120 r/min, delta: 0.05")


@settings(max_examples=often(4))
@given(delta=st.floats(0.01, 0.9), speed=st.floats(2.0, 50.0))
def test_the_flywheel_of_a_demanded_unevenness_leaves_just_that(delta: float, speed: float) -> None:
    problem = _press()
    assert problem.machine is not None and problem.machine.steady is not None
    of = course(problem.mechanism, problem.machine.loads)
    run = replace(problem.machine.steady, delta=delta, speed=speed)
    asked = evenness(of, run)
    if asked.flywheel:
        assert with_flywheel(of, speed, asked.flywheel).delta == pytest.approx(delta, rel=1e-9)
    else:
        assert asked.delta <= delta


def test_a_machine_that_turns_the_other_way_has_the_same_flywheel() -> None:
    mirrored = PRESS.replace("D: [280 mm, 0 mm]", "D: [-280 mm, 0 mm]").replace("r/min ccw", "r/min cw")
    mirrored = mirrored.replace("C left", "C right").replace(
        "900 N*m cw, during: [60 deg, 150 deg]", "900 N*m ccw, during: [30 deg, 120 deg]"
    )
    run = "n: 120 r/min, delta: 0.05"
    one, other = (exact_values(machine(text, KEYS, run)) for text in (PRESS, mirrored))
    for key in ("dW_max", "J_F", "J_F_areas", "omega_max"):
        assert other[key] == pytest.approx(one[key], rel=1e-9)
    assert other["phi_max"] == pytest.approx(180 - one["phi_max"], abs=1e-9)
    assert other["M_d"] == pytest.approx(-one["M_d"], rel=1e-9)


@pytest.mark.parametrize(("find", "run", "told"), [(("J_F",), "n: 120 r/min, J_F: 0.1 kg*m^2", "stops on its way")])
def test_a_flywheel_too_small_for_the_deficit_is_refused_with_numbers(
    find: tuple[str, ...], run: str, told: str
) -> None:
    with pytest.raises(EquilibriumError, match=told) as refused:
        exact_values(machine(PRESS, find, run.replace("120", "20")))
    assert refused.value.numbers["J_F"] == 0.1


def test_work_that_is_left_over_at_the_end_of_a_turn_is_refused_with_the_change() -> None:
    with pytest.raises(EquilibriumError, match="energy changes by") as refused:
        exact_values(
            engine(["J_F"], loads=("M: {on: 1, size: 2 N*m ccw}",), more="machine: {n: 60 r/min, delta: 0.1}\n")
        )
    assert float(refused.value.numbers["work"]) == pytest.approx(4 * np.pi, rel=1e-9)


def test_a_crank_without_a_whole_turn_has_no_period_and_is_told_its_range() -> None:
    text = (
        PRESS.replace("CD: 200 mm", "CD: 110 mm")
        .replace("during: [60 deg, 150 deg], ", "")
        .replace("phi: 120", "phi: 60")
    )
    with pytest.raises(EquilibriumError, match="no whole turns"):
        exact_values(machine(text.replace("constant", "10 N*m ccw"), ("J_F",), "n: 60 r/min, delta: 0.1"))


TWICE = """
id: twice
title: t
frame: {A: [0 mm, 0 mm], D: [%s mm, 60 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 200 mm}, 3: {block: C}}
joints: [3 slides on y = 0 mm]
input: {link: 1, phi: 30 deg, omega: ccw}
branch: [C right of B]
loads: {F_s: {spring: C3-D, k: 1 N/mm, l_0: 20 mm}, M_d: {on: 1, size: constant}}
machine: {n: 60 r/min, delta: 0.1}
find: [phi_max]
"""


@pytest.mark.parametrize(("x", "one", "other"), [(190, 94.23, 265.77), (201, 81.70, 278.30)])
def test_a_machine_that_is_fastest_at_two_places_is_refused_with_both(x: float, one: float, other: float) -> None:
    """Out and back the piston passes under D, where the spring is shortest; this was told as a dead point, or one of
    the two places where nudged data left both as high."""
    problem = loads(TWICE % x)
    with pytest.raises(EquilibriumError, match=rf"as fast at {one:.2f}° as at {other:.2f}°"):
        noise(problem, truth := truth_of(problem), sizes(problem, truth))


@pytest.mark.parametrize("masses", ["", "masses: {1: {mass: 5 kg, inertia: 0.5 kg*m^2, centre: A}}\n"])
def test_a_machine_of_even_speed_has_no_fastest_place(masses: str) -> None:
    """Rounding chose one: φ_max = 0.25°, φ_min = 320°."""
    even = (TWICE % 190).replace("F_s: {spring: C3-D, k: 1 N/mm, l_0: 20 mm}", "M_r: {on: 1, size: 10 N*m cw}") + masses
    with pytest.raises(EquilibriumError, match="the speed is even"):
        exact_values(loads(even))
    assert exact_values(loads(even.replace("[phi_max]", "[M_d]")))["M_d"] == pytest.approx(10)
    pulled = even.replace("M_r: ", "F: {on: 3, at: C, size: 1 N, direction: 0 deg}, M_r: ")
    assert exact_values(loads(pulled))["phi_max"] == pytest.approx(0, abs=0.01)  # outermost


RATED = (
    "F_s: {spring: A-C3, k: 1 N/mm, l_0: 200 mm, c: 90 N*s/m}",
    "F_d: {damper: A-C3, c: 90 N*s/m}",
    "M_f: {damper: 3-4, c: 2 N*m*s}",
    "M_m: {on: 1, motor: [60 N*m, 3 N*m*s], role: driving}",
)


ASKED = [(load, asked) for load in RATED for asked in ("dW_max", "M_d")[: 1 if "motor" in load else 2]]


@pytest.mark.parametrize(("load", "asked"), ASKED)
def test_a_load_that_depends_on_the_speed_is_refused_over_a_period_by_both(load: str, asked: str) -> None:
    held = "M_d: {on: 1, size: constant, role: driving}"
    text = PRESS.replace(held, load if load.startswith("M_m") else f"{held}\n      {load}")
    problem = machine(text, (asked,), "n: 120 r/min, delta: 0.05")
    name = load[:3]
    for found in (exact_values, lambda one: solve(one, repeats=0, precise=False)):
        with pytest.raises(EquilibriumError, match=f"{name} depends on the speed"):
            found(problem)


def test_the_unevenness_that_is_given_is_not_drawn_and_where_to_find_it_is_said() -> None:
    problem = machine(PRESS, ("M_d", "delta"), "n: 120 r/min, delta: 0.05")
    assert exact_values(problem)["delta"] == pytest.approx(0.05)
    with pytest.raises(NoMethodError, match=r"delta = 0\.05 is given.*vecpoly exact"):
        solve(problem, repeats=0, precise=False)
