"""Rotors balanced in place: the worked cases, hidden unbalances found again, readings that are refused."""

from __future__ import annotations

from cmath import phase, rect
from math import degrees, radians
from typing import Any

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.cam_cases import device, drawn
from tests.laws import often
from tests.rotor_cases import CASES, agree, influence, runs
from vecpoly.errors import FaultError, NotAskedError
from vecpoly.oracle.devices.registry import device_answers

NEAR = 5e-9  # the cases are told to nine digits


@pytest.mark.parametrize(
    ("trial", "answer"), [("removed", "correction_trial_removed"), ("left", "correction_trial_left")]
)
def test_the_influence_coefficient_gives_the_correction(trial: str, answer: str) -> None:
    told, found = CASES["A13"]["results"], agree(influence(trial))
    assert found["V_t"] == pytest.approx(told["effect_um"], rel=NEAR)
    assert found["phi_t"] == pytest.approx(told["effect_phase_deg"], rel=NEAR)
    assert found["alpha"] == pytest.approx(told["alpha_um_per_gmm"], rel=NEAR)
    assert found["m_b"] == pytest.approx(told[answer]["m_g"], rel=NEAR)
    assert found["theta_b"] == pytest.approx(told[answer]["at_deg"], rel=NEAR)


@pytest.mark.parametrize("case", ["A16", "A31"])
def test_three_arcs_give_the_centroid_of_their_triangle_and_its_size(case: str) -> None:
    told, found = CASES[case]["results"], agree(runs(case))
    assert found["V_t"] == pytest.approx(told["centroid"]["T"], rel=NEAR)
    assert found["m_b"] == pytest.approx(told["centroid"]["m_c_g"], rel=NEAR)
    assert found["theta_b"] == pytest.approx(told["centroid"]["at_deg"], rel=NEAR)
    assert found["spread"] == pytest.approx(told["triangle_size"], rel=1e-6)


def test_two_arcs_leave_two_answers() -> None:
    told, found = CASES["A18"]["results"], agree(runs("A18", "mm/s"))
    for which, at in enumerate(told["at_deg_two_solutions"], 1):
        assert found[f"V_t_{which}"] == pytest.approx(told["effect_T"], rel=NEAR)
        assert found[f"m_b_{which}"] == pytest.approx(told["m_c_g"], rel=NEAR)
        assert found[f"theta_b_{which}"] == pytest.approx(at, rel=NEAR)


@pytest.mark.parametrize(("other", "equal"), [(180.0, True), (120.0, False)])
def test_why_two_arcs_leave_two_answers_is_said_and_true_of_the_drawing(other: float, equal: bool) -> None:
    trials = [
        {"m": "10 g", "r": "100 mm", "at": f"{at} deg", "reading": f"{abs(5 + rect(2.4, radians(at - 50))):.4f} mm/s"}
        for at in (0.0, other)
    ]
    problem = device("field-balancing", initial="5 mm/s", trials=trials, correct={"r": "100 mm"})
    construction = drawn(problem)
    (said,) = (step.words.en for step in construction.steps if "only two trial runs" in step.words.en)
    assert "mirror images" in said and ("collinear" in said) is equal
    sizes = [construction.readings[f"V_t_{which}"].scalar for which in (1, 2)]
    assert (sizes[0] == pytest.approx(sizes[1], rel=1e-9)) is equal


def shown(first: complex, per_weight: complex, weight: complex) -> complex:
    return first + per_weight * weight


@settings(max_examples=often(10), deadline=None)
@given(
    first=st.tuples(st.floats(2, 20), st.floats(0, 360)),
    per_gram=st.tuples(st.floats(0.2, 2), st.floats(0, 360)),
    trial=st.floats(0, 360),
)
def test_the_correction_stops_the_vibration(
    first: tuple[float, float], per_gram: tuple[float, float], trial: float
) -> None:
    v0, alpha, weight = (rect(size, radians(at)) for size, at in (first, per_gram, (5.0, trial)))
    v1 = shown(v0, alpha, weight)
    assume(abs(v1) > 0.05)
    run = {"m": "5 g", "r": "100 mm", "at": f"{trial!r} deg", "reading": told(v1)}
    found = agree(device("field-balancing", initial=told(v0), trials=[run], correct={"r": "100 mm"}), within=1e-7)
    rest = shown(v0, alpha, rect(found["m_b"], radians(found["theta_b"])))
    assert abs(rest) < 1e-6 * abs(v0)


