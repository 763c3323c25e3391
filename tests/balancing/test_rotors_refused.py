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
    ],
)
def test_what_no_rotor_can_be_is_refused(data: dict[str, Any], said: str) -> None:
    with pytest.raises((FaultError, ValueError), match=said):
        device("rotor", **data)


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
