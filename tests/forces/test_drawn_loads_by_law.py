"""Claims about loads that depend on place and speed, as they are drawn: read off the sheet, equal to the oracle's."""

from __future__ import annotations

from textwrap import dedent

import numpy as np
import pytest

from tests.at_once import exactly
from tests.lawful import CARD, COIL, CUT, ENGINE, SPRING, slider
from tests.laws import few
from vecpoly import load, loads, problem
from vecpoly.board.place import View, view_named
from vecpoly.errors import EquilibriumError, NoMethodError
from vecpoly.problem.problem import Problem
from vecpoly.problem.values.vary import data_of, vary
from vecpoly.solution import Solution, solve

TABLE = "M: {on: 2, size: {columns: [phi (deg), M (N*m)], rows: [[0, 10], [90, -30], [360, 10]]}}"
FIND = "R_43, R_12, M_1, M_1_lever, M_1_power"


def placed(problem: Problem, degrees: float) -> Problem:
    return vary(problem, {"phi": f"{degrees} deg"})


def drawn_exactly(problem: Problem) -> Solution:
    solution = exactly(problem)
    for answer in solution.answers.values():
        gap = answer.deviation if answer.drawn_vector is None else abs(answer.drawn_vector - answer.exact_vector)  # type: ignore[operator]
        assert abs(gap) <= 1e-9 * max(1.0, abs(answer.exact)), answer.key
    return solution


@pytest.mark.parametrize("degrees", few([15, 70, 200, 290, 170, 352], 6))
@pytest.mark.parametrize(
    ("entry", "key"), [(CUT, "F"), (ENGINE, "F"), (SPRING, "F_s"), (COIL, "M_s"), (TABLE, "M")], ids=lambda it: it[:9]
)
def test_each_kind_of_load_is_drawn_as_the_oracle_finds_it(entry: str, key: str, degrees: float) -> None:
    mass = "masses: {3: {mass: 0.9 kg}}\n"
    problem = placed(slider(entry, find=f"{key}, {FIND}", more=mass), degrees)
    drawn_exactly(problem)


def test_a_load_outside_its_window_is_not_drawn_and_the_step_says_so() -> None:
    away = drawn_exactly(placed(slider(CUT, "Q: {on: 3, at: C, size: 90 N, direction: 180 deg}", find="F, M_1"), 300))
    told = " ".join(step.words.en for step in away.construction.steps)
    assert away.answers["F"].drawn == 0.0 and ", so $F$ does not act here" in told
    assert "F" not in {
        mark.key for figure in away.construction.figures for mark in figure.marks if hasattr(mark, "key")
    }


def test_whether_a_load_acts_is_one_sentence_with_its_place_and_range() -> None:
    press = problem(data_of(load("press-flywheel")) | {"find": ["M_b"]})
    told = [step.words for step in drawn_exactly(press).construction.steps]
    (said,) = (words for words in told if words.en.endswith(", so $M_{r}$ acts here."))
    assert said.en == "The position $φ_{1}$ = 120° lies within 60° to 150°, so $M_{r}$ acts here."
    assert said.zh == "$φ_{1}$ = 120° 在 60°～150° 内，故 $M_{r}$ 起作用。"
    beyond = drawn_exactly(placed(press, 200)).construction.steps
    assert any(step.words.zh == "$φ_{1}$ = 200° 不在 60°～150° 内，故 $M_{r}$ 不起作用。" for step in beyond)


def test_the_length_of_a_spring_is_measured_and_its_error_goes_on() -> None:
    solution = solve(load("return-spring"))
    measured = {str(act) for act in solution.construction.acts if "HE" in str(act) or "EH" in str(act)}
    assert measured and solution.answers["F_s"].drawn != solution.answers["F_s"].exact
    for key in ("F_s", "M_1"):
        assert 0 < abs(solution.answers[key].deviation) < solution.answers[key].expected_error


def test_a_longer_reading_stretches_the_spring() -> None:
    problem = load("return-spring")
    before, after = (solve(problem, by="exact", readings=own) for own in ({}, {"EH": "50 mm"}))
    mechanism = after.construction.figure(View.MECHANISM)
    assert mechanism is not None
    stretched = 30 + 2000 * (50 * mechanism.scale.value - 0.09)
    assert after.answers["F_s"].drawn == pytest.approx(stretched, rel=1e-9) != before.answers["F_s"].drawn