def told(vibration: complex) -> str:
    return f"{abs(vibration):.12f} um at {degrees(phase(vibration)):.12f} deg"


@settings(max_examples=often(10), deadline=None)
@given(
    first=st.floats(5, 20),
    share=st.floats(0.2, 0.9),
    heavy=st.floats(0, 360),
    turns=st.lists(st.sampled_from([0, 60, 110, 150, 200, 240, 300]), min_size=3, max_size=3, unique=True),
)
def test_three_runs_without_phase_find_a_hidden_unbalance(
    first: float, share: float, heavy: float, turns: list[int]
) -> None:
    effect = share * first
    assume(min((b - a) % 360 for a, b in zip(sorted(turns), sorted(turns)[1:] + sorted(turns)[:1], strict=True)) > 40)
    readings = [abs(rect(first, radians(heavy + 180)) + rect(effect, radians(at))) for at in turns]
    trials = [
        {"m": "10 g", "r": "50 mm", "at": f"{at} deg", "reading": f"{one:.12f} um"}
        for at, one in zip(turns, readings, strict=True)
    ]
    found = agree(
        device("field-balancing", initial=f"{first!r} um", trials=trials, correct={"r": "100 mm"}), within=1e-5
    )
    assert found["m_b"] == pytest.approx(10 / share * 0.5, rel=1e-4)
    assert abs((found["theta_b"] - heavy + 180) % 360 - 180) < 1e-2
    assert found["spread"] < 1e-4 * first


def field(first: str, *readings: str) -> dict[str, Any]:
    turns = (0, 120, 240)
    trials = [
        {"m": "10 g", "r": "1 m", "at": f"{at} deg", "reading": one} for at, one in zip(turns, readings, strict=False)
    ]
    return {"initial": first, "trials": trials, "correct": {"r": "1 m"}}


def test_arcs_that_do_not_meet_are_refused_with_their_gap() -> None:
    for solved in (device_answers, drawn):
        with pytest.raises(NotAskedError, match=r"contradict each other|互相矛盾") as refused:
            solved(device("field-balancing", **field("10 um", "2 um", "3 um", "25 um")))
        assert refused.value.numbers["gap"] == pytest.approx(10 * 3**0.5 - 5)


def test_an_effect_of_the_size_of_the_last_digit_is_refused() -> None:
    weak = device("field-balancing", **field("8.6 um at 63 deg", "8.5 um at 63 deg"))
    for solved in (device_answers, drawn):
        with pytest.raises(NotAskedError, match=r"no more than the last digits|不大于两次读数末位的误差") as refused:
            solved(weak)
        assert refused.value.numbers == {"effect": pytest.approx(0.1), "error": pytest.approx(0.2)}
    assert agree(device("field-balancing", **field("8.60 um at 63 deg", "8.50 um at 63 deg")))["V_t"] == pytest.approx(
        0.1
    )


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (field("8.6 um", "5 um"), "two trial runs"),
        (field("8.6 um at 63 deg", "5 um"), "write all phases, or none"),
        (field("8.6 um", "5 mm/s", "5 um"), "different kinds"),
        (field("8.6 um at 63 deg", "5 um at 0 deg", "6 um at 0 deg"), "one trial run is enough"),
        (field("8.6 kg", "5 um", "4 um"), "is no vibration"),
        (field("8.6", "5 um", "4 um"), "is no vibration"),
    ],
)
def test_readings_that_do_not_belong_together_are_refused(data: dict[str, Any], said: str) -> None:
    with pytest.raises((FaultError, ValueError), match=said):
        device("field-balancing", **data)


def test_inches_and_mils_are_read_as_micrometres() -> None:
    assert agree(runs("A31", "mil"))["V_t"] == pytest.approx(25.4 * CASES["A31"]["results"]["centroid"]["T"], rel=NEAR)
