"""The shaking force of a slider-crank: the worked engine, any engine against its masses differentiated, the best c."""

from __future__ import annotations

from cmath import rect
from math import cos, radians, sin, sqrt
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.cam_cases import device, drawn
from tests.laws import often
from tests.rotor_cases import CASES, agree
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Disc, Role, Segment

TOLD = CASES["A19"]
NEAR = 5e-9  # the case is told to nine digits


def engine(**more: Any) -> Any:
    given_ = TOLD["inputs"]
    data = {
        "r": f"{given_['r_mm']} mm",
        "l": f"{given_['l_mm']} mm",
        "n": f"{given_['n_rpm']} r/min",
        "m1": f"{given_['crank_unbalance_at_B_kg']} kg",
        "m2": f"{given_['m2_kg']} kg",
        "BS2": f"{given_['S2_from_B_mm']} mm",
        "m3": f"{given_['m3_kg']} kg",
        "r_c": f"{given_['counterweight_r_mm']} mm",
        "c": "0",
    }
    return device("shaking-force", **data | more)


@pytest.mark.parametrize(("c", "row"), [("0", 0), ("0.5", 1), ("2/3", 2), ("1", 3)])
def test_the_counterweight_and_the_largest_force_are_those_of_the_worked_engine(c: str, row: int) -> None:
    told, by = TOLD["results"], TOLD["results"]["by_fraction"][row]
    at_0, at_90 = (agree(engine(c=c, at=f"{at} deg"), within=1e-8) for at in (0, 90))
    assert at_0["m_rec"] == pytest.approx(told["m_rec_kg"]) and at_0["m_rot"] == pytest.approx(told["m_rot_kg"])
    assert at_0["F_1"] == pytest.approx(told["X_primary_N"], rel=NEAR)
    assert at_0["F_2"] == pytest.approx(told["secondary_N"], rel=NEAR)
    assert at_0["m_c"] == pytest.approx(by["counterweight_kg"], rel=NEAR)
    assert at_0["F"].real == pytest.approx(by["Fx_0deg_N"], rel=NEAR)
    assert at_90["F"] == pytest.approx(by["Fx_90deg_N"] + 1j * by["Fy_90deg_N"], rel=NEAR)
    assert at_0["F_max"] == pytest.approx(by["F_max_N"], rel=NEAR)
    assert at_0["phi_max"] == pytest.approx(by["at_phi_deg"], abs=5e-4)


def test_a_crank_that_is_balanced_by_itself_leaves_the_rods_share_alone() -> None:
    found, rod = agree(engine(m1="0 kg"), within=1e-8), agree(engine(), within=1e-8)
    assert found["m_rot"] == pytest.approx(rod["m_rot"] - TOLD["inputs"]["crank_unbalance_at_B_kg"], rel=1e-12)
    assert found["m_rec"] == rod["m_rec"]


def test_the_best_fraction_makes_the_largest_force_least() -> None:
    found = agree(engine(c="best"), within=1e-7)
    assert found["c"] == pytest.approx(TOLD["results"]["best_c"], abs=2e-9)
    assert found["F_max"] == pytest.approx(TOLD["results"]["best_F_max_N"], rel=NEAR)
    for beside in (-0.01, 0.01):
        assert agree(engine(c=f"{found['c'] + beside!r}"), within=1e-8)["F_max"] > found["F_max"]


@settings(max_examples=often(5), deadline=None)
@given(ratio=st.floats(0.02, 0.08), c=st.floats(0, 1), at=st.integers(0, 359))
def test_the_two_terms_are_the_second_derivative_of_the_masses_but_for_higher_orders(
    ratio: float, c: float, at: int
) -> None:
    l_ = 1.0 / ratio
    rod = {"r": "1 m", "l": f"{l_!r} m", "n": "1 rad/s", "BS2": f"{0.4 * l_!r} m", "r_c": "1 m"}
    found = agree(engine(**rod, c=f"{c!r}", at=f"{at} deg"), within=1e-7)
    weight, step = found["m_c"], 1e-3

    def momentum(phi: float) -> complex:
        """Σ m r of crank, rod (by its own centre of mass), piston and counterweight."""
        b = complex(cos(phi), sin(phi))
        piston = cos(phi) + sqrt(l_**2 - sin(phi) ** 2)
        return complex(0.4 * b + 1.2 * (b + 0.4 * (piston - b)) + 0.9 * piston - weight * b)

    phi = radians(at)
    force = -(momentum(phi + step) - 2 * momentum(phi) + momentum(phi - step)) / step**2
    assert abs(force - found["F"]) < 2.0 * ratio**3 + 1e-5


def test_the_hodograph_of_no_counterweight_lies_along_the_cylinder() -> None:
    found = agree(engine(c="0", at="37 deg"), within=1e-8)
    assert abs(found["F"].imag) < 1e-9 * abs(found["F"])
    assert found["F_max"] == pytest.approx(found["F_1"] + found["F_2"]) and np.isclose(found["phi_max"], 0.0)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"c": "3"}, "between 0 and 2"),
        ({"c": "1/0"}, "above zero"),
        ({"r": "210 mm"}, "less than the length of the rod"),
    ],
)
def test_engines_that_cannot_be_are_refused(more: dict[str, str], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        engine(**more)


@pytest.mark.parametrize("at", [0, 60, 150, 235])
def test_the_sketch_has_the_crank_at_its_angle_the_rod_at_its_length_and_the_counterweight_opposite(at: int) -> None:
    figure = drawn(engine(at=f"{at} deg")).figure(View.MECHANISM)
    assert figure is not None
    rods = {
        mark.owner: mark.b - mark.a for mark in figure.marks if isinstance(mark, Segment) and mark.role is Role.LINK
    }
    crank, rod, (weight,) = rods["link 1"], rods["link 2"], (m.centre for m in figure.marks if isinstance(m, Disc))
    assert crank / abs(crank) == pytest.approx(rect(1.0, radians(at)))
    assert (crank + rod).imag == pytest.approx(0.0, abs=1e-9) and rod.real > 0
    told = TOLD["inputs"]
    assert abs(rod) / abs(crank) == pytest.approx(told["l_mm"] / told["r_mm"])
    assert weight / crank == pytest.approx(-told["counterweight_r_mm"] / told["r_mm"])
