"""Crank-rockers from K: cases with every solution listed, laws on random data, refusals with the range."""

from __future__ import annotations

import json
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

import vecpoly
from tests.drawn_library import drawn
from tests.laws import few
from vecpoly.board.paper.marks import Arc, Curve, Point, Segment
from vecpoly.errors import AssemblyError, NotAskedError, ProblemFileError

CASES: dict[str, Any] = json.loads((Path(__file__).resolve().parents[1] / "data" / "synthesis.json").read_text("utf-8"))
KEYS = {"a": "AB", "b": "BC", "c": "CD", "d": "AD", "gamma_min": "gamma_min", "swing": "psi", "K": "K"}


def posed(**data: str) -> vecpoly.Problem:
    """A crank-rocker with these data."""
    return vecpoly.problem({"id": "t", "title": "t", "synthesis": "crank-rocker", "data": data})


@pytest.mark.parametrize("case", few(CASES["crank_rocker"], 3), ids=lambda case: case["id"])
def test_every_listed_solution_is_drawn(case: dict[str, Any]) -> None:
    problem = posed(**case["data"])
    drawn = vecpoly.solve(problem, by="exact", repeats=0).construction.candidates
    assert [one.verdict for one in drawn] == ["VALID"] * len(case["solutions"])
    digits = case["digits"]
    for one, true in zip(drawn, case["solutions"], strict=True):
        assert {key: one.values[KEYS[key]] for key in true} == pytest.approx(true, rel=digits)


def test_two_solutions_of_8_4_are_drawn_and_the_ray_on_the_other_side_misses() -> None:
    solution = vecpoly.load("8-4").solve(by="exact")
    found = {key: answer.drawn for key, answer in solution.answers.items()}
    assert found["AB_1"] == pytest.approx(22.511995, abs=1e-6)
    assert found["BC_2"] == pytest.approx(120.152418, abs=1e-6)
    assert found["gamma_min_1"] == pytest.approx(13.5159, abs=1e-4)
    assert "不相交" in "".join(step.words.zh for step in solution.construction.steps)


def test_the_solution_that_is_taken_has_the_keys_without_a_number() -> None:
    data = {"K": "1.5", "CD": "75 mm", "AD": "100 mm", "ADC": "45 deg"}
    first, second = (posed(**data, take=n).solve(by="exact").answers["AB"].drawn for n in "12")
    assert (first, second) == pytest.approx((22.511995, 49.311764), abs=1e-6)


def test_a_solution_that_does_not_exist_is_refused_by_its_number() -> None:
    with pytest.raises(NotAskedError, match="only 2 valid"):
        posed(K="1.5", CD="75 mm", AD="100 mm", ADC="45 deg", take="3").solve()


def test_a_frame_out_of_reach_is_refused_with_the_admissible_range() -> None:
    with pytest.raises(AssemblyError, match=r"41\.05 to 59\.99 mm or 60\.01 to 118\.1 mm") as refused:
        posed(K="1.4", CD="60 mm", swing="50 deg", AD="200 mm").solve()
    assert "41.05 至 59.99 mm 或 60.01 至 118.1 mm" in refused.value.words.zh


def test_limits_on_opposite_sides_of_the_frame_are_no_solution() -> None:
    drawn = posed(K="1.5", CD="75 mm", AD="100 mm", ADC="135 deg").solve().construction
    assert drawn.conclusion is not None and "do not lie on one side" in drawn.conclusion.en


def test_k_of_one_puts_a_on_the_line_of_the_limits() -> None:
    found = posed(K="1", CD="60 mm", swing="60 deg", BC="80 mm").solve(by="exact").answers
    assert (found["AB"].drawn, found["theta"].drawn) == pytest.approx((30.0, 0.0), abs=1e-9)
    assert not posed(K="1", CD="60 mm", swing="60 deg", AD="100 mm").solve().suspect
    for crank in ("20 mm", "30 mm"):
        with pytest.raises(AssemblyError, match=rf"AB = {crank}: .* AB = C₁C₂/2 = 30 mm with any coupler; give BC"):
            posed(K="1", CD="60 mm", swing="60 deg", AB=crank).solve()


def test_k_of_one_has_no_angle_between_the_limits_however_short_the_coupler() -> None:
    found = posed(K="1", CD="49 mm", swing="31 deg", BC="26.3 mm").solve(by="exact").answers
    assert found["theta"].exact == 0.0 and found["K"].exact == 1.0


@pytest.mark.parametrize("datum", [{}, {"AD": "70 mm", "BC": "60 mm"}, {"ADC": "30 deg", "AD": "70 mm"}])
def test_too_few_or_too_many_data_are_told(datum: dict[str, str]) -> None:
    with pytest.raises(ProblemFileError, match=r"just one of|either swing"):
        posed(K="1.4", CD="60 mm", swing="50 deg", **datum)


