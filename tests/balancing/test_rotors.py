"""Rotors: the exact hand, the oracle and two other ways agree; what was found balances the rotor."""

from __future__ import annotations

import re
from cmath import phase, rect
from math import degrees, radians
from typing import Any

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.cam_cases import device, drawn
from tests.laws import often
from tests.rotor_cases import CASES, agree, blind, dalby, grade, holes, lumps, planes, two_planes
from vecpoly import load
from vecpoly.board.hand import hand
from vecpoly.board.paper.marks import Point, Vector
from vecpoly.board.place import view_named
from vecpoly.drawing.sheets.paper import DrawingPaper
from vecpoly.methods.devices.plan import construct_device
from vecpoly.problem.asked.asks import AskNamed
from vecpoly.problem.load import loads
from vecpoly.problem.problem import Problem, Scales
from vecpoly.solution import solve
from vecpoly.words import Words

NEAR = 3e-9  # the cases are told to nine digits


def near(value: float) -> Any:
    return pytest.approx(value, rel=NEAR)


def test_a_disc_with_two_holes_and_a_lump_is_balanced_by_a_third_hole() -> None:
    told = CASES["A01"]["results"]
    radius = CASES["A01"]["inputs"]["correction"]["hole_at_r_mm"]
    found = agree(device("rotor", **holes("A01"), correct={"I": {"r": f"{radius} mm", "hole": "through"}}))
    assert found["m_1"] == near(told["m_hole1_kg"]) and found["m_2"] == near(told["m_hole2_kg"])
    assert [found[f"W_{i}"] for i in (1, 2, 3)] == [near(told[f"W{i}_kgm"]) for i in (1, 2, 3)]
    assert abs(found["W_b"]) == near(told["W_b_kgm"]) and found["theta_b"] == near(told["W_b_direction_deg"])
    assert found["m_b"] == near(told["removed_mass_kg"]) and found["d_b"] == near(told["hole_diameter_mm"])
    assert found["theta_h"] == near(told["hole_at_deg"])


def test_a_closing_side_is_as_long_on_paper_as_its_scale_says() -> None:
    told = CASES["A01"]["results"]["closing_side_mm"]
    subject = device("rotor", **holes("A01"), correct={"I": {"r": "140 mm"}})
    asks = tuple(AskNamed(rel=named) for named in subject.quantities())
    scales = Scales({"mu_W": 0.002})
    problem = Problem(id="x", title=Words.same("x"), subject=subject, asks=asks, scales=scales)
    reading = construct_device(problem, hand("exact"), DrawingPaper())[0].readings["W_b"]
    assert reading.mm == near(told) and reading.scalar == near(0.002 * told)


def test_two_blind_holes_share_what_one_would_have_to_take() -> None:
    told, found = CASES["A03"]["results"], agree(device("rotor", **blind(spread="20 deg")))
    assert found["m_1"] == near(told["m_hole_kg"]) and found["m_2"] == near(told["m_keyway_kg"])
    assert [found[f"W_{i}"] for i in (1, 2, 3)] == [near(w) for w in told["W_kgm"]]
    assert found["theta_h"] == near(told["hole_at_deg"]) and found["m_b"] == near(told["removed_mass_kg"])
    assert found["h_b"] == near(told["feasible_two_equal_holes_depth_mm"])


def test_a_correction_is_shared_by_the_neighbouring_holes_of_a_bolt_circle() -> None:
    told = CASES["A04"]
    unbalance = {"U": f"{told['inputs']['needed_U_gmm']} g*mm", "at": f"{told['inputs']['needed_at_deg'] + 180} deg"}
    found = agree(device("rotor", masses={"1": unbalance}, correct={"I": {"r": "95 mm", "places": "30 deg"}}))
    for i in (1, 2):
        assert found[f"theta_b_{i}"] == pytest.approx(told["results"]["holes_deg"][i - 1])
        assert found[f"W_b_{i}"] == near(told["results"]["U_gmm"][i - 1])
        assert found[f"m_b_{i}"] == near(told["results"]["masses_g"][i - 1])


def test_three_masses_are_balanced_in_two_planes() -> None:
    told, found = CASES["A06"]["results"], agree(two_planes())
    for end in ("I", "II"):
        assert [found[f"W_{i}{end}"] for i in (1, 2, 3)] == [near(w) for w in told[f"shares_{end}_kgm"]]
        assert abs(found[f"W_b{end}"]) == near(told[f"W_b{end}_kgm"]) and found[f"m_b{end}"] == near(
            told[f"m_b{end}_kg"]
        )
        assert found[f"theta_b{end}"] == near(told[f"at_{end}_deg"])
    assert abs(found["W_S"]) == near(told["static_unbalance_kgm"]) and not found["static"] and not found["dynamic"]


