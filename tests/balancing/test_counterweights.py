"""Counterweights that balance a linkage fully: drawn, exact, and judged by the centre of mass of what is finished."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import vecpoly
from tests.at_once import exactly
from vecpoly.check.shaking import shaking_of
from vecpoly.oracle.machine.balance import counterweights
from vecpoly.oracle.machine.counterweighted import shaking
from vecpoly.report.content import conclusions
from vecpoly.report.titles import subject
from vecpoly.report.values import counted_from

CASES: dict[str, Any] = json.loads((Path(__file__).parents[1] / "data" / "dynamics.json").read_text(encoding="utf-8"))
NAMES = ("balance-four-bar", "balance-slider-crank", "balance-shaper")


def answers(name: str) -> dict[str, float]:
    """What the exact hand draws."""
    solution = vecpoly.load(name).solve(by="exact")
    assert not solution.suspect
    return {key: float(np.real(one.drawn)) for key, one in solution.answers.items()}


def test_a_four_bar_is_balanced_by_counterweights_on_crank_and_rocker() -> None:
    found, told = answers("balance-four-bar"), CASES["A21"]["results"]
    for no, from_line in (("1", "at_deg_from_AB"), ("3", "at_deg_from_DC")):
        true = told[f"counterweight_{no}"]
        assert found[f"W_c{no}"] == pytest.approx(true["U_kgm"], rel=1e-9)
        assert found[f"m_c{no}"] == pytest.approx(true["m_kg"], rel=1e-9)
        assert found[f"theta_c{no}"] == pytest.approx(true[from_line], abs=1e-7)


def test_a_slider_crank_is_balanced_rod_first_and_then_the_crank() -> None:
    found, told = answers("balance-slider-crank"), CASES["A23"]["results"]
    assert found["m_c2"] == pytest.approx(told["m_c2_kg"], rel=1e-8)
    assert found["m_c1"] == pytest.approx(told["m_c1_kg"], rel=1e-8)
    assert found["m_c"] == pytest.approx(told["total_added_kg"], rel=1e-8)


def test_a_shaper_can_be_balanced_with_five_times_its_own_mass() -> None:
    found, told = answers("balance-shaper"), CASES["A32"]["results"]
    assert found["m_c4"] == pytest.approx(told["m_c4_kg"], rel=1e-8)
    assert found["m_c3"] == pytest.approx(told["m_c3_kg"], rel=1e-8)
    assert found["ratio_c"] == pytest.approx(told["added_over_own_mass"], rel=1e-8)


@pytest.mark.parametrize("name", NAMES)
def test_a_pencil_balances_within_its_expected_error(name: str) -> None:
    solution = vecpoly.load(name).solve(by="pencil", seed=3)
    assert not solution.suspect
    for answer in solution.answers.values():
        assert answer.expected_error is not None
        assert abs(answer.drawn - answer.exact) <= 2 * answer.expected_error


def test_the_shaking_force_before_is_that_of_the_accelerations() -> None:
    problem, told = vecpoly.load("balance-four-bar"), CASES["A21"]["results"]
    assert problem.counterweights is not None
    found = shaking(problem.mechanism, problem.counterweights)
    here = found.force[np.abs(np.degrees(found.at) - 60).argmin()]
    true = told["shaking_force_before_at_60deg"]
    assert abs(here) == pytest.approx(true["F_N"], rel=1e-7)
    assert np.degrees(np.angle(here)) == pytest.approx(true["direction_deg"], abs=1e-5)
    most, where = found.largest
    assert most == pytest.approx(told["shaking_force_max_before_N"], rel=1e-7)
    assert np.degrees(where) == pytest.approx(told["max_before_at_deg"])


@pytest.mark.parametrize("name", NAMES)
def test_the_common_centre_of_mass_rests_with_the_counterweights(name: str) -> None:
    problem = vecpoly.load(name)
    assert problem.counterweights is not None
    before = shaking(problem.mechanism, problem.counterweights)
    after = shaking(
        problem.mechanism, problem.counterweights, counterweights(problem.mechanism, problem.counterweights)
    )
    assert after.largest[0] < 1e-9 * before.largest[0]
    assert after.wander < 1e-9 * problem.mechanism.scale < 1e-3 * before.wander


def test_with_drawn_counterweights_a_little_is_left_and_it_is_told() -> None:
    solution = vecpoly.load("balance-four-bar").solve(by="pencil", seed=3)
    told = shaking_of(solution.problem, {key: float(np.real(one.drawn)) for key, one in solution.answers.items()})
    assert told is not None
    assert "88.46 N" in told.en and "18.5°" in told.en
    left = float(told.en.split("(")[-1].split(" %")[0])
    assert 0 < left < 3
    exact = shaking_of(solution.problem, {})
    assert exact is not None and "read off" not in exact.en
    assert shaking_of(vecpoly.load("3-9"), {}) is None


def test_the_counterweights_are_the_same_in_every_position() -> None:
    problem = vecpoly.load("balance-slider-crank")
    one, other = (problem.vary(phi=f"{phi} deg").solve(by="exact").answers for phi in (20, 250))
    for key in ("W_c1", "theta_c1", "W_c2", "theta_c2"):
        assert one[key].drawn == pytest.approx(other[key].drawn, rel=1e-7)


def test_nothing_of_the_drawing_needs_a_speed() -> None:
    problem = vecpoly.load("balance-four-bar")
    slow = replace(problem, subject=replace(problem.mechanism, drives=(replace(problem.mechanism.drive, rate=1e-3),)))
    fast, still = problem.solve(by="exact"), slow.solve(by="exact")
    assert {key: one.drawn for key, one in fast.answers.items()} == {
        key: one.drawn for key, one in still.answers.items()
    }


def test_a_report_of_counterweights_calls_itself_a_balance() -> None:
    solution = vecpoly.load("balance-four-bar").solve(by="exact")
    assert subject([solution]).zh == "转子与机械的平衡作业"
    told = conclusions(solution, "en")
    assert (
        len(told) == 1 and told[0].startswith("Check (whole turn)") and told[0].endswith("0 N are left at most (0 %).")
    )


def test_no_product_on_the_sheet_is_no_scale_to_be_chosen() -> None:
    masses = "masses: {1: {mass: 0.42 kg, centre: B}, 2: {mass: 1.87 kg, centre: D}, 3: {mass: 1.17 kg, centre: F}}"
    problem = vecpoly.loads(f"""