def test_the_constant_over_the_period_is_the_rectangle_under_the_moments_of_twelve_positions() -> None:
    solution = drawn_exactly(slider(CUT, unknown="M_d: {on: 1, size: constant}", find="M_d, M_b"))
    torque = solution.construction.figure(view_named("torque"))
    assert torque is not None and torque.scale.across is not None
    assert any("the rectangle of the same area" in step.words.en for step in solution.construction.steps)
    assert solution.answers["M_d"].drawn != pytest.approx(solution.answers["M_b"].drawn, rel=0.1)


def test_with_friction_the_constant_is_left_to_the_exact_answers() -> None:
    rubbing = "friction: {A: {rho: 3 mm}}\n"
    with pytest.raises(NoMethodError, match="constant over the period and there is friction"):
        solve(slider(CUT, unknown="M_d: {on: 1, size: constant}", more=rubbing, find="M_d"))


def test_the_drawing_refuses_a_place_of_which_the_table_says_nothing() -> None:
    short = slider(ENGINE.replace(CARD, "columns: [s (mm), p (MPa)], rows: [[0, 3], [90, 1]]"))
    with pytest.raises(EquilibriumError, match="comes to"):
        solve(placed(short, 170))


def test_friction_and_springs_between_moving_links_share_one_efficiency() -> None:
    between = "F_s: {spring: B1-C3, k: 3 N/mm, l_0: 80 mm, c: 90 N*s/m}"
    load_ = "Q: {on: 3, at: C, size: 700 N, direction: 0 deg}"
    rubbing = "friction: {A: {rho: 3 mm}, B: {rho: 2 mm}, C: {rho: 2 mm}, 3-4: {phi: 6 deg}}\n"
    solution = drawn_exactly(slider(between, load_, more=rubbing, find="F_s, R_12, M_1, eta"))
    assert 0.5 < solution.answers["eta"].drawn < 1 and np.isfinite(solution.answers["R_12"].drawn)


SHAPER = """
    id: machine
    title: machine
    frame: {A: [0 mm, 0 mm], D: [0 mm, -136.748 mm]}
    links: {1: {AB: 62.473 mm}, 2: {block: B}, 3: {slot: D, C: {along: D, at: 262.117 mm}}, 4: {CE: 170.838 mm},
            5: {block: E}}
    joints: [2 slides in 3, 5 slides on y = 125.369 mm]
    branch: [E left of C]
    input: {link: 1, phi: 225 deg, omega: 203 r/min ccw}
    loads:
      F: {on: 5, at: E, size: 1876 N, while: E moves right, between: [60 %, 100 %], direction: 0 deg}
      M_q: {on: 3, size: 882 N*m, while: 3 turns cw}
      M: {on: 1, size: constant}
    masses: {1: {mass: 7.139 kg, inertia: 0.0998 kg*m^2, centre: A}, 5: {mass: 4.68 kg}}
    machine: {n: 43 r/min, delta: 0.2}
    find: [M]
"""


def test_a_part_of_a_stroke_that_reaches_its_end_lasts_as_long_as_the_motion() -> None:
    """Where a stroke ends the travel hardly changes: a hundred-millionth of the drive's turn was lost."""
    answer = drawn_exactly(loads(dedent(SHAPER))).answers["M"]
    assert answer.drawn == pytest.approx(answer.exact, rel=1e-11)


WAITING = """
id: waiting
title: a load that waits
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 200 mm}, 3: {block: C}}
joints: [3 slides on y = 0 mm]
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
branch: [C right of B]
loads:
  Q: {on: 3, at: C, size: 600 N, direction: 0 deg, while: %s}
  M_1: {on: 1, size: "?"}
find: [M_1]
"""


@pytest.mark.parametrize(
    ("awaited", "told"),
    [("C moves up", "C never moves"), ("3 turns ccw", "link 3 never turns"), ("1 turns cw", "link 1 never turns"),
     ("C moves right", ""), ("C moves along 89 deg", ""), ("2 turns cw", "")],
)  # fmt: skip
def test_a_load_that_waits_for_what_never_comes_is_told(awaited: str, told: str) -> None:
    warnings = " ".join(words.en for words in solve(loads(WAITING % awaited), repeats=0).warnings)
    assert told in warnings if told else "never" not in warnings
