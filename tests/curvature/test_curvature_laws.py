"""Laws of the kinematic geometry, on random four-bars, slider-cranks and rods through a block."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.curvature.linkages import WAYS, case_problem
from tests.drawn_library import drawn
from tests.laws import often
from vecpoly.algebra.formula import Over, Txt, plain
from vecpoly.check.alarm import Cause
from vecpoly.errors import VecpolyError
from vecpoly.oracle.curvature import Curvatures
from vecpoly.tagging.speech import said

EXACT = 1e-9
DEGREE = 1e-4  # degrees from one position to the next in a difference


@st.composite
def linkages(draw: st.DrawFn) -> dict[str, Any]:
    """A linkage with one further point of its coupler: crank, position and sort as they come."""
    lengths = st.integers(25, 90)
    case: dict[str, Any] = {
        "AB": draw(lengths),
        "phi": draw(st.integers(0, 359)),
        "points": {"E1": [draw(st.integers(-20, 80)), draw(st.integers(-40, 40))]},
    }
    match draw(st.sampled_from(("four-bar", "slider", "block"))):
        case "four-bar":
            side = draw(st.sampled_from(("C left of BD", "C right of BD")))
            bc, cd, ad = draw(lengths), draw(lengths), draw(lengths)
            return case | {"BC": bc, "CD": cd, "D_at": [ad, 0], "branch": side}
        case "slider":
            return case | {"BC": case["AB"] + draw(st.integers(20, 80)), "guide_y": draw(st.integers(-15, 15))}
    return case | {"C_at": [case["AB"] + draw(st.integers(10, 60)), 0]}


def shape(case: dict[str, Any]) -> Curvatures | None:
    """The oracle of a linkage; None where it does not close, or has no pole here."""
    try:
        here = Curvatures(case_problem(case, find=("P_24",)).mechanism, "2")
        return here if abs(here.inflection_pole - here.pole) < 10 * here.mech.scale else None
    except VecpolyError:
        return None


@settings(max_examples=often(4))
@given(linkages(), st.sampled_from(WAYS))
def test_whatever_is_drawn_is_what_the_rates_tell(case: dict[str, Any], way: str) -> None:
    try:
        answers = case_problem(case, way).solve(by="exact").answers
    except VecpolyError:
        return  # it does not close, has no pole, or runs off the sheet: each of these has a test of its own
    for key, answer in answers.items():
        drawn = answer.drawn if answer.drawn_vector is None else answer.drawn_vector
        exact = answer.exact if answer.exact_vector is None else answer.exact_vector
        size = abs(answers["delta_2"].exact) + abs(answers["rho_E"].exact) + abs(exact) + 0.1
        assert abs(drawn - exact) <= EXACT * size * 100 and answer.suspect in (None, Cause.VAGUE), key


@given(linkages(), st.floats(0.0, 6.283))
def test_euler_and_savary_hold_for_every_point_of_the_link(case: dict[str, Any], angle: float) -> None:
    if (here := shape(case)) is None:
        return
    p, w = here.pole, here.inflection_pole
    e = complex(here.motion.place("E")[0])
    try:
        centre, rho = here.path("E")
    except VecpolyError:
        return
    along = (e - p) / abs(e - p)
    r, r0, j = (float((along.conjugate() * (at - p)).real) for at in (e, centre, w))
    assert abs((r0 - r) * j - r * r0) <= EXACT * (abs(r0 * j) + abs(r * j) + abs(r * r0) + here.mech.scale**2)
    assert abs(abs(e - centre) - rho) < EXACT * (rho + abs(e))
    rim = (p + w) / 2 + abs(w - p) / 2 * np.exp(1j * angle)  # a point of the circle has no normal acceleration
    v, a = here.body.velocity_at(np.array([rim])), here.body.acceleration_at(np.array([rim]))
    turn = abs(here.body.omega[0])
    pull = abs(a[0]) + turn**2 * abs(w - p)
    rounding = 1e-9 * turn * here.mech.scale  # of the velocity, at the pole itself
    assert abs((v.conj() * a).imag[0]) <= 1e-7 * (abs(v[0]) + rounding) * pull


@given(linkages())
def test_the_pole_moves_along_the_tangent_at_omega_times_delta(case: dict[str, Any]) -> None:
    if (here := shape(case)) is None:
        return
    before, after = (shape(case | {"phi": case["phi"] + step}) for step in (-DEGREE, DEGREE))
    if before is None or after is None:
        return
    moved = (after.pole - before.pole) / np.radians(2 * DEGREE)
    u = here.pole_velocity * float(here.body.omega[0])
    slack = 1e-5 * (abs(u) + here.mech.scale) * (1 + abs(u) / here.mech.scale) ** 2
    assert abs(moved - u) < slack


def mirrored(case: dict[str, Any]) -> dict[str, Any]:
    """The linkage in a mirror on the x axis."""
    turned = {"phi": -case["phi"], "points": {name: [x, -y] for name, (x, y) in case["points"].items()}}
    if "branch" in case:
        sides = {"C left of BD": "C right of BD", "C right of BD": "C left of BD"}
        turned["branch"] = sides[case["branch"]]
    return case | turned | ({"guide_y": -case["guide_y"]} if "guide_y" in case else {})


@settings(max_examples=often(3), deadline=None)
@given(linkages(), st.sampled_from(WAYS))
def test_of_a_mirrored_linkage_all_poles_circles_and_centres_are_mirrored(case: dict[str, Any], way: str) -> None:
    here, there = (_drawn(one, way) for one in (case, mirrored(case)))
    assert here.keys() == there.keys()
    size = sum(abs(at) for at in here.values()) + 0.1
    assert all(abs(there[key] - at.conjugate()) < 1e-7 * size for key, at in here.items())


def _drawn(case: dict[str, Any], way: str) -> dict[str, complex]:
    """What is read by the exact hand; nothing where the case is refused."""
    try:
        answers = case_problem(case, way).solve(by="exact").answers
    except VecpolyError:
        return {}
    return {key: complex(one.drawn if one.drawn_vector is None else one.drawn_vector) for key, one in answers.items()}


def test_a_sum_of_chords_is_told_with_the_letters_of_one_chord_and_no_bar_over_the_sign() -> None:
    lines = [plain(line) for step in drawn("curv-6").construction.steps for line in step.formulas]
    (fixed,) = (line for line in lines if line.startswith("L_f2"))
    assert "ΣQ_k Q_k+1 = " in fixed
    assert plain(Over(Txt("Q"), summed=True)) == "ΣQ" and said(Over(Txt("Q"), summed=True), "en").startswith("the sum")


SLIDING = {"AB": 30, "phi": 50, "points": {"E1": [20, 30], "E2": [60, -20]}}
AT_INFINITY = {
    "a rod through a block: of the moving centre": (SLIDING | {"C_at": [80, 0]}, "过 $E$ 所作该法线的平行线"),
    "a slider-crank: of the fixed centre": (SLIDING | {"BC": 90, "guide_y": 0}, "作该法线的平行线"),
}


@pytest.mark.parametrize("name", AT_INFINITY)
def test_in_place_of_a_centre_at_infinity_a_parallel_is_told_in_the_reader_s_language(name: str) -> None:
    case, parallel = AT_INFINITY[name]
    steps = case_problem(case, find=("p_OE", "p_OF")).solve(by="exact").construction.steps
    plain_zh = [re.sub(r"\$[^$]*\$", "", step.words.zh) for step in steps]
    assert not [told for told in plain_zh if re.search(r"[A-Za-z]{3}", told)]
    (told,) = (step.words for step in steps if parallel in step.words.zh)
    assert "the parallel to that normal through $" in told.en