id: x
title: two slots
frame: {{A: [-71 mm, 106 mm], D: [-125 mm, -22 mm], F: [36 mm, 11 mm]}}
links: {{1: {{AB: 110 mm}}, 2: {{slot: {{through: D, right: 5 mm}}}}, 3: {{slot: F}}}}
joints: [B runs in 2, B runs in 3]
input: {{link: 1, phi: 255.516 deg, omega: -8 rad/s}}
{masses}
counterweights: {{1: {{r: 86 mm}}}}
find: [W_c1, m_c1]
""")
    answers = exactly(problem).answers
    assert answers["m_c1"].drawn == pytest.approx(0.42 * 110 / 86, rel=1e-9)


def test_the_common_centre_of_a_balanced_four_bar_is_that_of_the_masses_at_its_pivots() -> None:
    """m at D: rocker, its counterweight, half of the coupler; 3.39 kg of 5.79 kg, at 260 mm."""
    problem = vecpoly.load("balance-four-bar")
    assert problem.counterweights is not None
    found = shaking(
        problem.mechanism, problem.counterweights, counterweights(problem.mechanism, problem.counterweights)
    )
    assert found.centre.mean() == pytest.approx((0.9 + 1.89 + 0.6) / 5.79 * 0.26, rel=1e-9)


def test_a_mass_beside_the_line_of_its_pins_is_told_once_with_both_angles() -> None:
    text = vecpoly.load("balance-four-bar").text.replace(
        "{along: BC, at: 120 mm}", "{along: BC, at: 120 mm, left: 30 mm}"
    )
    steps = vecpoly.loads(text).solve(by="exact").construction.steps
    beside = [step.words.en for step in steps if "does not lie" in step.words.en]
    assert [one.count("does not lie") for one in beside] == [1]
    assert "$m_{B2}$" in beside[0] and "that of $m_{C2}$" in beside[0]


def test_the_angle_of_a_counterweight_is_told_from_its_link_and_no_other_quantity_is() -> None:
    problem = vecpoly.load("balance-four-bar")
    told = [counted_from(problem, key) for key in ("theta_c1", "theta_c3", "W_c1")]
    assert [one and one.en for one in told] == ["counter-clockwise from $AB$", "counter-clockwise from $DC$", None]
