"""Function generators: known cases, what the drawing does with them, what is refused."""

from __future__ import annotations

from math import cos, degrees, radians, sin
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import vecpoly
from tests.laws import often
from tests.synthesis.inversion import posed, solved
from vecpoly.board.paper.marks import AngleMark, Point
from vecpoly.check.printed.answers import check_problem
from vecpoly.designs.base import Design
from vecpoly.designs.generator.formula import Formula
from vecpoly.errors import AssemblyError, NotAskedError, ProblemFileError
from vecpoly.oracle.synthesis.registry import linkages
from vecpoly.problem.load import load
from vecpoly.solution import Solution, solve

LOG: dict[str, Any] = {
    "AD": "100 mm",
    "function": "log10(x)",
    "x": [1, 2],
    "phi": ["270 deg", "330 deg"],
    "psi": ["180 deg", "270 deg"],
}


def drawn(solution: Solution) -> dict[str, float]:
    """What was read, by key."""
    return {key: answer.drawn for key, answer in solution.answers.items()}


def test_the_logarithm_is_generated_with_both_links_pointing_against_their_angles() -> None:
    found = drawn(solved(vecpoly.load("function-log")))
    true = {"AB": 186.599441965, "BC": 261.957014572, "CD": 83.751303788, "delta_B": 180.0, "delta_C": 180.0}
    assert {key: found[key] for key in true} == pytest.approx(true, rel=1e-9)
    assert found["epsilon_max"] == pytest.approx(0.125242226, abs=1e-9)


def test_exercise_8_18_has_the_lengths_and_the_numbers_of_freudenstein() -> None:
    found = drawn(solved(vecpoly.load("8-18")))
    true = {"AB": 63.938618, "BC": 101.205412, "CD": 101.118633, "P_0": 1.58149543, "P_1": -1.26398291}
    assert {key: found[key] for key in true} == pytest.approx(true, rel=1e-8)


def test_the_book_s_numbers_of_8_18_are_right_to_the_four_figures_that_it_reckoned_with() -> None:
    told = {one.printed.symbol: one for one in check_problem(vecpoly.load("8-18")).answers}
    assert {one.verdict.value for one in told.values()} == {"reproduced", "rounding"}
    assert told["AB"].verdict.value == "rounding"
    assert told["AB"].deviation == pytest.approx(-0.000244, abs=1e-6)


def test_the_precision_points_are_those_of_chebyshev() -> None:
    steps = solved(vecpoly.load("function-log")).construction.steps
    text = " ".join(str(node) for step in steps[:1] for node in step.formulas)
    assert all(number in text for number in ("1.067", "1.5", "1.933"))


def test_where_the_function_has_no_error_it_is_at_the_precision_points() -> None:
    values = drawn(solved(posed("function-generator", **LOG)))
    a, b, c = -values["AB"], values["BC"], -values["CD"]
    for n in (1, 3, 5):
        x = 1.5 - 0.5 * cos(radians(30 * n))
        phi, psi = radians(270 + 60 * (x - 1)), radians(180 + 90 * np.log10(x) / np.log10(2))
        bar = complex(a * cos(phi), a * sin(phi)) - complex(100 + c * cos(psi), c * sin(psi))
        assert abs(bar) == pytest.approx(b, rel=1e-9)


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"AD": "1 mm"}, "pairs, function"),
        ({**LOG, "x": None}, "here are: phi, psi"),
        ({**LOG, "function": "__import__('os')"}, "is no formula"),
        ({**LOG, "function": "log10(x - 1.5)"}, "nan"),
        ({**LOG, "x": [1, 1]}, "different at both ends"),
        ({**LOG, "function": "1/x", "x": [-1, 2]}, "all the way from x = -1 to 2, without a jump"),
        ({**LOG, "function": "x", "psi": ["270 deg", "330 deg"]}, "any parallelogram does that"),
        ({"AD": "1 mm", "pairs": ["1 deg -> 1 deg", "9 deg -> 9 deg", "20 deg -> 380 deg"]}, "any parallelogram"),
        ({**LOG, "phi": ["0 deg", "0 deg"]}, "the range of phi"),
        ({"AD": "1 mm", "pairs": ["1 deg -> 2 deg"]}, "here are 1"),
    ],
)
def test_data_that_tell_no_function_are_refused_with_what_to_write(data: dict[str, Any], said: str) -> None:
    with pytest.raises(ProblemFileError, match=said):
        posed("function-generator", **{key: value for key, value in data.items() if value is not None})


def test_a_linkage_that_cannot_pass_the_range_is_no_solution() -> None:
    data = {**LOG, "function": "x^2", "phi": ["50 deg", "140 deg"], "psi": ["230 deg", "290 deg"]}
    drawn = solved(posed("function-generator", **data)).construction
    assert drawn.conclusion is not None and "dead point within the given range" in drawn.conclusion.en


@pytest.mark.parametrize(
    ("text", "x", "value"), [("x^2 - 1/x", 2.0, 3.5), ("-sin(pi*x)", 0.5, -1.0), ("ln(e)", 7.0, 1)]
)
def test_a_formula_has_the_value_that_one_computes(text: str, x: float, value: float) -> None:
    assert Formula(text)(x) == pytest.approx(value)


