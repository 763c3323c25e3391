"""Flywheels of the library's linkages as they are drawn: twelve polygons, areas, the bar, Wittenbauer's tangents."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

import vecpoly
from tests.at_once import exactly
from tests.laws import few
from tests.machine.engines import DATA, PRESS, machine
from tests.studies import solved
from vecpoly.algebra.formula import plain
from vecpoly.board.paper.marks import Curve, Point
from vecpoly.errors import EquilibriumError, NoMethodError
from vecpoly.problem.load import loads
from vecpoly.solution import Solution

LIBRARY = ("press-flywheel", "shaper-flywheel", "engine-flywheel")
CASES = {"press-flywheel": "B07", "shaper-flywheel": "B09", "engine-flywheel": "B04"}


@pytest.fixture(scope="module", params=LIBRARY)
def drawn(request: pytest.FixtureRequest) -> Solution:
    data = vecpoly.load(request.param).data
    problem = vecpoly.problem(data | {"find": [*data["find"], "omega_max"]})
    return vecpoly.solve(problem, by="exact", repeats=0, precise=False)


def test_an_exact_hand_draws_the_flywheel_that_the_oracle_integrates(drawn: Solution) -> None:
    for key, answer in drawn.answers.items():
        assert answer.drawn == pytest.approx(answer.exact, rel=1e-9, abs=1e-9), key
        assert not answer.suspect


def test_a_speed_that_is_told_by_its_size_has_no_sense_of_turning(drawn: Solution) -> None:
    """Beside a drive that turns clockwise it was called ccw."""
    assert (drawn.answers["omega_max"].sense, drawn.answers["J_e"].sense) == (None, None)


def test_the_flywheel_is_that_of_the_case(drawn: Solution) -> None:
    wanted = DATA[CASES[drawn.problem.id]]["results"]
    answers = drawn.answers
    assert answers["dW_max"].drawn == pytest.approx(wanted["dW_max_J"], rel=2e-7)
    assert answers["J_F_areas"].drawn == pytest.approx(wanted["J_F_areas"], rel=2e-7)
    assert answers["J_F"].drawn == pytest.approx(wanted["wittenbauer"]["J_F"], rel=2e-7)
    assert answers["phi_max"].drawn == pytest.approx(wanted["wittenbauer"]["phi_wmax_deg"], abs=1e-5)


def test_the_figures_of_a_flywheel_are_all_there_each_with_its_scales(drawn: Solution) -> None:
    names = [figure.view.name for figure in drawn.construction.figures]
    assert {"torque", "inertia", "energy", "energy-mass", "indicator"} <= set(names)
    for figure in drawn.construction.figures:
        if figure.view.across is not None:
            assert figure.scale.across is not None
    torque = next(one for one in drawn.construction.figures if one.view.name == "torque")
    energy = next(one for one in drawn.construction.figures if one.view.name == "energy")
    assert torque.scale.across is not None
    pole = energy.scale.value / (torque.scale.value * torque.scale.across.value)
    assert pole == pytest.approx(round(pole), abs=1e-9)


def test_the_curve_of_energies_turns_by_little_from_ordinate_to_ordinate_however_fast_the_moment_changes(
    drawn: Solution,
) -> None:
    """From chord to chord of the E–φ diagram its slope, the moment, changes by a quarter of its range at most; between
    two jumps of the loads."""
    energy = next(one for one in drawn.construction.figures if one.view.name == "energy")
    runs = [mark.points for mark in energy.marks if isinstance(mark, Curve)]
    slopes = [np.array([(b - a).imag / (b - a).real for a, b in pairwise(run)]) for run in runs]
    every = np.concatenate(slopes)
    assert len(every) > 20
    assert all(np.abs(np.diff(part)).max(initial=0.0) < 0.25 * np.ptp(every) for part in slopes)


def test_areas_that_decide_are_large_enough_to_be_counted(drawn: Solution) -> None:
    scale = drawn.construction.figure(next(f.view for f in drawn.construction.figures if f.view.name == "torque"))
    assert scale is not None and scale.scale.across is not None
    square = scale.scale.value * scale.scale.across.value
    assert drawn.answers["dW_max"].exact / square > 400


@pytest.mark.parametrize("hand", ["drafting", "pencil"])
def test_other_hands_stay_within_what_they_are_expected_to_miss(hand: str) -> None:
    solution = vecpoly.load("press-flywheel").solve(by=hand, seed=3)
    for key, answer in solution.answers.items():
        assert not answer.suspect, key
    assert solution.answers["J_F"].drawn != pytest.approx(solution.answers["J_F"].exact, rel=1e-6)
    assert solution.answers["J_F"].drawn == pytest.approx(solution.answers["J_F"].exact, rel=0.04)


def test_degrees_for_radians_are_a_slip_that_the_surplus_shows() -> None:
    problem = vecpoly.load("press-flywheel")
    slip = next(one for one in vecpoly.slips(problem) if one.key == "mu_A")
    wrong, right = vecpoly.solve(problem, slip=slip), vecpoly.solve(problem)
    ratio = wrong.answers["dW_max"].drawn / right.answers["dW_max"].drawn
    assert ratio == pytest.approx(np.degrees(1.0), rel=0.01)


def test_unevenness_from_a_flywheel_that_is_there_is_left_to_the_exact_answers() -> None:
    with pytest.raises(NoMethodError, match="use 'vecpoly exact'"):
        vecpoly.solve(machine(PRESS, ("delta",), "n: 120 r/min, J_F: 6 kg*m^2"))


def test_the_drawing_refuses_work_that_is_left_over_as_the_oracle_does() -> None:
    text = PRESS.replace("size: constant", "size: 50 N*m ccw")
    with pytest.raises(EquilibriumError, match="over a period, not 0"):
        vecpoly.solve(machine(text, ("dW_max",), "n: 120 r/min, delta: 0.05"))


SHORT = """
id: short
title: t
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 73.658 mm}, 2: {BC: 169.671 mm}, 3: {block: C}}
joints: [3 slides on x = 24.454 mm]
branch: [C above B]
input: {link: 1, phi: 253 deg, omega: 72 r/min ccw}
loads:
  F_q: {on: 3, at: C, size: 2169 N, direction: 270 deg, WINDOW}
  M_c: {on: 1, size: constant}
