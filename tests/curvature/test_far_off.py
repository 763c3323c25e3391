"""Points that lie far off are found on a second figure, at a smaller scale; what no figure holds is refused with its
distance, and the positions that are recommended are drawn."""

from __future__ import annotations

import numpy as np
import pytest

import vecpoly
from tests.curvature.linkages import DATA, case_problem
from tests.laws import often
from vecpoly.board.construction import View
from vecpoly.board.paper.extent import bounds
from vecpoly.board.paper.marks import Arc, Point
from vecpoly.errors import NotAskedError, VecpolyError

WAYS = ("bobillier", "euler-savary", "hartmann")
FIND = "[P_24, W_2, Wr_2, delta_2, p_OE, rho_E]"


def four_bar(
    lengths: tuple[float, float, float, float],
    phi: float,
    way: str,
    point: tuple[float, float] = (45, 30),
    find: str = FIND,
    side: str = "left",
) -> vecpoly.Problem:
    """AB, BC, CD, AD in mm; a point of the coupler along and to the left of BC."""
    ab, bc, cd, ad = lengths
    return vecpoly.loads(f"""
id: far
title: far
frame: {{A: [0 mm, 0 mm], D: [{ad} mm, 0 mm]}}
links: {{1: {{AB: {ab} mm}}, 2: {{BC: {bc} mm, E: {{along: BC, at: {point[0]} mm, left: {point[1]} mm}}}},
  3: {{DC: {cd} mm}}}}
input: {{link: 1, phi: {phi} deg, omega: ccw}}
branch: [C {side} of BD]
method: curvature
construction: {way}
find: {find}
""")


FAR_W = ((40.0, 90.0, 70.0, 100.0), 75.0)
FAR_POLE = ((40.0, 90.0, 70.0, 100.0), 120.0)


def figures(solution: vecpoly.Solution) -> dict[str, tuple[complex, complex]]:
    """How much paper each figure takes, by its name (mm)."""
    return {one.name: bounds(one.marks) for one in solution.construction.figures}


@pytest.mark.parametrize("way", WAYS)
def test_a_circle_far_off_is_drawn_to_a_smaller_scale_and_the_mechanism_stays_large(way: str) -> None:
    solution = four_bar(*FAR_W, way).solve(by="exact")
    for key, answer in solution.answers.items():
        assert answer.drawn == pytest.approx(answer.exact, rel=1e-9), key
    near, far = sorted(solution.construction.figures, key=lambda one: one.scale.value)
    assert far.name == "curvature-far" and far.scale.value > 2 * near.scale.value
    low, high = bounds(far.marks)
    assert max((high - low).real, (high - low).imag) < 280
    drawn = [mark.radius * far.scale.value for mark in far.marks if isinstance(mark, Arc)]
    assert 2 * max(drawn) == pytest.approx(solution.answers["delta_2"].exact, rel=1e-9)
    letters = {mark.label for mark in far.marks if isinstance(mark, Point)}
    assert {"P_{24}", "W_{2}"} <= letters and "W_{2}" not in {m.label for m in near.marks if isinstance(m, Point)}


def test_what_is_found_on_which_figure_is_told_with_its_scale() -> None:
    solution = four_bar(*FAR_W, "bobillier").solve()
    far = next(one for one in solution.construction.figures if one.name == "curvature-far")
    told = [step.words for step in solution.construction.steps if "off the paper" in step.words.en]
    assert len(told) == 1 and "$W_{2}$" in told[0].en and f"{far.scale.value:g} m/mm" in told[0].en
    assert "落在图外" in told[0].zh and solution.construction.readings["delta_2"].scale == far.scale.symbol


def test_what_fits_one_figure_with_a_mechanism_that_can_be_read_stays_on_one() -> None:
    solution = four_bar((40, 90, 70, 100), 20, "euler-savary", find="[P_24, W_2, delta_2]").solve()
    assert [one.name for one in solution.construction.figures] == [""]


def test_an_axis_to_a_meeting_point_far_off_is_found_beside_it() -> None:
    """BC and AD all but parallel: two similar triangles in place of Q."""
    solution = four_bar((40, 100, 45, 90), 75, "bobillier").solve(by="exact")
    assert "S" in {m.label for one in solution.construction.figures for m in one.marks if isinstance(m, Point)}
    assert "Q" not in {m.label for one in solution.construction.figures for m in one.marks if isinstance(m, Point)}
    for key, answer in solution.answers.items():
        assert answer.drawn == pytest.approx(answer.exact, rel=1e-8), key


def test_balls_point_alone_is_drawn_where_the_pole_and_the_circle_are() -> None:
    problem = four_bar((60, 50, 70, 25), 120, "euler-savary", (25, 25), "[U_2]")
    answer = problem.solve(by="exact").answers["U_2"]
    assert answer.drawn == pytest.approx(answer.exact, rel=1e-9)


def test_a_slider_crank_with_its_circle_far_off_is_drawn() -> None:
    case = next(one for one in DATA["links"] if one["id"] == "B-sc-offpaper")
    for way in (*WAYS, "aronhold"):
        answers = case_problem(case, way).solve(by="exact").answers
        assert all(answer.drawn == pytest.approx(answer.exact, rel=1e-9) for answer in answers.values()), way


@pytest.mark.parametrize("way", WAYS)
def test_what_no_figure_holds_is_refused_with_its_distance_and_positions_that_are_drawn(way: str) -> None:
    with pytest.raises(NotAskedError, match=r"lies \d+ times as far .* φ from .*° would do") as refused:
        four_bar(*FAR_POLE, way).solve()
    low, high = (float(refused.value.numbers[end]) for end in ("from", "to"))
    assert not low <= FAR_POLE[1] <= high
    for phi in (low, (low + high) / 2, high):
        four_bar(FAR_POLE[0], phi, way).solve()


def random_four_bar(rng: np.random.Generator, way: str, phi: float | None = None) -> vecpoly.Problem:
    """An ordinary crank-rocker, double crank or double rocker in any position."""
    while True:
        bc, cd, ad = (int(one) for one in rng.integers(50, 130, 3))
        lengths = (int(rng.integers(20, 60)), bc, cd, ad)
        rank = sorted(lengths)
        if rank[0] + rank[3] < rank[1] + rank[2] - 5:
            break
    point = int(rng.integers(-20, 100)), int(rng.integers(-50, 50))
    side, there = str(rng.choice(["left", "right"])), int(rng.integers(0, 360))
    return four_bar(lengths, there if phi is None else phi, way, point, side=side)


@pytest.mark.parametrize("way", WAYS)
def test_of_ordinary_positions_few_are_refused_and_what_is_recommended_is_drawn(way: str) -> None:
    refused, count = 0, often(12) * 2
    for seed in range(count):
        try:
            random_four_bar(np.random.default_rng(seed), way).solve()
        except VecpolyError as error:
            assert error.code == "off-the-sheet", error
            refused += 1
            for end in ("from", "to") if error.numbers else ():
                random_four_bar(np.random.default_rng(seed), way, float(error.numbers[end])).solve()
    assert refused <= 0.2 * count


def test_a_report_has_both_figures(tmp_path: pytest.TempPathFactory) -> None:
    solution = four_bar(*FAR_W, "hartmann").solve()
    assert View.MECHANISM in {one.view for one in solution.construction.figures}
    assert solution.report(f"{tmp_path}/far.pdf", lang="en").stat().st_size > 10_000