@pytest.mark.parametrize("phi", [(-20, 20, 70), (70, 20, -20), (-20, 20.000001, 70), (330, 30, 75)])
def test_a_crank_that_stands_alike_above_and_below_the_frame_has_its_generator(phi: tuple[float, ...]) -> None:
    """The first position as seen from the second asks for C in D, whatever the crank is: another one is kept."""
    psi = {-20: 30, 20: 55, 20.000001: 55, 70: 90, 330: 30, 30: 55, 75: 90}
    problem = posed("function-generator", AD="100 mm", pairs=[f"{one} deg -> {psi[one]} deg" for one in phi])
    assert isinstance(problem.subject, Design)
    found, (exact,) = solved(problem), linkages(problem.subject)
    values = drawn(found)
    assert not found.suspect
    assert {key: values[key] for key in ("AB", "BC", "CD")} == pytest.approx(
        {key: exact.values[key] for key in ("AB", "BC", "CD")}, rel=1e-9
    )


angles = st.tuples(st.floats(15, 60), st.floats(10, 60), st.floats(10, 60))


@settings(max_examples=often(3))
@given(phi=angles, psi=angles, where=st.floats(0, 360))
def test_every_drawn_generator_closes_at_its_three_pairs_and_is_that_of_the_equation(
    phi: tuple[float, ...], psi: tuple[float, ...], where: float
) -> None:
    inputs, outputs = np.cumsum(phi), where + np.cumsum(psi)
    assume(not np.allclose(np.cos(np.radians(outputs - inputs)), 1, rtol=0, atol=1e-11))  # a parallelogram: refused
    pairs = [f"{one!r} deg -> {two!r} deg" for one, two in zip(inputs.tolist(), outputs.tolist(), strict=True)]
    problem = posed("function-generator", AD="100 mm", pairs=pairs)
    try:
        found = solved(problem)
    except AssemblyError:
        assume(False)
        return
    assert not found.suspect
    (one,) = found.construction.candidates
    assume(one.reason is None)
    values = one.values
    a = values["AB"] * (1 if values["delta_B"] < 90 else -1)
    c = values["CD"] * (1 if values["delta_C"] < 90 else -1)
    turn_in, turn_out = np.exp(1j * np.radians(inputs)), np.exp(1j * np.radians(outputs))
    size = values["AB"] + values["CD"] + 100
    assert np.abs(np.abs(100 + c * turn_out - a * turn_in) - values["BC"]).max() < 1e-7 * size


@settings(max_examples=often(2))
@given(
    function=st.sampled_from(["x^2", "log10(x)", "1/x", "sqrt(x)", "exp(x)"]),
    top=st.floats(1.5, 4),
    phi=st.floats(0, 360),
    turn=st.sampled_from([60, 90, 120]),
    psi=st.floats(0, 360),
    sweep=st.sampled_from([-90, -60, 60, 90]),
)
def test_drawing_and_equation_agree_about_every_function_and_its_error(
    function: str, top: float, phi: float, turn: float, psi: float, sweep: float
) -> None:
    data = {**LOG, "function": function, "x": [1, top]}
    data |= {"phi": [f"{phi!r} deg", f"{phi + turn!r} deg"], "psi": [f"{psi!r} deg", f"{psi + sweep!r} deg"]}
    problem = posed("function-generator", **data)
    assert isinstance(problem.subject, Design)
    try:
        exact = linkages(problem.subject)
    except AssemblyError:
        with pytest.raises(AssemblyError):
            solved(problem)
        return
    (one,) = solved(problem).construction.candidates
    assert one.verdict == exact[0].verdict.name
    for key in ("AB", "BC", "CD", "epsilon_max") if one.reason is None else ():
        assert one.values[key] == pytest.approx(exact[0].values[key], rel=1e-7, abs=1e-7)


def test_trials_that_tell_no_crank_are_refused_with_what_is_wrong() -> None:
    pairs = ["102 deg -> 119 deg", "136 deg -> 76 deg", "183 deg -> 51 deg"]
    problem = posed("function-generator", AD="80 mm", pairs=pairs)
    assert solved(problem).answers["AB"].exact == pytest.approx(0.8233498)
    with pytest.raises(NotAskedError, match="in both trials P and Q all but fall together"):
        problem.solve()


def test_trials_that_miss_by_as_much_to_either_side_have_the_crank_midway_between_them_by_its_inverse() -> None:
    """k is linear in 1/AE, and here k_F = −k_E."""
    read: dict[str, str] = {}
    for prime in ("", "^′"):
        read |= {f"P{prime} Q{prime}": "5 mm", f"D P{prime}": "50 mm", f"D Q{prime}": "40 mm"}
    solution = vecpoly.load("8-18").solve(by="exact", readings=read)
    figure = next(one for one in solution.construction.figures if one.name == "trial cranks")
    at = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
    trials = [figure.scale.value * abs(at[f"{letter}_1"] - at["A"]) for letter in "EF"]
    assert 2 / solution.answers["AB"].drawn == pytest.approx(sum(1e-3 / length for length in trials), rel=1e-9)


def test_an_angle_beyond_half_a_turn_is_marked_as_it_counts() -> None:
    """φ_1 = 274° counter-clockwise from AD, not 86° clockwise."""
    marks = [mark for figure in solve(load("function-log")).construction.figures for mark in figure.marks]
    swept = {mark.label: degrees(mark.sweep) for mark in marks if isinstance(mark, AngleMark)}
    assert swept["φ_1"] == pytest.approx(274.0, abs=0.1) and swept["ψ_3"] == pytest.approx(265.6, abs=0.1)