find: [M_c]
"""
WINDOWS = ("while: C moves down, between: [50 %, 51 %]", "during: [61 deg, 64 deg]", "during: [61 deg, 60 deg]")


@pytest.mark.parametrize("window", few(WINDOWS, 4))
def test_a_load_that_acts_or_rests_for_a_moment_only_is_not_overlooked(window: str) -> None:
    found = exactly(loads(SHORT.replace("WINDOW", window))).answers["M_c"]
    assert found.drawn == pytest.approx(found.exact, rel=1e-9)


def test_what_the_steps_of_the_moments_name_stands_in_the_figure() -> None:
    """M_er, M_d, the area S_1 over the period OT; each ray by the numbers of its strips, each strip once."""
    figures = solved("press-flywheel").construction.figures
    moments, rays = (
        [m.label for m in one.marks if isinstance(m, Point) and m.label]
        for one in figures
        if one.title.en in ("Diagram of moments", "Pole and rays")
    )
    assert {"M_{er}", "M_d", "S_1", "O", "T"} <= {label.replace("M_{d}", "M_d") for label in moments}
    strips = [run.split("–") for label in rays if label[0].isdigit() for run in label.split(", ")]
    told = [n for run in strips for n in range(int(run[0]), int(run[-1]) + 1)]
    assert sorted(told) == list(range(1, len(told) + 1)) and len(told) > 20


def test_works_that_add_up_leave_no_misreading_and_a_ratio_is_not_told_twice() -> None:
    steps = solved("press-flywheel").construction.steps
    assert not any("misreading of 0 J" in step.words.en for step in steps)
    lines = [plain(line) for step in steps for line in step.formulas]
    assert any(line.startswith("ω_2/ω_1 = (1.13") for line in lines)
    parts = [line.split(" = ") for line in lines]
    assert not any(one == two for line in parts for one, two in pairwise(line))


def test_the_flywheel_of_a_linkage_without_masses_can_be_read() -> None:
    bare = PRESS[: PRESS.index("    masses:")] + PRESS[PRESS.index("    loads:") :]
    found = vecpoly.solve(machine(bare, ("dW_max", "J_F", "J_F_areas"), "n: 120 r/min, delta: 0.05"))
    one, by_areas = found.answers["J_F"], found.answers["J_F_areas"]
    assert one.exact == pytest.approx(by_areas.exact)
    assert found.construction.warning is None
    assert one.expected_error < 0.1 * one.exact  # its tangents were all but parallel to the axis that they cut
