"""Laws of synthesis: what is drawn moves as it should, nothing that a search finds is missing, mirrors mirror."""

from __future__ import annotations

from math import cos, pi, radians, sin

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import vecpoly
from tests.laws import often, soaking
from vecpoly.errors import AssemblyError, DeadPointError
from vecpoly.solution import REPEATS

Angles = npt.NDArray[np.float64]
ratios, swings = st.floats(1.05, 1.9), st.floats(20, 90)


def posed(kind: str, **data: str) -> vecpoly.Problem:
    """A task of synthesis with these data."""
    return vecpoly.problem({"id": "t", "title": "t", "synthesis": kind, "data": data})


def solutions(problem: vecpoly.Problem) -> list[dict[str, float]]:
    """The valid solutions by the exact hand; none where the data are refused."""
    try:
        solution = vecpoly.solve(problem, by="exact", repeats=REPEATS if soaking() else 0)
    except (AssemblyError, DeadPointError):
        return []
    assert not solution.suspect
    return [dict(one.values) for one in solution.construction.candidates if one.reason is None]


def rocker(ab: float, bc: float, cd: float, ad: float, phi: Angles) -> Angles:
    """The rocker's angle over the crank's, C always on the left of BD, by the law of cosines."""
    base = ad - ab * np.exp(1j * phi)
    at_d = np.arccos((np.abs(base) ** 2 + cd**2 - bc**2) / (2 * np.abs(base) * cd))
    return np.unwrap(np.angle(-base) - at_d)


@settings(max_examples=often(4))
@given(k=ratios, swing=swings, share=st.floats(0.1, 0.95))
def test_every_drawn_crank_rocker_swings_and_returns_as_it_is_asked_to(k: float, swing: float, share: float) -> None:
    crank = share * 100 * sin(radians(swing) / 2)
    phi = np.linspace(0, 2 * pi, 7201)
    for one in solutions(posed("crank-rocker", K=f"{k}", CD="100 mm", swing=f"{swing} deg", AB=f"{crank} mm")):
        psi = rocker(one["AB"], one["BC"], one["CD"], one["AD"], phi)
        assert np.degrees(np.ptp(psi)) == pytest.approx(swing, abs=0.01)
        way = (phi[psi.argmax()] - phi[psi.argmin()]) % (2 * pi)
        assert max(way, 2 * pi - way) / min(way, 2 * pi - way) == pytest.approx(k, rel=0.02)


@settings(max_examples=often(4))
@given(k=ratios, swing=swings, frame=st.floats(30, 250))
def test_nothing_that_a_search_along_the_circle_of_ad_finds_is_missing(k: float, swing: float, frame: float) -> None:
    theta, half = pi * (k - 1) / (k + 1), radians(swing) / 2
    c1, c2 = (100 * complex(-sin(half), cos(half)), 100 * complex(sin(half), cos(half)))
    a = frame * np.exp(1j * np.linspace(pi / 2, 3 * pi / 2, 20001)[1:-1])
    seen = np.abs(np.angle((c2 - a) / (c1 - a))) - theta
    sides = np.imag(np.conj(-a) * (c1 - a)) * np.imag(np.conj(-a) * (c2 - a))
    found = np.count_nonzero((seen[1:] * seen[:-1] < 0) & (np.minimum(sides[1:], sides[:-1]) > 0))
    assume(np.abs(seen).min() < 1e-3 or np.abs(seen).min() > 2e-2)  # a touching is one for neither
    drawn = solutions(posed("crank-rocker", K=f"{k}", CD="100 mm", swing=f"{swing} deg", AD=f"{frame} mm"))
    assert len(drawn) == found


@given(k=ratios, stroke=st.floats(40, 200), share=st.floats(0.05, 0.9))
def test_every_drawn_slider_crank_has_its_stroke_and_its_ratio(k: float, stroke: float, share: float) -> None:
    theta = pi * (k - 1) / (k + 1)
    offset = share * stroke * cos(theta) / sin(theta)
    found = solutions(posed("slider-crank", K=f"{k}", H=f"{stroke} mm", e=f"{offset} mm"))
    assert len(found) == 1
    ab, bc = found[0]["AB"], found[0]["BC"]
    far, near = ((ab + bc) ** 2 - offset**2) ** 0.5, ((bc - ab) ** 2 - offset**2) ** 0.5
    assert far - near == pytest.approx(stroke, rel=1e-8)
    assert abs(np.angle((far - 1j * offset) / (near - 1j * offset))) == pytest.approx(theta, rel=1e-7)


@settings(max_examples=often(4))
@given(first=st.floats(200, 320), second=st.floats(200, 320), alpha=st.floats(5, 70), x=st.floats(20, 60))
def test_mirrored_limit_lines_give_the_same_lengths(first: float, second: float, alpha: float, x: float) -> None:
    assume(abs(first - second) > 3)
    one, other = (
        posed(
            "limit-lines",
            C1="(0, 0) mm",
            C2=f"({way * x}, 11) mm",
            line_1=f"{90 + way * (first - 90)} deg",
            line_2=f"{90 + way * (second - 90)} deg",
            alpha_1=f"{alpha} deg",
        )
        for way in (1, -1)
    )
    here, there = solutions(one), solutions(other)
    assert len(here) == len(there)
    for mine, its in zip(here, there, strict=True):
        assert mine == pytest.approx(its, rel=1e-6)


@settings(max_examples=often(1, 80))
@given(k=ratios, swing=swings)
def test_no_other_crank_on_the_circles_transmits_better_than_the_best(k: float, swing: float) -> None:
    theta, chord = pi * (k - 1) / (k + 1), 200 * sin(radians(swing) / 2)
    found = solutions(posed("crank-rocker", K=f"{k}", CD="100 mm", swing=f"{swing} deg", best="gamma_min"))
    best = max((one["gamma_min"] for one in found), default=0.0)
    a = np.linspace(0, chord / 2, 402)[1:-1]
    b = np.sqrt((chord**2 - 2 * a**2 * (1 + cos(theta))) / (2 * (1 - cos(theta))))
    for side in (-1, 1):
        x = -2 * a * b / chord
        y = 100 * cos(radians(swing) / 2) + side * np.sqrt(np.maximum((b - a) ** 2 - (x + chord / 2) ** 2, 0))
        d = np.hypot(x, y)
        usable = (y * chord / 2 - x * 100 * cos(radians(swing) / 2) > 0) == (
            -y * chord / 2 - x * 100 * cos(radians(swing) / 2) > 0
        )
        gamma = np.min([_acute((b**2 + 100**2 - (d + way * a) ** 2) / (200 * b)) for way in (-1, 1)], axis=0)
        assert not found or np.max(gamma[usable], initial=0.0) <= best + 1e-6


def _acute(cosine: Angles) -> Angles:
    """The angle, or its supplement, in degrees."""
    angle = np.degrees(np.arccos(np.clip(cosine, -1, 1)))
    return np.asarray(np.minimum(angle, 180 - angle))
