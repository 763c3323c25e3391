"""Straight lines by coupler points: known bands, and laws of the path."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vecpoly
from tests.drawn_library import drawn
from tests.laws import often
from tests.synthesis.inversion import posed, solved
from vecpoly.board.paper.marks import Curve, Passing, Point
from vecpoly.designs.straight_line import StraightLine
from vecpoly.errors import ProblemFileError

KNOWN = ["straight-chebyshev", "straight-roberts", "straight-hoecken"]


@pytest.mark.parametrize(
    ("name", "length", "band"),
    [
        ("straight-chebyshev", 80.0, 0.195074662),  # E from above A to above D, by symmetry
        ("straight-roberts", 60.0, 0.603786662),
        ("straight-hoecken", 80.0, 0.195074662),  # a cognate of Chebyshev's: the same curve
    ],
)
def test_the_straight_part_is_as_long_and_its_band_as_wide_as_is_known(name: str, length: float, band: float) -> None:
    solution = solved(vecpoly.load(name))
    assert solution.answers["L"].drawn == pytest.approx(length, abs=1e-8)
    assert solution.answers["delta"].drawn == pytest.approx(band, abs=1e-8)
    assert solution.answers["delta"].exact == pytest.approx(band, abs=1e-8)


@pytest.mark.parametrize("name", KNOWN)
def test_the_places_of_e_are_equally_far_apart_whatever_ab_turns_between_them(name: str) -> None:
    figure = solved(vecpoly.load(name)).construction.figures[0]
    places = [mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label.startswith("E_")]
    steps = [abs(b - a) for a, b in pairwise(places)]
    assert len(places) == 9 and max(steps) - min(steps) < 0.02 * max(steps)


@pytest.mark.parametrize("name", KNOWN)
def test_the_curve_of_deviations_of_a_symmetrical_path_is_symmetrical(name: str) -> None:
    figure = solved(vecpoly.load(name)).construction.figures[1]
    (curve,) = (mark for mark in figure.marks if isinstance(mark, Curve))
    x, y = np.real(curve.points), np.imag(curve.points)
    order = np.argsort(x)
    mirrored = np.interp(x.min() + x.max() - x[order], x[order], y[order])
    assert np.abs(mirrored - y[order]).max() < 0.05


def test_heights_too_small_to_be_read_off_the_drawing_are_said_to_be_computed() -> None:
    told = drawn("straight-chebyshev").construction.steps[1].words
    assert "0.24 mm" in told.en and "computed" in told.en and "由计算求得" in told.zh


@pytest.mark.parametrize("name", KNOWN)
def test_it_is_said_that_readings_off_computed_points_check_the_plotting_alone(name: str) -> None:
    told = drawn(name).construction.steps[1].words
    assert "plotting and reading alone" in told.en and "只检验画图和读数" in told.zh


@pytest.mark.parametrize(("name", "past"), [("straight-hoecken", ["C"]), ("straight-roberts", []), (KNOWN[0], [])])
def test_the_coupler_runs_on_past_a_pin_only_where_it_is_produced_to_e(name: str, past: list[str]) -> None:
    marks = drawn(name).construction.figures[0].marks
    pins = {mark.at: mark.label for mark in marks if isinstance(mark, Point)}
    assert [pins[mark.at] for mark in marks if isinstance(mark, Passing)] == past


def test_a_length_that_is_a_whole_number_of_divisions_is_a_reading_too() -> None:
    assert not any(one.computed for one in vecpoly.load("straight-roberts").solve().answers.values())


def test_at_a_dead_point_the_arcs_only_touch_and_c_is_laid_off_in_line() -> None:
    design = vecpoly.load("straight-chebyshev").subject
    assert isinstance(design, StraightLine)
    assert [design.dead(end.si) for end in design.phi] == [True, False]
    assert "$φ_1$ 为死点" in drawn("straight-chebyshev").construction.steps[0].words.zh


def test_a_range_in_which_the_links_do_not_reach_is_refused_with_the_distances() -> None:
    data = {"AB": "60 mm", "BC": "20 mm", "CD": "30 mm", "AD": "100 mm", "E": ["5 mm", "5 mm"]}
    with pytest.raises(ProblemFileError, match=r"BD = 116\.619 mm"):
        posed("straight-line", **data, phi=["10 deg", "90 deg"])


@settings(max_examples=often(4))
@given(
    lengths=st.tuples(st.floats(20, 40), st.floats(70, 100), st.floats(70, 100), st.floats(70, 100)),
    e=st.tuples(st.floats(-80, 80), st.floats(-80, 80)),
    phi=st.floats(0, 300),
    side=st.sampled_from(["left", "right"]),
)
def test_the_band_holds_every_point_of_the_path_and_no_narrower_one_does(
    lengths: tuple[float, ...], e: tuple[float, float], phi: float, side: str
) -> None:
    names = ("AB", "BC", "CD", "AD")
    data = {key: f"{value!r} mm" for key, value in zip(names, lengths, strict=True)}
    point = [f"{part!r} mm" for part in e]
    solution = solved(posed("straight-line", **data, E=point, side=side, phi=[f"{phi!r} deg", f"{phi + 50!r} deg"]))
    assert not solution.suspect
    a, b, c, d = lengths
    pin = a * np.exp(1j * np.radians(np.linspace(phi, phi + 50, 2001)))
    base = d - pin
    at_b = np.arccos((np.abs(base) ** 2 + b * b - c * c) / (2 * np.abs(base) * b))
    way = base / np.abs(base) * np.exp((1j if side == "left" else -1j) * at_b)
    path = pin + complex(*e) * way
    assert solution.answers["L"].drawn == pytest.approx(np.ptp(path.real), abs=1e-3)
    assert solution.answers["delta"].drawn == pytest.approx(np.ptp(path.imag), abs=1e-3)
    assert solution.answers["delta"].drawn >= np.ptp(path.imag) - 1e-9
