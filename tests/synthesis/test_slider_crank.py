"""Slider-cranks from K: cases, laws, refusals with the range."""

from __future__ import annotations

import math
import re

import pytest

import vecpoly
from vecpoly.board.paper.marks import Point
from vecpoly.check.designs.found_words import ill_conditioned
from vecpoly.errors import AssemblyError, ProblemFileError
from vecpoly.oracle.synthesis.registry import linkages


def posed(**data: str) -> vecpoly.Problem:
    """A slider-crank with these data."""
    return vecpoly.problem({"id": "t", "title": "t", "synthesis": "slider-crank", "data": data})


@pytest.mark.parametrize(
    ("data", "true"),
    [
        (
            {"K": "1.4", "H": "100 mm", "e": "30 mm"},
            {"AB": 45.804761885, "BC": 89.989311651, "alpha_max": 57.391788404, "H": 100.0},
        ),
        (
            {"K": "1.3", "H": "120 mm", "AB": "55 mm"},
            {"AB": 55.0, "BC": 130.060696848, "e": 46.117531907, "gamma_min": 38.971019875},
        ),
        ({"K": "1.3", "H": "120 mm", "BC": "130.060696848 mm"}, {"AB": 55.0, "e": 46.117531907}),
    ],
)
def test_crank_coupler_and_pressure_angle_are_those_of_the_case(data: dict[str, str], true: dict[str, float]) -> None:
    solution = posed(**data).solve(by="exact")
    assert {key: solution.answers[key].drawn for key in true} == pytest.approx(true, rel=1e-9)
    moved = solution.verification[0]
    assert (moved.ratio, moved.stroke) == pytest.approx((float(data["K"]), float(data["H"][:3])), rel=1e-6)


def test_an_offset_beyond_the_circle_is_refused_with_its_limit() -> None:
    with pytest.raises(AssemblyError, match=r"may be at most 173\.2 mm"):
        posed(K="1.4", H="100 mm", e="190 mm").solve()


def test_a_slider_that_would_have_to_pass_under_a_is_no_solution() -> None:
    drawn = posed(K="1.4", H="100 mm", e="180 mm").solve().construction
    assert drawn.conclusion is not None and "lies between $C_1$ and $C_2$" in drawn.conclusion.en


@pytest.mark.parametrize("data", [{"AB": "49 mm"}, {"BC": "60 mm"}, {"e": "1 mm"}])
def test_a_ratio_that_is_all_but_one_keeps_its_digits(data: dict[str, str]) -> None:
    design = posed(K="1.000000001", H="100 mm", **data).design
    (one,) = linkages(design)
    a, b, theta = one.values["AB"], one.values["BC"], math.radians(one.values["theta"])
    assert (2 * a * math.cos(theta / 2)) ** 2 + (2 * b * math.sin(theta / 2)) ** 2 == pytest.approx(1e4, rel=1e-12)


def test_a_central_slider_crank_has_no_quick_return() -> None:
    with pytest.raises(ProblemFileError, match="K > 1 is needed"):
        posed(K="1", H="100 mm", e="10 mm")


def test_an_offset_that_hardly_follows_from_the_drawing_is_told_by_its_own_symbol() -> None:
    (one,) = posed(K="1.4", H="60 mm", AB="28 mm").solve().verification
    told = ill_conditioned(one, True)
    assert "e" in one.loose and told is not None and "、$e$ 的" in told.zh and "l_{e}" not in told.en


@pytest.mark.parametrize("name", ["K-slider-crank-AB", "K-slider-crank-BC"])
def test_an_offset_that_is_sought_is_measured_to_a_foot_with_a_letter(name: str) -> None:
    figure = vecpoly.load(name).solve(by="exact").construction.figures[0]
    places = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
    a, n, c1, c2 = (places[letter] for letter in ("A", "N", "C_1", "C_2"))
    assert n.imag == pytest.approx(c1.imag, abs=1e-9) and n.real == pytest.approx(a.real, abs=1e-9)
    assert n.real < c1.real < c2.real


@pytest.mark.parametrize(
    ("key", "beyond", "rejected", "told"),
    [
        ("e", "200 mm", "140 mm", "at most 138.1 mm"),
        ("AB", "40 mm", "6 mm", "6.235 to 29.99 mm"),
        ("BC", "20 mm", "147 mm", "30.01 to 144.3 mm"),
        ("BC", "148 mm", "145 mm", "30.01 to 144.3 mm"),
    ],
)
def test_what_meets_nothing_and_what_is_rejected_are_told_the_same_range(
    key: str, beyond: str, rejected: str, told: str
) -> None:
    with pytest.raises(AssemblyError, match=rf"{key} may be {re.escape(told)}"):
        posed(K="1.3", H="60 mm", **{key: beyond}).solve()
    ended = posed(K="1.3", H="60 mm", **{key: rejected}).solve(by="exact").construction.conclusion
    symbol = {"e": "e"}.get(key, f"l_{{{key}}}")
    assert ended is not None and f"${symbol}$ may be {told}" in ended.en


@pytest.mark.parametrize("k", ["3", "3.5"])
def test_a_ratio_that_no_slider_crank_has_is_refused(k: str) -> None:
    """θ of 90° or more: e < H cot θ would have to be negative."""
    with pytest.raises(ProblemFileError, match="K < 3 is needed"):
        posed(K=k, H="60 mm", e="10 mm")