def test_the_best_a_stands_highest_on_the_curve_of_seven_trials() -> None:
    figures = vecpoly.solve(vecpoly.load("best-gamma"), by="exact", repeats=0).construction.figures
    curves = [figure for figure in figures if figure.name.startswith("gamma of A")]
    assert len(curves) == 2
    for figure in curves:
        places = {mark.label.rstrip("′"): mark.at for mark in figure.marks if isinstance(mark, Point)}
        trials = [places[str(n)] for n in range(1, 8)]
        assert all(
            two.real - one.real == pytest.approx(trials[1].real - trials[0].real, rel=0.02)
            for one, two in pairwise(trials)
        )
        assert places["A"].imag >= max(at.imag for at in trials)
        (curve,) = (mark for mark in figure.marks if isinstance(mark, Curve))
        assert places["A"].imag == pytest.approx(max(at.imag for at in curve.points), rel=5e-3)


CLOSE = [
    ("1.0625", "17.16 deg", "0.5 deg"),
    ("1.25", "20 deg", "2.0939 deg"),  # two of them 0.05 % of C₁C₂ from C₁, of which the closed solution knew one
    ("1.0625", "18.7 deg", "0.66246 deg"),
    ("1.0625", "24.31 deg", "0.8 deg"),
]


@pytest.mark.parametrize(("k", "swing", "gamma"), few(CLOSE, 4))
def test_every_a_is_found_that_meets_a_given_angle_close_to_the_limit(k: str, swing: str, gamma: str) -> None:
    """Two beside C₁, two beside the change point, where the curve of γ_min ends between two trials."""
    solution = vecpoly.solve(posed(K=k, CD="100 mm", swing=swing, gamma_min=gamma), by="exact", repeats=0)
    assert len(solution.construction.candidates) == 4 and not solution.suspect


@pytest.mark.parametrize("gamma", ["0.4999 deg", "0.01 deg"])
def test_a_least_angle_that_hardly_transmits_force_is_refused_with_the_admissible_range(gamma: str) -> None:
    with pytest.raises(ProblemFileError, match=rf"gamma_min = {gamma} must lie between 0.5 and 90 deg"):
        posed(K="1.0625", CD="100 mm", swing="20 deg", gamma_min=gamma)


def test_a_least_angle_out_of_reach_is_refused_from_half_a_degree_on() -> None:
    with pytest.raises(AssemblyError, match=r"admissible is gamma_min from 0\.5 to 63\.49 deg"):
        posed(K="1.0625", CD="100 mm", swing="20 deg", gamma_min="70 deg").solve()


def test_a_line_for_a_is_given_by_its_coordinate_and_a_circle_that_it_misses_is_said_to_be_missed() -> None:
    solution = vecpoly.load("K-crank-rocker-line").solve(by="exact")
    design = solution.problem.design
    assert ("y_{A}", "0 mm") in design.given()
    told = [step.words for step in solution.construction.steps if "Draw the given line" in step.words.en]
    assert [words.en.count("it meets") for words in told] == [1, 0]
    assert "与圆 $η′$ 不相交" in told[1].zh and "passes the centre at" in told[1].en


def test_a_curve_that_does_not_reach_the_given_angle_says_so() -> None:
    steps = vecpoly.solve(vecpoly.load("K-crank-rocker-gamma"), by="exact", repeats=0).construction.steps
    assert [step.section.en for step in steps if "does not reach the given value" in step.words.en] == [
        "The point $A$ on the circle $η′$ and the lengths"
    ]


@pytest.mark.parametrize(
    "data",
    [
        {"K": "1", "CD": "86 mm", "swing": "76 deg", "AD": "86 mm"},
        {"K": "1.4", "CD": "86 mm", "swing": "76 deg", "AD": "86 mm"},
        {"K": "1.83", "CD": "53 mm", "AD": "53 mm", "ADC": "140 deg"},
    ],
)
def test_where_frame_and_rocker_are_alike_a_limit_of_c_in_a_is_no_solution(data: dict[str, str]) -> None:
    solution = posed(**data).solve(by="exact")
    assert not solution.suspect
    drawn = solution.construction.candidates
    assert [one.verdict for one in drawn if abs(one.pins["A"] - one.pins["C2"]) < 1e-6] in ([], ["AT_LIMIT"] * 2)
    assert all(one.values["AB"] < one.values["BC"] - 1e-6 for one in drawn if one.reason is None)


def test_a_pivot_in_a_limit_position_is_rejected_for_that_and_the_range_told_leaves_it_out() -> None:
    """The chord is seen under no angle from there."""
    ended = posed(K="1.4", CD="60 mm", swing="50 deg", AD="60 mm").solve(by="exact").construction.conclusion
    assert ended is not None and "180° − θ" not in ended.en and "A$ coincides with $C$" in ended.en
    assert "$l_{AD}$ may be 41.05 to 118.1 mm, but not 60 mm" in ended.en


def test_a_line_for_a_along_the_chord_meets_both_circles_in_a_limit_position() -> None:
    drawn = posed(K="1.4", CD="80 mm", swing="120 deg", A="on y = 40 mm").solve(by="exact").construction.candidates
    assert [one.verdict for one in drawn] == ["AT_LIMIT"] * 2


