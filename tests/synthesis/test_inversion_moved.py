"""What was found on paper, moved by the exact solver, comes through the positions that were given."""

from __future__ import annotations

import cmath
from math import degrees, radians

import pytest

import vecpoly
from tests.synthesis.inversion import solved
from vecpoly.problem.values.vary import data_of


def place(name: str, phi: float, letter: str) -> complex:
    """Where a pin of the linkage that was found lies (mm) when its driver stands at an angle (deg)."""
    data = data_of(solved(vecpoly.load(name)).linkage)
    data["input"]["phi"] = f"{phi!r} deg"
    at = vecpoly.problem({**data, "find": [f"p_{letter}"]}).solve(by="exact").answers[f"p_{letter}"].exact_vector
    assert at is not None
    return 1e3 * at


@pytest.mark.parametrize(("phi", "e"), [(90.0, 90 + 0j), (30.0, 110 + 0j)])
def test_the_six_bar_of_8_13_moves_its_slider_by_20_mm(phi: float, e: complex) -> None:
    assert place("8-13", phi, "E") == pytest.approx(e, abs=1e-4)


@pytest.mark.parametrize(("phi", "turn"), [(180.0, 270.0), (90.0, 315.0)])
def test_the_output_rocker_of_8_12_turns_by_45_degrees(phi: float, turn: float) -> None:
    arm = place("8-12", phi, "E") - (2750 + 2000j)
    assert degrees(cmath.phase(arm)) % 360 == pytest.approx(turn, abs=1e-6)


@pytest.mark.parametrize(("phi", "psi"), [(50.0, 40.0), (65.0, 60.0), (80.0, 80.0)])
def test_the_rocker_of_8_8_has_its_three_angles(phi: float, psi: float) -> None:
    ahead = solved(vecpoly.load("8-8")).answers["delta_C"].drawn
    assert degrees(cmath.phase(place("8-8", phi, "C") - 60)) == pytest.approx(psi + ahead, abs=1e-6)


@pytest.mark.parametrize(("phi", "s"), [(30.0, 78.0), (75.0, 62.0), (120.0, 34.0)])
def test_the_slider_of_8_9_has_its_three_places(phi: float, s: float) -> None:
    ahead = solved(vecpoly.load("8-9")).answers["delta_B"].drawn
    assert place("8-9", phi + ahead, "C") == pytest.approx(s - 10j, abs=1e-6)


@pytest.mark.parametrize(("at", "deg"), [(0j, 0.0), (49 + 12j, 30.0), (100 + 58j, 88.0)])
def test_the_coupler_comes_through_three_positions(at: complex, deg: float) -> None:
    turn = cmath.exp(1j * radians(deg))
    (found,) = solved(vecpoly.load("three-positions")).construction.candidates
    a = complex(-3.404272251, 119.840072507)
    b, c = at - 5j * turn, at + (46 + 9j) * turn
    assert found.values["AB"] == pytest.approx(abs(b - a), abs=1e-6)
    assert place("three-positions", degrees(cmath.phase(b - a)), "C") == pytest.approx(c - a, abs=1e-5)
