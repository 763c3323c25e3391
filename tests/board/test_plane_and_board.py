"""Laws of the plane, the hand and the scales."""

from __future__ import annotations

import cmath
from math import pi

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from vecpoly.board.hand import hand
from vecpoly.board.paper.scales import SERIES, round_scale, round_up
from vecpoly.errors import UnknownNameError
from vecpoly.plane import Line, circles_meet, cross, line_circle_meet, lines_meet, similar

points = st.builds(complex, st.floats(-100, 100), st.floats(-100, 100))
angles = st.floats(-pi, pi)


@given(points, points, angles, angles)
def test_lines_meet_on_both_lines(p: complex, q: complex, a: float, b: float) -> None:
    assume(abs(np.sin(a - b)) > 0.05)
    g, h = Line(p, cmath.rect(1, a)), Line(q, cmath.rect(1, b))
    x = lines_meet(g, h)
    assert np.abs(cross(g.along, x - p)) < 1e-8
    assert np.abs(cross(h.along, x - q)) < 1e-8


def test_parallel_lines_give_no_point() -> None:
    assert not np.isfinite(lines_meet(Line(0j, 1 + 0j), Line(1j, 1 + 0j)))


@given(points, points, st.floats(1, 100), st.floats(1, 100))
def test_the_first_meeting_of_two_circles_lies_left_of_the_centres(p: complex, q: complex, r: float, s: float) -> None:
    d = abs(q - p)
    assume(abs(r - s) + 0.1 < d < r + s - 0.1)
    a, b = circles_meet(p, r, q, s)
    for x in (a, b):
        assert abs(x - p) == pytest.approx(r)
        assert abs(x - q) == pytest.approx(s)
    assert cross(q - p, a - p) > 0 > cross(q - p, b - p)


def test_a_circle_out_of_reach_gives_no_point() -> None:
    assert not np.isfinite(line_circle_meet(Line(0j, 1 + 0j), 5j, 4.0)[0])


@given(points, points, points, points, points)
def test_a_similar_figure_keeps_angles_and_letter_order(
    a: complex, b: complex, c: complex, a1: complex, b1: complex
) -> None:
    assume(abs(b - a) > 1 and abs(b1 - a1) > 1 and np.abs(cross(b - a, c - a)) > 1)
    c1 = similar(a, b, c, a1, b1)
    assert np.sign(cross(b - a, c - a)) == np.sign(cross(b1 - a1, c1 - a1))
    assert np.abs(c1 - a1) / np.abs(b1 - a1) == pytest.approx(np.abs(c - a) / np.abs(b - a), rel=1e-6)


@given(st.floats(1e-6, 1e6))
def test_round_scales_come_from_the_series_and_never_fall_below(value: float) -> None:
    mu = round_up(value)
    assert value * (1 - 1e-8) <= mu < value * 2.01
    mantissa = float(f"{mu:e}".split("e")[0])
    assert any(mantissa == pytest.approx(s) for s in SERIES)


@given(st.floats(1e-4, 1e2), st.floats(1, 500), st.floats(1, 500))
def test_a_figure_at_its_round_scale_fits_its_place(scale: float, width: float, height: float) -> None:
    mu = round_scale(scale, (width, height), (150.0, 100.0))
    assert width * scale / mu <= 150 * (1 + 1e-6)
    assert height * scale / mu <= 100 * (1 + 1e-6)


def test_the_exact_hand_changes_nothing() -> None:
    it = hand("exact")
    assert it.read(12.3456789) == 12.3456789
    assert it.carry(7.25) == 7.25
    assert it.tilt(1j) == 1j


@pytest.mark.parametrize(("name", "step"), [("drafting", 0.1), ("pencil", 0.5)])
def test_readings_fall_on_the_graduation(name: str, step: float) -> None:
    it = hand(name, repeats=50)
    readings = np.asarray(it.read(np.full(51, 33.333)))
    assert np.allclose(readings / step, np.round(readings / step))
    assert readings[0] == pytest.approx(round(33.333 / step) * step)


def test_the_nominal_drafting_sheet_is_drawn_without_scatter() -> None:
    lengths = np.asarray(hand("drafting", repeats=20).carry(50.0))
    assert lengths[0] == 50.0
    assert np.ptp(lengths[1:]) > 0


def test_the_same_seed_is_the_same_hand() -> None:
    one, two = (np.asarray(hand("pencil", seed=7, repeats=9).carry(50.0)) for _ in range(2))
    assert np.array_equal(one, two)


def test_an_unknown_hand_is_refused_by_name() -> None:
    with pytest.raises(UnknownNameError, match="drafting"):
        hand("sloppy")
