"""Rotors that cannot be, and corrections that cannot be made: each refusal tells why, with its numbers."""

from __future__ import annotations

from math import isnan
from typing import Any

import pytest

from tests.cam_cases import device, drawn
from tests.rotor_cases import CASES, agree, blind, dalby, lumps, planes
from vecpoly.errors import EquilibriumError, FaultError, NotAskedError
from vecpoly.oracle.devices.registry import device_answers

NEAR = 3e-9  # the cases are told to nine digits


def test_a_hole_deeper_than_the_disc_is_refused_and_two_are_offered() -> None:
    told = CASES["A03"]["results"]
    with pytest.raises(EquilibriumError, match=r"87\.81 mm deep.*50 mm.*46\.73 mm deep at 20°") as refused:
        device_answers(device("rotor", **blind()))
    assert refused.value.numbers["depth"] == pytest.approx(told["depth_mm"] / 1e3, rel=NEAR)
    assert refused.value.numbers["two_holes"] == pytest.approx(46.7251244e-3, rel=NEAR)
    with pytest.raises(EquilibriumError, match=r"87\.81 mm deep"):
        drawn(device("rotor", **blind()))


def test_couples_that_form_no_polygon_are_refused_with_their_gap() -> None:
    b, c, d = CASES["R01"]["inputs"]["couples_kgm2"]
    for solved in (device_answers, drawn):
        with pytest.raises(EquilibriumError, match=r"exceeds the sum of the others|大于其余各力偶之和") as refused:
            solved(dalby((b, c, d)))
        assert refused.value.numbers["gap"] == pytest.approx(CASES["R01"]["results"]["gap_kgm2"], rel=1e-6)


def test_a_share_of_the_wrong_sign_is_refused_with_the_pairs_that_work() -> None:
    plane = {"r": "80 mm", "places": "60 deg", "use": ["0 deg", "60 deg"], "only": "add"}
    rotor = device("rotor", masses={"1": {"U": "500 g*mm", "at": "300 deg"}}, correct={"I": plane})
    for solved in (device_answers, drawn):
        with pytest.raises(EquilibriumError, match=r"120° & 180°|60° & 120°") as refused:
            solved(rotor)
        assert refused.value.numbers["at"] == pytest.approx(0.0)
    free = device("rotor", masses={"1": {"U": "500 g*mm", "at": "300 deg"}}, correct={"I": plane | {"only": None}})
    assert agree(free)["W_b_1"] == pytest.approx(-500.0) and agree(free)["W_b_2"] == pytest.approx(500.0)


BESIDE = {"G": "6.3 mm/s", "mass": "5 kg", "n": "3000 r/min", "z": "150 mm"}  # its planes are at 0 and 100 mm


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"masses": lumps((1, 0, 0)), "correct": planes(200, 200)}, "coincide"),
        ({"masses": lumps((1, 0, 0)), "correct": {}}, "names one plane"),
        ({"masses": lumps((1, 0, 0)), "correct": {"I": {"r": "0 mm"}}}, "greater than zero"),
        ({"masses": {"1": {"hole": "5 mm", "r": "1 m", "at": "0 deg"}}, "correct": {"I": {}}}, "the density"),
        ({"masses": {"b": {"m": "5 kg", "r": "1 m", "at": "0 deg"}}, "correct": {"I": {}}}, "subscript"),
        ({"masses": {"1": {"m": "5 kg", "U": "1 kg*m", "at": "0 deg"}}, "correct": {"I": {}}}, "one of"),
        ({"masses": {"1": {"m": "?", "r": "1 m", "at": "?"}}}, "two among the others"),
        ({"masses": lumps((1, 0, 0)), "correct": {"I": {"r": "1 m", "places": "50 deg"}}}, "does not divide"),
        ({"masses": lumps((1, 0, 0)), "correct": {"I": {"r": "1 m", "places": ["0 deg", "180 deg"]}}}, "opposite"),
        ({"masses": lumps((1, 0, 0)), "correct": planes(0, 100), "tolerance": BESIDE}, "does not lie between"),
    ],
)
def test_what_no_rotor_can_be_is_refused(data: dict[str, Any], said: str) -> None:
    with pytest.raises((FaultError, ValueError), match=said):
        device("rotor", **data)


