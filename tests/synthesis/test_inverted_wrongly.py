"""The slip of inversion: a figure that is carried on with the motion instead of turned back."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

import vecpoly
from tests.laws import few
from vecpoly import Mistake, Slip


def _drawn(problem: vecpoly.Problem, slip: Slip | None = None) -> dict[str, float]:
    return {key: one.drawn for key, one in vecpoly.solve(problem, slip=slip, repeats=0, precise=False).answers.items()}


def test_who_inverts_forwards_gets_the_linkage_of_the_opposite_turns() -> None:
    """About D both frames are turned by the ψ of the rocker, the other way: the answers of the data with −ψ."""
    problem = vecpoly.load("two-pairs")
    (slip,) = (one for one in vecpoly.slips(problem) if one.mistake is Mistake.FORWARDS)
    wrong = _drawn(problem, slip)
    d = 100.0 + 0j
    b1, b2 = (40.0 * np.exp(1j * np.radians(phi)) for phi in (60, 110))
    turned = d + (b2 - d) * np.exp(1j * np.radians(85 - 50))  # carried on by ψ₁₂ instead of turned back
    along = np.exp(1j * np.radians(50))  # C lies on the line of the rocker in position 1
    middle, across = (b1 + turned) / 2, 1j * (turned - b1)
    lines = [[along.real, -across.real], [along.imag, -across.imag]]
    at = np.linalg.solve(lines, [(middle - d).real, (middle - d).imag])
    c = d + at[0] * along
    assert_allclose([wrong["BC"], wrong["CD"]], [abs(c - b1), abs(c - d)], atol=0.6)


@pytest.mark.parametrize("name", ["8-9", "8-11", "three-positions-frame"])
def test_the_slip_is_in_the_catalogue_and_changes_an_answer(name: str) -> None:
    problem = vecpoly.load(name)
    right = _drawn(problem)
    made = [one for one in vecpoly.slips(problem) if one.mistake is Mistake.FORWARDS]
    assert made
    for slip in made:
        wrong = _drawn(problem, slip)
        assert max(abs(wrong[key] / right[key] - 1) for key in right) > 0.1


def test_an_answer_that_follows_from_it_is_told_so_and_costs_once() -> None:
    problem = vecpoly.load("8-9")
    wrong = _drawn(problem, next(one for one in vecpoly.slips(problem) if one.mistake is Mistake.FORWARDS))
    told = str(vecpoly.check_answers(problem, [f"AB={wrong['AB']:.1f} mm", f"BC={wrong['BC']:.1f} mm"]))
    assert "turned back" in told
    assert "Follows rightly from the mistake" in told


@pytest.mark.parametrize(("name", "key", "answer"), [("8-16", "nn", "alpha_max"), ("8-3b", "nn", "alpha_max")])
def test_a_pressure_angle_from_the_wrong_normal_is_its_complement(name: str, key: str, answer: str) -> None:
    problem = vecpoly.load(name)
    wrong = _drawn(problem, Slip(Mistake.TURNED, key))
    assert wrong[answer] == pytest.approx(90.0 - _drawn(problem)[answer], abs=0.2)


@pytest.mark.parametrize("name", few(["cam-roller-offset", "cam-rocker", "cam-heart"], 3))
def test_of_a_cam_too_and_of_the_normal_of_the_rise_alone(name: str) -> None:
    problem = vecpoly.load(name)
    slip = next(one for one in vecpoly.slips(problem) if one.key == "mechanism alpha_rise:nn")
    right, wrong = _drawn(problem), _drawn(problem, slip)
    assert wrong["alpha_rise"] == pytest.approx(90.0 - right["alpha_rise"], abs=0.2)
    assert wrong["alpha_return"] == right["alpha_return"]


@pytest.mark.parametrize(
    "name", few(["cam-flat-arm", "cam-flat-face", "cam-heart", "cam-rocker", "cam-roller-offset"], 5)
)
def test_a_cam_inverted_the_wrong_way_is_its_own_mirror_image(name: str) -> None:
    problem = vecpoly.load(name)
    assert Slip(Mistake.FORWARDS, "inversion") in vecpoly.slips(problem)
    right, wrong = (_drawn(problem, slip) for slip in (None, Slip(Mistake.FORWARDS, "inversion")))
    about = {key for key in right if key.startswith("theta")}  # where a point stands on the disc shows the sense
    assert {k: v for k, v in wrong.items() if k not in about} == pytest.approx(
        {k: v for k, v in right.items() if k not in about}
    )  # the same sizes, on a cam that must turn the other way
    assert all(abs(wrong[key] - right[key]) > 1.0 for key in about)


@pytest.mark.parametrize("name", ["curv-2", "curv-4"])
def test_a_centre_of_curvature_may_be_laid_off_to_the_wrong_side(name: str) -> None:
    problem = vecpoly.load(name)
    slip = next(one for one in vecpoly.slips(problem) if one.key.startswith("EO") and one.mistake is Mistake.REVERSED)
    right, wrong = _drawn(problem), _drawn(problem, slip)
    assert abs(wrong["p_OE"] - right["p_OE"]) > 1e-3
    assert wrong["W_2"] == right["W_2"]