def test_dalbys_arcs_meet_twice_and_both_answers_are_told() -> None:
    found = agree(dalby())
    assert [found[f"C_{name}"] for name in "BCD"] == [near(c) for c in CASES["A08"]["results"]["couples_kgm2"]]
    for which, told in enumerate(CASES["A08"]["results"]["solutions"], 1):
        assert found[f"m_A_{which}"] == near(told["m_A_kg"])
        for name in "ACD":
            assert found[f"theta_{name}_{which}"] == near(told[f"theta_{name}_deg"])


def test_a_grade_is_split_by_the_centre_of_mass_and_judged_by_a_circle() -> None:
    told, found = CASES["A11"]["results"], agree(grade())
    assert found["e_per"] == near(told["e_per_um"]) and found["U_per"] == near(told["U_per_gmm"])
    assert found["U_perI"] == near(told["U_perI_gmm"]) and found["U_perII"] == near(told["U_perII_gmm"])
    assert bool(found["within_I"]) is told["I_within"] and bool(found["within_II"]) is told["II_within"]
    assert abs(found["W_S"]) == near(told["residual_resultant_gmm"])


@pytest.mark.parametrize(
    ("cranks", "static", "dynamic", "said"),
    [
        ((0.0, 90.0, 270.0, 180.0), True, False, "couple unbalance"),
        ((0.0, 180.0, 180.0, 0.0), True, True, "in dynamic balance"),
        ((0.0, 180.0, 0.0, 180.0), True, False, "couple unbalance"),
        ((0.0, 0.0, 0.0, 0.0), False, False, r"quasi-static unbalance, one product at $z$ = 450 mm"),
        ((0.0, 90.0, 0.0, 0.0), False, False, "a dynamic unbalance"),
    ],
)
def test_the_kind_of_unbalance_is_told(cranks: tuple[float, ...], static: bool, dynamic: bool, said: str) -> None:
    masses = lumps(*((1.0, at, 300.0 * i) for i, at in enumerate(cranks)))
    rotor = device("rotor", masses=masses, correct=planes(0.0, 900.0))
    construction = drawn(rotor)
    assert (bool(construction.readings["static"].scalar), bool(construction.readings["dynamic"].scalar)) == (
        static,
        dynamic,
    )
    assert said in " ".join(step.words.en for step in construction.steps)
    assert agree(rotor)["static"] == static


def test_four_cranks_leave_a_couple_of_the_square_root_of_ten() -> None:
    found = agree(
        device("rotor", masses=lumps((1, 0, 0), (1, 90, 300), (1, 270, 600), (1, 180, 900)), correct=planes(0, 900))
    )
    assert abs(found["W_bI"]) == pytest.approx(10**0.5 / 3) and found["theta_bI"] == pytest.approx(198.4349488)
    assert abs(found["W_bII"]) == pytest.approx(10**0.5 / 3) and found["theta_bII"] == pytest.approx(18.4349488)


@settings(max_examples=often(5), deadline=None)
@given(
    masses=st.lists(st.tuples(st.floats(0.2, 3), st.floats(0, 360), st.floats(-400, 1400)), min_size=1, max_size=6),
    first=st.floats(-200, 300),
    span=st.floats(300, 1200),
)
def test_what_two_planes_take_leaves_no_force_and_no_couple(
    masses: list[tuple[float, float, float]], first: float, span: float
) -> None:
    found = agree(device("rotor", masses=lumps(*masses), correct=planes(first, first + span)), within=1e-8)
    added = [(found[f"W_b{end}"], z) for end, z in (("I", first), ("II", first + span))]
    vectors = [(rect(w, radians(at)), z) for w, at, z in masses] + added
    assert abs(sum(w for w, _ in vectors)) < 1e-9 * sum(abs(w) for w, _ in vectors)
    assert abs(sum(w * (z - 77.0) for w, z in vectors)) < 1e-8 * sum(abs(w) * 1e3 for w, _ in vectors)


@settings(max_examples=often(10), deadline=None)
@given(
    unbalance=st.floats(100, 900),
    at=st.floats(0, 359),
    pitch=st.sampled_from([20, 30, 40, 45, 60, 72, 90]),
    only=st.sampled_from(["add", "remove"]),
)
def test_neighbouring_places_share_a_correction_with_two_weights_that_are_added_or_removed(
    unbalance: float, at: float, pitch: int, only: str
) -> None:
    beside, sign = (at + 180, 1) if only == "add" else (at, -1)
    assume(0.01 < beside % pitch < pitch - 0.01)
    plane = {"r": "80 mm", "places": f"{pitch} deg", "only": only}
    found = agree(
        device("rotor", masses={"1": {"U": f"{unbalance!r} g*mm", "at": f"{at!r} deg"}}, correct={"I": plane})
    )
    shares = [rect(found[f"W_b_{i}"], radians(found[f"theta_b_{i}"])) for i in (1, 2)]
    assert min(sign * found["W_b_1"], sign * found["W_b_2"]) > 0
    assert abs(sum(shares) + rect(unbalance, radians(at))) < 1e-7 * unbalance


