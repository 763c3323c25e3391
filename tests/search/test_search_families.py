"""Families of four-bars agree with the general solver, member by member."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.cycle import cycle
from vecpoly.oracle.families import FourBars, circles, hinge
from vecpoly.problem.values.made import problem
from vecpoly.search.dwell import DwellSearch
from vecpoly.search.four_bar import coupler
from vecpoly.search.path import PathSearch
from vecpoly.search.run import candidates
from vecpoly.search.transmission import TransmissionSearch

ELLIPSE = tuple(complex(0.06 * np.cos(t), 0.025 * np.sin(t)) for t in np.linspace(0, 2 * np.pi, 12, endpoint=False))
PATH = PathSearch(points=ELLIPSE, closed=True, gamma=0.4)
DWELL = DwellSearch(dwell=2.0, swing=0.5, crank=0.03, gamma=0.5)
BEST = TransmissionSearch(ratio=1.3, swing=(0.5, 1.0), rocker=0.1)
SEEDS = st.integers(0, 10_000)


@given(SEEDS)
def test_the_coupler_point_runs_where_the_general_solver_has_it(seed: int) -> None:
    x = candidates(PATH, 1, np.random.default_rng(seed))
    found = cycle(problem({"id": "one", "title": "one", **PATH.built(x[0])}), 13)
    alpha, at = PATH._placed(x[0])
    ours = at + alpha * coupler(x, np.exp(1j * (found.phi - np.angle(alpha))))[0]
    assert np.abs(np.asarray(found.column("p_E")) - ours).max() < 1e-4 * abs(alpha) * 10  # written to 0.001 mm


@given(SEEDS)
def test_the_output_of_the_six_bar_swings_as_the_general_solver_has_it(seed: int) -> None:
    x = candidates(DWELL, 400, np.random.default_rng(seed))
    good = np.argsort(DWELL.score(x))[:1]
    for row in x[good]:
        assert np.isfinite(DWELL.score(row[None, :])).all()
        ripple, swing, gamma, _ = (float(one[0]) for one in DWELL._output(row[None, :]))
        built = problem({"id": "a", "title": "a", **DWELL.built(row)})
        told = {one.name.en: one.value for one in DWELL.measured(built)}
        turn = cycle(built, 721)
        least = np.arcsin(np.abs(np.sin(turn.real("phi_4") - turn.real("phi_5"))).min())
        assert least - 1e-3 < gamma < least + 0.1
        assert told["worst off the dwell"] == pytest.approx(ripple / 2, rel=0.05, abs=0.02)
        assert told["swing"] == pytest.approx(swing, rel=0.02, abs=0.05)


@given(SEEDS)
def test_the_crank_rocker_has_the_k_and_the_angle_that_its_score_says(seed: int) -> None:
    x = candidates(BEST, 1, np.random.default_rng(seed))[0]
    told = {one.name.en: one.value for one in BEST.measured(problem({"id": "a", "title": "a", **BEST.built(x)}))}
    assert told["minimum transmission angle"] == pytest.approx(-np.degrees(BEST.score(x[None, :])[0]), abs=0.05)
    assert told["time ratio K"] == pytest.approx(1.3, abs=2e-3)
    assert told["swing"] == pytest.approx(np.degrees(x[0]), abs=0.05)


@given(SEEDS)
def test_the_least_transmission_angle_is_that_of_a_whole_turn(seed: int) -> None:
    x = candidates(PATH, 1, np.random.default_rng(seed))
    bars = FourBars(b=x[:, 0], c=x[:, 1], d=x[:, 2], side=np.ones(1))
    reach = np.abs(bars.d - np.exp(1j * np.linspace(0, 2 * np.pi, 721)))
    mu = np.arccos((bars.b**2 + bars.c**2 - reach**2) / (2 * bars.b * bars.c))
    assert bars.least_angle[0] == pytest.approx(np.minimum(mu, np.pi - mu).min(), abs=1e-9)


@given(st.floats(0.1, 5), st.floats(-3, 3), st.floats(-3, 3), st.floats(0.3, 6))
def test_the_circle_through_points_of_a_circle_is_that_circle(r: float, x: float, y: float, arc: float) -> None:
    centre, radius = circles(complex(x, y) + r * np.exp(1j * np.linspace(0, arc, 9))[None, :])
    assert centre[0] == pytest.approx(complex(x, y), abs=1e-6) and radius[0] == pytest.approx(r, rel=1e-6)


@given(st.floats(0.6, 2), st.floats(0.6, 2), st.sampled_from([-1.0, 1.0]))
def test_a_hinge_has_its_distances_and_its_side(p: float, q: float, side: float) -> None:
    met = hinge(np.zeros((1, 1), complex), np.ones((1, 1), complex), np.array([p]), np.array([q]), np.array([side]))[
        0, 0
    ]
    if np.isfinite(met):
        assert abs(met) == pytest.approx(p) and abs(met - 1) == pytest.approx(q)
        assert met.imag * side >= 0


@given(SEEDS, st.floats(0.01, 10), st.floats(0, 6.3), st.floats(-1, 1), st.booleans())
def test_a_curve_is_as_far_from_a_linkage_however_it_lies(
    seed: int, size: float, turn: float, shift: float, back: bool
) -> None:
    points = tuple(shift + size * np.exp(1j * turn) * z for z in (ELLIPSE[:1] + ELLIPSE[:0:-1] if back else ELLIPSE))
    x = candidates(PATH, 3, np.random.default_rng(seed))
    moved = PathSearch(points=points, closed=True, gamma=0.4)
    assert moved.score(x) == pytest.approx(PATH.score(x), rel=1e-6, abs=1e-9)


@given(SEEDS)
def test_no_linkage_is_as_near_to_a_coupler_curve_as_its_own(seed: int) -> None:
    random = np.random.default_rng(seed)
    x = candidates(PATH, 1, random)
    curve = coupler(x, np.exp(1j * np.linspace(0, 2 * np.pi, 240, endpoint=False))[None, :])[0]
    own = PathSearch(points=tuple(complex(z) for z in curve), closed=True, gamma=0.4)
    x[:, 6] = 0.0  # it begins where the points do
    assert own.score(x)[0] < 0.03
    assert own.score(x)[0] < own.score(candidates(PATH, 100, random)).min()