@pytest.mark.parametrize(
    ("plane", "said"),
    [
        ({"r": "40 mm", "hole": "60 mm", "spread": "20 deg"}, r"stand 27\.36 mm apart and are 60 mm wide"),
        ({"r": "40 mm", "hole": "through", "spread": "5 deg"}, r"stand 6\.972 mm apart and are 13\.63 mm wide"),
        ({"r": "5 mm", "hole": "through"}, r"of 54\.42 mm at a radius of 5 mm would reach over the axis"),
        ({"r": "15 mm", "hole": "32 mm"}, "would reach over the axis"),
    ],
)
def test_holes_that_overlap_or_reach_over_the_axis_balance_nothing(plane: dict[str, str], said: str) -> None:
    disc = {"b": "140 mm", "density": "7850 kg/m^3"}
    rotor = device("rotor", masses={"1": {"U": "12780 g*mm", "at": "60 deg"}}, correct={"I": plane}, disc=disc)
    for solved in (device_answers, drawn):
        with pytest.raises(EquilibriumError, match=said):
            solved(rotor)


def test_masses_in_several_planes_are_told_what_one_plane_leaves() -> None:
    apart = device("rotor", masses=lumps((1, 60, 0), (0.8, 240, 100)), correct={"I": {"z": "30 mm", "r": "20 mm"}})
    left = abs(1 * -0.03 - 0.8 * 0.07)  # W is 1 and 0.8 kg·m
    assert f"keeps a couple of {left:.4g} kg·m²" in apart.noted(())[0].en
    assert not device("rotor", masses=lumps((1, 60, 30), (0.8, 240, 30)), correct={"I": {"z": "30 mm"}}).noted(())
    assert not device("rotor", masses=lumps((1, 60, 0), (0.8, 240, 100)), correct=planes(0, 100)).noted(())


@pytest.mark.parametrize(
    ("data", "error", "said"),
    [
        ({"places": ["0 deg", "180 deg", "190 deg"]}, EquilibriumError, "lie in one line"),
        (
            {"places": ["0 deg", "120 deg", "240 deg"], "use": ["0 deg", "120 deg"], "only": "remove"},
            EquilibriumError,
            "only be",
        ),
    ],
)
def test_places_that_cannot_share_are_refused(data: dict[str, Any], error: type[Exception], said: str) -> None:
    rotor = device("rotor", masses={"1": {"U": "500 g*mm", "at": "280 deg"}}, correct={"I": {"r": "80 mm", **data}})
    for solved in (device_answers, drawn):
        with pytest.raises(error, match=said):
            solved(rotor)


def test_a_rotor_in_balance_has_no_direction_and_nothing_to_share() -> None:
    masses = lumps((1, 20, 0), (1, 200, 0))
    found = agree(device("rotor", masses=masses, correct={"I": {"r": "1 m"}}))
    assert isnan(found["theta_b"]) and abs(found["W_b"]) < 1e-12
    for solved in (device_answers, drawn):
        with pytest.raises(NotAskedError, match="in balance already"):
            solved(device("rotor", masses=masses, correct={"I": {"r": "1 m", "places": "30 deg"}}))


def test_two_masses_sought_in_one_line_are_refused() -> None:
    sought = {"m": "?", "r": "1 m", "z": "1 m"}
    masses = {"A": {"m": "?", "r": "1 m", "at": "?"}, "B": {"m": "1 kg", "r": "1 m", "at": "0 deg", "z": "2 m"}}
    masses |= {"C": sought | {"at": "40 deg"}, "D": sought | {"at": "220 deg"}}
    for solved in (device_answers, drawn):
        with pytest.raises(EquilibriumError, match="lie in one line"):
            solved(device("rotor", masses=masses))
