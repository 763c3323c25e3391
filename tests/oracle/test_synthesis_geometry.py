"""Circles through places, poles and the centre points of four positions, against laws and a search that knows none."""

from __future__ import annotations

import cmath
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.optimize import root

from vecpoly.oracle.synthesis.inversion.burmester import CentrePoint, centre_points, circle_points, determinant
from vecpoly.oracle.synthesis.inversion.cognates import Fourbar, cognates, third_pivot
from vecpoly.oracle.synthesis.inversion.loci import Round, Still, Straight, equidistant, locus
from vecpoly.oracle.synthesis.inversion.motions import Pose, inverted, pole

SPOT = st.builds(complex, *(2 * [st.floats(-100, 100).map(lambda x: round(x, 3))]))
POSE = st.builds(Pose.turned, SPOT, st.floats(-3, 3).map(lambda x: round(x, 3)))
FOUR = tuple(Pose.turned(at, np.radians(deg)) for at, deg in ((0j, 0), (13 + 19j, 24), (42 + 28j, 35), (83 + 15j, 54)))


@given(SPOT, SPOT, SPOT)
def test_a_circle_through_three_places_has_one_distance_from_each(one: complex, two: complex, three: complex) -> None:
    found = locus((one, two, three))
    assume(isinstance(found, Round) and found.radius < 1e4)
    assert isinstance(found, Round)
    assert [abs(at - found.centre) for at in (one, two, three)] == pytest.approx(3 * [found.radius], rel=1e-7)


def test_places_in_a_row_have_no_centre_and_a_place_met_twice_has_too_many() -> None:
    assert locus((0j, 30 + 0j, 70 + 0j)) == Straight(through=0j, along=1 + 0j)
    assert locus((1j, 1j, 5 + 0j)) == Still(at=1j)


@given(SPOT, SPOT, SPOT, st.floats(0, 3))
def test_the_point_of_a_line_is_as_far_from_both_places(one: complex, two: complex, on: complex, angle: float) -> None:
    along = cmath.exp(1j * angle)
    at = equidistant(one, two, on, along)
    assume(at is not None and abs(at) < 1e5)
    assert at is not None
    assert abs(at - one) == pytest.approx(abs(at - two), rel=1e-9, abs=1e-7)
    assert ((at - on) / along).imag == pytest.approx(0, abs=1e-6)


def test_a_line_along_the_bisector_has_no_point_of_its_own() -> None:
    assert equidistant(-1 + 0j, 1 + 0j, 0j, 1j) is None
    assert equidistant(1 + 1j, 1 + 1j, 0j, 1 + 0j) is None


@given(POSE, POSE)
def test_the_pole_lies_at_one_place_in_both_positions(one: Pose, two: Pose) -> None:
    at = pole(one, two)
    assume(at is not None and abs(at) < 1e5)
    assert at is not None
    assert two.place(one.trace(at)) == pytest.approx(at, abs=1e-6)


def test_a_body_that_is_only_shifted_has_no_pole() -> None:
    assert pole(Pose.turned(0j, 0.3), Pose.turned(5 + 2j, 0.3)) is None


def test_inversion_keeps_the_distance_between_the_two_bodies() -> None:
    fixed, moving = 7 - 50j, 3 + 4j
    seen = inverted((fixed,) * 4, FOUR, 2)
    stood = FOUR[2].place(moving)
    assert [abs(at - stood) for at in seen] == pytest.approx([abs(pose.place(moving) - fixed) for pose in FOUR])


def _searched(through: complex, along: complex) -> list[complex]:
    """Centre points by Newton's method from many starts: |B_i A| is one length; it knows no determinant."""

    def off(x: np.ndarray) -> list[float]:
        lengths = [abs(pose.place(complex(x[1], x[2])) - through - x[0] * along) for pose in FOUR]
        return [b - a for a, b in pairwise(lengths)]

    found: list[complex] = []
    draw = np.random.default_rng(3)
    for start in draw.uniform(-200, 200, (120, 3)):
        end = root(off, start, tol=1e-12)
        at = complex(through + end.x[0] * along)
        if end.success and max(map(abs, off(end.x))) < 1e-9 and abs(at) < 1e3 and np.hypot(*end.x[1:]) < 1e3:
            found += [at] if all(abs(at - other) > 1e-5 for other in found) else []
    return sorted(found, key=lambda at: at.real)