def test_rounded_weights_leave_a_residual_that_is_judged_by_its_circle() -> None:
    tolerance = {"G": "2.5 mm/s", "mass": "4 kg", "n": "1500 r/min"}
    plane = {"r": "95 mm", "places": "30 deg", "step": "0.5 g"}
    masses = {"1": {"U": "860 g*mm", "at": "287 deg"}}
    found = agree(device("rotor", masses=masses, correct={"I": plane}, tolerance=tolerance))
    left = rect(860, radians(287)) + 95 * (rect(4.0, radians(90)) + rect(5.5, radians(120)))
    assert abs(found["W_r"] - left) < 1e-6 and found["within"] == 1.0
    rough = agree(device("rotor", masses=masses, correct={"I": plane | {"step": "5 g"}}, tolerance=tolerance))
    assert rough["within"] == 0.0 and abs(rough["W_r"]) > rough["U_per"]


@settings(max_examples=often(8), deadline=None)
@given(arm=st.floats(0.3, 2), size=st.floats(0.3, 2), at=st.floats(5, 175), other=st.floats(190, 350))
def test_dalby_finds_masses_of_known_directions_and_a_mass_beside_an_angle(
    arm: float, size: float, at: float, other: float
) -> None:
    known = {"m": f"{size!r} kg", "r": "1 m", "at": "0 deg", "z": "1 m"}
    masses = {
        "A": {"m": "?", "r": "1 m", "at": "?", "z": "0 m"},
        "B": known,
        "C": {"m": "?", "r": "1 m", "at": f"{at!r} deg", "z": f"{arm!r} m"},
        "D": {"m": "?", "r": "1 m", "at": f"{other!r} deg", "z": "-1 m"},
    }
    assume(abs((other - at) % 180) > 5 and abs((other - at) % 180) < 175)
    found = agree(device("rotor", masses=masses), within=1e-8)
    vectors = {
        "A": rect(found["m_A"], radians(found["theta_A"])),
        "B": size + 0j,
        "C": rect(found["m_C"], radians(at)),
        "D": rect(found["m_D"], radians(other)),
    }
    z = {"A": 0.0, "B": 1.0, "C": arm, "D": -1.0}
    assert abs(sum(vectors.values())) < 1e-7 * sum(map(abs, vectors.values()))
    assert abs(sum(w * z[name] for name, w in vectors.items())) < 1e-7 * sum(map(abs, vectors.values()))


def test_directions_are_told_from_0_to_360() -> None:
    found = agree(device("rotor", masses=lumps((1, 100, 0)), correct={"I": {"r": "1 m"}}))
    assert found["theta_b"] == pytest.approx(280.0) and degrees(phase(found["W_b"])) == pytest.approx(-80.0)


@pytest.mark.parametrize("by", ["exact", "drafting", "pencil"])
def test_a_rotor_in_balance_is_told_so_by_every_hand_and_has_no_directions(by: str) -> None:
    cranks = [
        f"    {i + 1}: {{m: 5 kg, r: 100 mm, at: {at} deg, z: {150 * i} mm}}" for i, at in enumerate((0, 180, 180, 0))
    ]
    planes_ = "  correct: {I: {z: 0 mm, r: 100 mm}, II: {z: 450 mm, r: 100 mm}}"
    text = "\n".join(["id: x", "title: x", "device: rotor", "data:", "  masses:", *cranks, planes_])
    solution = solve(loads(text), by=by, seed=3)
    assert not solution.suspect and solution.answers["static"].drawn == solution.answers["dynamic"].drawn == 1.0
    assert solution.answers["theta_bI"].undefined and solution.answers["theta_bII"].undefined


def test_the_permitted_circle_the_rounded_weights_and_what_they_leave_are_named_on_the_polygon() -> None:
    construction = load("rotor-bolt-circle").solve(by="exact").construction
    figure = next(f for f in construction.figures if f.view is view_named("unbalances"))
    assert figure.scale.symbol == "μ_W"
    arrows = {mark.label for mark in figure.marks if isinstance(mark, Vector)}
    letters = {mark.label for mark in figure.marks if isinstance(mark, Point)}
    assert {"W′_{b,1}", "W′_{b,2}", "W_{r}"} <= arrows and "" not in arrows
    (end,) = re.findall(r"to their end \$(\w)\$", " ".join(step.words.en for step in construction.steps))
    assert {"U_{per}", end} <= letters


@pytest.mark.parametrize("name", ["6-4", "6-5", "6-6", "6-7", "engine-three", "engine-four"])
def test_no_letter_stands_on_two_polygons_of_a_sheet(name: str) -> None:
    """The d of plane I was also that of the couples."""
    figures = solve(load(name), repeats=0, precise=False).construction.figures
    polygons = [one for one in figures if one.view.name in ("products", "unbalances", "couples")]
    letters = [{mark.label for mark in one.marks if isinstance(mark, Point)} - {"O", ""} for one in polygons]
    assert len(letters) > 1 and sum(map(len, letters)) == len(set[str]().union(*letters))
