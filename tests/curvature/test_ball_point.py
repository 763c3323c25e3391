"""Ball's point: the cases, the laws of its path, and where there is none."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings

import vecpoly
from tests.at_once import exactly
from tests.curvature.linkages import DATA, WAYS, case_problem
from tests.curvature.test_curvature_laws import linkages
from tests.laws import often
from vecpoly.check.alarm import Cause
from vecpoly.check.truth import exact_values
from vecpoly.errors import NoMethodError, NotAskedError, VecpolyError
from vecpoly.oracle.curvature import Curvatures

BALLS = [case for case in DATA["links"] if "ball" in case]
CHEBYSHEV = """
id: chebyshev
title: Chebyshev's line in the middle of its stroke
frame: {{A: [0 mm, 0 mm], D: [40 mm, 0 mm]}}
links: {{1: {{AB: 50 mm}}, 2: {{BC: 20 mm}}, 3: {{DC: 50 mm}}}}
input: {{link: 1, phi: {phi} deg, omega: ccw}}
branch: [C right of BD]
method: curvature
construction: euler-savary
find: [W_2, U_2]
"""


@pytest.mark.parametrize("case", BALLS, ids=lambda case: case["id"])
def test_the_oracle_has_the_ball_point_of_the_cases(case: dict[str, Any]) -> None:
    values = exact_values(case_problem(case, find=("U_2",)))
    assert values["U_2"] == pytest.approx(complex(*case["ball"]) / 1e3, abs=1e-11)


@pytest.mark.parametrize("case", [one for one in BALLS if "offpaper" not in one["id"]], ids=lambda case: case["id"])
@pytest.mark.parametrize("way", WAYS[:3])
def test_it_is_drawn_by_one_straight_line_after_any_construction_of_the_circle(case: dict[str, Any], way: str) -> None:
    answer = case_problem(case, way, ("U_2",)).solve(by="exact").answers["U_2"]
    assert answer.drawn_vector == pytest.approx(complex(*case["ball"]) / 1e3, abs=1e-10)


@settings(max_examples=often(6))
@given(linkages())
def test_what_is_drawn_is_what_the_rates_tell(case: dict[str, Any]) -> None:
    try:
        answers = case_problem(case, "euler-savary", ("delta_2", "U_2")).solve(by="exact").answers
    except VecpolyError:
        return  # it does not close, has no pole, runs off the sheet, or is a rod through a block
    answer = answers["U_2"]
    assert answer.drawn_vector is not None and answer.exact_vector is not None
    size = abs(answers["delta_2"].exact) + abs(answer.exact_vector) + 0.1
    assert abs(answer.drawn_vector - answer.exact_vector) <= 1e-6 * size
    assert answer.suspect in (None, Cause.VAGUE)  # far off by a pencil, on a figure at a small scale


@pytest.mark.parametrize("case", BALLS, ids=lambda case: case["id"])
def test_the_curvature_of_its_path_vanishes_and_so_does_its_rate(case: dict[str, Any]) -> None:
    mech = case_problem(case, find=("U_2",)).mechanism
    here = Curvatures(mech, "2")
    at, body = here.ball_point(), here.body
    local = complex(((at - body.at) * np.conj(body.unit))[0]) + body.local
    turned = [case | {"phi": case["phi"] + step} for step in (-0.02, 0.0, 0.02)]
    bends = []
    for one in turned:
        moved = Curvatures(case_problem(one, find=("U_2",)).mechanism, "2").body
        v, a = moved.velocity_of(local)[0], moved.acceleration_of(local)[0]
        bends.append(float((np.conj(v) * a).imag / abs(v) ** 3))
    assert bends[1] == pytest.approx(0.0, abs=1e-7)
    assert abs(bends[2] - bends[0]) / np.radians(0.04) < 1e-3  # 1/m a radian; of a pin by 100 mm it is 10 and more


def test_where_the_line_is_parallel_to_the_pole_tangent_it_is_the_inflection_pole() -> None:
    phi = float(np.degrees(np.arccos(30 / 50)))  # the crossed cranks stand alike to both sides
    answers = exactly(vecpoly.loads(CHEBYSHEV.format(phi=repr(phi)))).answers
    w, u = answers["W_2"], answers["U_2"]
    assert u.drawn_vector == pytest.approx(w.drawn_vector, abs=1e-12)
    assert u.exact_vector == pytest.approx(w.exact_vector, abs=1e-9)


def test_without_two_such_pins_it_is_refused() -> None:
    case = next(one for one in DATA["links"] if "BC" not in one)
    with pytest.raises(NoMethodError, match="two pins"):
        case_problem(case, find=("U_2",)).solve()


def test_of_a_trammel_every_point_of_the_circle_is_one() -> None:
    text = vecpoly.load("curv-7").text
    with pytest.raises(NotAskedError, match="no Ball point"):
        vecpoly.loads(text.partition("find:")[0] + "find: [W_2, U_2]\n").solve()


@pytest.mark.parametrize(("rod", "phi"), [(60, -40), (60, 77), (180, 180)])
def test_an_isosceles_slider_crank_has_no_one_ball_point_and_is_near_no_dead_point(rod: int, phi: int) -> None:
    """Its coupler rolls Cardan's circles, the third rate of the pole is rounding; at 180° the pin C, U itself, is P."""
    text = (
        "{id: i, title: i, frame: {A: [0 mm, 0 mm]}, joints: [3 slides on y = 0 mm], branch: [C right of B], method: "
        f"curvature, links: {{1: {{AB: 60 mm}}, 2: {{BC: {rod} mm}}, 3: {{block: C}}}}, find: [U_2], "
        f"input: {{link: 1, phi: {phi} deg, omega: ccw}}}}"
    )
    with pytest.raises(NotAskedError, match="no Ball point"):
        vecpoly.loads(text).solve()