def test_every_centre_point_of_a_search_from_many_starts_is_among_the_roots_of_the_cubic() -> None:
    found = centre_points(FOUR, -50j, 1 + 0j)
    assert [point.fixed for point in found] == pytest.approx(_searched(-50j, 1 + 0j), abs=1e-5)
    assert [point.fixed.real for point in found] == pytest.approx([-9.961602235, 127.06432641, 166.493936557], abs=1e-8)
    assert [point.radius for point in found] == pytest.approx([73.414998771, 83.618632767, 99.599011142], abs=1e-8)


def test_the_circle_point_goes_round_its_centre_point_in_all_four_positions() -> None:
    for point in centre_points(FOUR, -50j, cmath.exp(0.2j)):
        assert _spread(point) < 1e-9


def test_a_centre_point_far_out_on_its_line_is_found_as_well_as_a_near_one() -> None:
    """In metres, lines of the frame beside each other: most of their third centre points lie far from the body."""
    turned = ((0j, 0), (0.007 - 0.022j, 13), (0.055 - 0.029j, 25), (0.083 - 0.010j, 72))
    four = tuple(Pose.turned(at, np.radians(deg)) for at, deg in turned)
    found = [point for x in range(-80, 80) for point in centre_points(four, x * 1e-3 + 0j, 1j)]
    assert max(_spread(point, four) / point.radius for point in found) < 1e-9
    assert max(abs(point.fixed) for point in found) > 0.5


def _spread(point: CentrePoint, poses: tuple[Pose, ...] = FOUR) -> float:
    return float(np.ptp([abs(pose.place(poses[0].trace(point.moving)) - point.fixed) for pose in poses]))


def test_circle_points_on_a_line_of_the_body_are_found_by_the_same_cubic_in_the_body() -> None:
    centre = centre_points(FOUR, -50j, 1 + 0j)[0]
    found = circle_points(FOUR, centre.moving, 1j)
    assert any(abs(point.fixed - centre.fixed) < 1e-8 for point in found)
    assert max(_spread(point) for point in found) < 1e-8


def test_the_six_poles_lie_on_the_curve_of_centre_points() -> None:
    off = 1e4 * abs(determinant(FOUR, 20 - 50j))
    poles = [pole(FOUR[i], FOUR[j]) for i in range(4) for j in range(i)]
    assert all(at is not None and abs(determinant(FOUR, at)) < 1e-9 * off for at in poles)


def test_cognates_have_the_lengths_of_robertss_figure() -> None:
    bar = _fourbar(0.7)
    left, right = cognates(bar)
    k = abs(bar.shape), abs(1 - bar.shape)
    a, b, c, d = bar.lengths
    assert left.lengths == pytest.approx((k[0] * b, k[0] * a, k[0] * c, k[0] * d))
    assert right.lengths == pytest.approx((k[1] * b, k[1] * c, k[1] * a, k[1] * d))


def test_a_cognate_drawn_by_itself_leads_its_point_along_the_same_curve() -> None:
    first = cognates(_fourbar(0.4))
    for phi in np.linspace(0, 2 * np.pi, 19):
        bar = _fourbar(float(phi))
        assert third_pivot(bar) == pytest.approx(43.87755102 + 36.606920642j, abs=1e-6)
        for start, now in zip(first, cognates(bar), strict=True):
            assert now.lengths == pytest.approx(start.lengths, rel=1e-9)
            assert now.shape == pytest.approx(start.shape, rel=1e-9)


def _fourbar(phi: float) -> Fourbar:
    """AB 30, BC 70, CD 60, AD 80, C left of BD, with a coupler point, at this angle of the crank."""
    b = 30 * cmath.exp(1j * phi)
    span = 80 - b
    along = (abs(span) ** 2 + 70**2 - 60**2) / (2 * abs(span))
    c = b + span / abs(span) * complex(along, np.sqrt(70**2 - along**2))
    return Fourbar(a=0j, b=b, c=c, d=80 + 0j, e=b + (0.548469388 + 0.457586508j) * (c - b))