@pytest.mark.parametrize(("k", "cd", "swing"), [("1.5", "100 mm", "60 deg"), ("1.32", "92 mm", "41 deg")])
def test_a_frame_as_long_as_the_rocker_is_concluded_upon(k: str, cd: str, swing: str) -> None:
    drawn = posed(K=k, CD=cd, swing=swing, AD=cd).solve(by="exact").construction.candidates
    assert [one.verdict for one in drawn] == ["AT_LIMIT"] * 2


def test_a_frame_that_does_not_tell_where_on_its_circle_a_is_is_refused() -> None:
    """ψ = 2θ: the circle lies about D."""
    with pytest.raises(ProblemFileError, match="every A on it will do"):
        posed(K="1.25", CD="80 mm", swing="40 deg", AD="80 mm")


@pytest.mark.parametrize(
    ("data", "k"),
    [
        ({"AD": "75 mm"}, "1.02"),
        ({"BC": "70 mm"}, "1.05"),
        ({"best": "gamma_min"}, "1.01"),
        ({"AB": "20.3 mm"}, "1.05"),
    ],
)
def test_of_a_circle_that_is_large_only_arcs_are_drawn_and_the_scale_suits_the_mechanism(
    data: dict[str, str], k: str
) -> None:
    problem = posed(K=k, CD="60 mm", swing="40 deg", **data)
    for answer in problem.solve(by="exact").answers.values():
        assert answer.drawn == pytest.approx(answer.exact, rel=1e-7), answer.key
    drafted = problem.solve(by="drafting")
    assert drafted.construction.warning is None
    sheet = drafted.construction.figures[0]
    assert sheet.scale.value <= 0.004, "mm of a mechanism of 60 mm"
    whole = [mark for mark in sheet.marks if isinstance(mark, Arc) and mark.sweep > 6 and mark.radius > 150]
    assert not whole
    crank, coupler = drafted.answers["AB"], drafted.answers["BC"]
    assert crank.expected_error < 0.03 * crank.exact
    assert "AB" in data or coupler.expected_error < 0.15 * coupler.exact  # by AB it hardly follows, as in 8-15
    told = " ".join(step.words.en for step in drafted.construction.steps)
    assert "beam compass" in told and "lies off the paper" in told


def test_a_slider_crank_of_little_advance_has_arcs_too() -> None:
    solution = vecpoly.loads("""
id: s
title: s
synthesis: slider-crank
data: {K: 1.03, H: 60 mm, e: 10 mm}
find: [theta, AB, BC, gamma_min]
""").solve(by="exact")
    for answer in solution.answers.values():
        assert answer.drawn == pytest.approx(answer.exact, rel=1e-7), answer.key
    assert solution.construction.figures[0].scale.value <= 0.002


def test_lengths_of_which_nothing_is_read_are_told_in_the_words_of_a_reader() -> None:
    """A crank of 0.01 mm."""
    solution = posed(K="1.0001", CD="60 mm", swing="0.02 deg", AD="70 mm").solve(by="drafting", seed=1)
    said = [one.broken.en for one in solution.verification if one.broken is not None]
    assert said and all(text.startswith("nothing is left of") for text in said)


def test_the_range_told_of_a_line_across_has_both_mirror_images() -> None:
    data = {"K": "1.32", "CD": "92 mm", "swing": "41 deg"}
    with pytest.raises(AssemblyError, match=r"A from -76\.73 to -21\.38 mm or 21\.38 to 76\.73 mm"):
        posed(**data, A="on x = 300 mm").solve()
    for x in ("50 mm", "-50 mm"):
        assert posed(**data, A=f"on x = {x}").solve(by="exact").construction.conclusion is None


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("best-gamma", ("取曲线上 $γ_{min}$ 最大的一点为 $A$", "for which the curve has its maximum $γ_{min}$")),
        (
            "K-crank-rocker-gamma",
            ("$γ_{min}$ 等于给定值的点为 $A′$、$A$", "$A′$ and $A$ the points for which the curve has"),
        ),
    ],
)
def test_which_point_of_the_curve_is_taken_is_said(name: str, said: tuple[str, str]) -> None:
    assert any(said[0] in step.words.zh and said[1] in step.words.en for step in drawn(name).construction.steps)


@pytest.mark.parametrize("name", ["8-15", "K-crank-rocker-gamma"])
def test_both_sides_of_the_right_triangle_over_the_chord_are_drawn(name: str) -> None:
    """P is where the ray through C₁ at 90° − θ meets the normal at C₂."""
    marks = drawn(name).construction.figures[0].marks
    at = {mark.label: mark.at for mark in marks if isinstance(mark, Point)}
    lines = [(mark.a, mark.b) for mark in marks if isinstance(mark, Segment)]
    for p in (letter for letter in ("P", "P′") if letter in at):
        for c in ("C_1", "C_2"):
            assert any(passes(line, at[p]) and passes(line, at[c]) for line in lines), (p, c)


def passes(line: tuple[complex, complex], at: complex) -> bool:
    """Whether a place lies on the line that is drawn."""
    a, b = line
    along = (b - a) / abs(b - a) if a != b else 1.0
    share = along.conjugate() * (at - a)
    return abs(share.imag) < 1e-6 and -1e-6 < share.real < abs(b - a) + 1e-6
