"""Inflection circles, centres of curvature, centrodes against answers found without this program."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import vecpoly
from tests.at_once import exactly
from tests.curvature.linkages import DATA, WAYS, case_problem
from tests.laws import few
from vecpoly.board.paper.marks import Point
from vecpoly.check.truth import exact_values
from vecpoly.errors import NoMethodError
from vecpoly.oracle.curvature import Curvatures

LINKS = DATA["links"]
SHEETS = [case for case in LINKS if "offpaper" not in case["id"]]


def mm(pair: list[float]) -> complex:
    """A place of the data in m."""
    return complex(*pair) / 1e3


def expected(case: dict[str, Any]) -> dict[str, complex | float]:
    """The answers of a case under their keys (m)."""
    found: dict[str, complex | float] = {f"{key}_2": mm(case[key]) for key in ("W", "Wr")}
    found |= {"P_24": mm(case["P"]), "delta_2": case["delta"] / 1e3}
    for letter, path in zip("EF", case["paths"].values(), strict=False):
        found |= {f"p_O{letter}": mm(path["centre"]), f"rho_{letter}": path["rho"] / 1e3}
    return found


@pytest.mark.parametrize("case", LINKS, ids=lambda case: case["id"])
def test_the_oracle_has_every_pole_circle_and_centre_of_the_cases(case: dict[str, Any]) -> None:
    values = exact_values(case_problem(case))
    wanted = expected(case)
    assert values.keys() == wanted.keys()
    assert max(abs(values[key] - wanted[key]) for key in wanted) < 2e-12


@pytest.mark.parametrize("case", few(SHEETS, 4), ids=lambda case: case["id"])
@pytest.mark.parametrize("way", WAYS)
def test_every_construction_draws_what_the_rates_tell(case: dict[str, Any], way: str) -> None:
    problem = case_problem(case, way)
    if way == "aronhold" and "CD" in case:
        with pytest.raises(NoMethodError, match="hinges only"):
            problem.solve(by="exact")
        return
    answers = exactly(problem).answers
    for key, value in expected(case).items():
        drawn = answers[key].drawn_vector if isinstance(value, complex) else answers[key].drawn
        assert drawn == pytest.approx(value, abs=1e-9), key


@pytest.mark.parametrize("case", SHEETS, ids=lambda case: case["id"])
def test_a_drafting_hand_keeps_within_what_is_expected_of_it(case: dict[str, Any]) -> None:
    solution = case_problem(case).solve(by="drafting")
    assert solution.answers and not any(answer.suspect for answer in solution.answers.values())


@pytest.mark.parametrize("case", LINKS, ids=lambda case: case["id"])
def test_the_pole_changes_its_place_at_omega_times_delta(case: dict[str, Any]) -> None:
    here = Curvatures(case_problem(case).mechanism, "2")
    assert here.pole_velocity * case["ratio"] == pytest.approx(mm(case["u"]), rel=2e-9)
    assert abs(here.pole_velocity) == pytest.approx(case["delta"] / 1e3, rel=1e-11)


def four_bar(phi: float, find: str, lengths: tuple[float, float, float, float] = (40, 90, 70, 100)) -> vecpoly.Problem:
    """A four-bar of which centrodes or the collineation axis are asked."""
    ab, bc, cd, ad = lengths
    return vecpoly.loads(f"""
id: four-bar
title: four-bar
frame: {{A: [0 mm, 0 mm], D: [{ad} mm, 0 mm]}}
links: {{1: {{AB: {ab} mm}}, 2: {{BC: {bc} mm}}, 3: {{DC: {cd} mm}}}}
branch: [C {"right" if ab == cd else "left"} of BD]
input: {{link: 1, phi: {phi} deg, omega: ccw}}
method: curvature
find: [{find}]
""")


@pytest.mark.parametrize("point", DATA["centrode"]["points"][:4], ids=lambda one: str(one["phi"]))
def test_the_poles_of_a_coupler_lie_on_both_centrodes(point: dict[str, Any]) -> None:
    problem = four_bar(point["phi"], "P_24")
    pole = exact_values(problem)["P_24"]
    assert pole == pytest.approx(mm(point["P_fixed"]), abs=1e-11)
    body = Curvatures(problem.mechanism, "2").body
    moving = complex(((pole - body.at) * np.conj(body.unit))[0])
    assert moving == pytest.approx(mm(point["P_moving_in_BC_frame"]), abs=1e-11)


def test_chords_of_both_centrodes_come_near_to_the_one_arc() -> None:
    find = "{centrodes: 2, positions: 24, over: [20 deg, 40 deg]}"
    answers = four_bar(30, find).solve(by="exact").answers
    arc = DATA["centrode"]["arc"] / 1e3
    for key in ("L_f2", "L_m2"):
        assert answers[key].drawn == pytest.approx(answers[key].exact, rel=1e-9)
        assert answers[key].exact == pytest.approx(arc, rel=1e-5)


@pytest.mark.parametrize("name", ["curv-5", "curv-6"])
def test_every_pole_of_a_centrode_has_its_number_and_no_letter_of_another_centre(name: str) -> None:
    """P_12 is the instant centre of links 1 and 2: the poles of positions are Q_1, Q_2, told from where to where."""
    problem = vecpoly.load(name)
    asked = problem.curvature.centrodes if problem.curvature is not None else None
    assert asked is not None
    drawn = problem.solve().construction
    labels = [mark.label for figure in drawn.figures for mark in figure.marks if isinstance(mark, Point)]
    poles = {f"Q{prime}_{{{k}}}" for prime in ("", "^{′}") for k in range(1, asked.positions + 1)}
    assert sorted(one for one in labels if one.startswith("Q")) == sorted(poles)
    assert {one for one in labels if one.startswith("P")} == {"P_{24}"}
    (said,) = [step.words for step in drawn.steps if f"$Q_{{{asked.positions}}}$" in step.words.en]
    start, end = (f"{np.degrees(at):.0f}°" for at in (asked.start, asked.end))
    assert f"$φ_{{1}}$ = {start} to {end}" in said.en and f"$φ_{{1}}$ = {start} 到 {end}" in said.zh


@pytest.mark.parametrize("point", DATA["antiparallelogram"]["points"], ids=lambda one: str(one["phi"]))
def test_the_centrode_of_an_antiparallelogram_is_a_hyperbola_about_its_pivots(point: dict[str, Any]) -> None:
    pole = exact_values(four_bar(point["phi"], "P_24", (40, 90, 40, 90)))["P_24"]
    assert pole == pytest.approx(mm(point["P"]), abs=1e-11)
    assert abs(abs(pole) - abs(pole - 0.09)) == pytest.approx(point["difference"] / 1e3, abs=1e-12)


@pytest.mark.parametrize("extreme", DATA["freudenstein"], ids=lambda one: str(round(one["phi"])))
def test_at_an_extreme_of_the_ratio_the_collineation_axis_stands_on_the_coupler(extreme: dict[str, Any]) -> None:
    problem = four_bar(extreme["phi"], "lambda_2", (30, 80, 60, 90))
    assert exact_values(problem)["lambda_2"] == pytest.approx(90.0, abs=1e-4)
    turned = exact_values(problem.vary(phi=f"{extreme['phi'] + 20} deg"))["lambda_2"]
    assert abs(turned) < 85.0


def test_the_cardan_circle_is_the_inflection_circle_of_a_trammel() -> None:
    values, true = exact_values(vecpoly.load("curv-7")), DATA["cardan"]
    assert values["W_2"] == pytest.approx(0, abs=1e-12)
    assert values["delta_2"] * 1e3 == pytest.approx(true["inflection_circle"]["diameter"], rel=1e-9)
    assert values["p_OE"] == pytest.approx(mm(true["centre"]), abs=1e-11)


def rolling(case: dict[str, Any], way: str = "euler-savary") -> vecpoly.Problem:
    """A gear that rolls on a fixed rack, or inside a fixed ring."""
    arm, radius = case["lambda_"] * case["r"], case["r"]
    e = f"E: {{BE: {arm} mm, angle: {case['alpha']} deg}}"
    x, y = case["O"]
    body = (
        f"""frame: {{A: [0 mm, 0 mm]}}
links: {{1: {{AB: {abs(complex(x, y))} mm}}, 2: {{gear: B, radius: {radius} mm, {e}}}}}
joints: [2 rolls inside circle about A of {case["R"]} mm at H]
input: {{link: 1, phi: -90 deg, omega: ccw}}"""
        if case["R"]
        else f"""frame: {{A: [-50 mm, 0 mm]}}
links: {{1: {{block: B}}, 2: {{gear: B, radius: {radius} mm, {e}}}}}
joints: [1 slides on y = {y} mm, 2 rolls on y = 0 mm at H]
input: {{link: 1, s: {x} mm, v: 1 m/s}}"""
    )
    return vecpoly.loads(f"""
id: rolling
title: rolling
{body}
method: curvature
construction: {way}
find: [P_23, W_2, delta_2, p_OE, rho_E]
""")


@pytest.mark.parametrize("case", DATA["rolling"], ids=lambda case: case["id"])
def test_a_rolling_gear_has_its_pitch_point_for_pole_and_the_known_diameter(case: dict[str, Any]) -> None:
    values = exact_values(rolling(case))
    wanted = {"P_23": mm(case["P"]), "W_2": mm(case["W"]), "p_OE": mm(case["centre"])}
    assert max(abs(values[key] - wanted[key]) for key in wanted) < 1e-10
    assert values["delta_2"] == pytest.approx(case["diameter"] / 1e3, rel=1e-11)
    assert values["rho_E"] == pytest.approx(case["rho"] / 1e3, rel=1e-9)


def test_a_rolling_gear_is_drawn_by_euler_and_savary_and_by_no_other() -> None:
    case = next(one for one in DATA["rolling"] if not one["R"])
    answers = rolling(case).solve(by="exact").answers
    assert answers["p_OE"].drawn_vector == pytest.approx(mm(case["centre"]), abs=1e-10)
    assert answers["rho_E"].drawn == pytest.approx(case["rho"] / 1e3, rel=1e-9)
    with pytest.raises(NoMethodError, match="use construction: euler-savary"):
        rolling(case, "bobillier").solve()


@pytest.mark.parametrize("case", SHEETS, ids=lambda case: case["id"])
def test_the_acceleration_pole_is_found_beside_the_curvatures(case: dict[str, Any]) -> None:
    problem = case_problem(case, find=("delta_2", "{point: G2, on: 2, acceleration: 0}"))
    answers = exactly(problem).answers
    assert answers["p_G2"].drawn_vector == pytest.approx(mm(case["acceleration_pole"]), abs=1e-9)


@pytest.mark.parametrize("way", WAYS[:3])
def test_the_collineation_axis_is_drawn_once_by_whatever_construction(way: str) -> None:
    case = next(one for one in LINKS if one["id"] == "B-fb-1")
    solution = case_problem(case, way, ("lambda_2", "rho_E")).solve(by="exact")
    assert solution.answers["lambda_2"].drawn == pytest.approx(solution.answers["lambda_2"].exact, abs=1e-9)
    assert sum("共线轴" in step.words.zh and "交于" in step.words.zh for step in solution.construction.steps) == 1


def test_the_pivot_that_a_rod_passes_lies_on_its_return_circle() -> None:
    values = exact_values(vecpoly.load("curv-4"))
    middle = (values["P_24"] + values["Wr_2"]) / 2
    assert abs(0.07 - middle) == pytest.approx(abs(values["delta_2"]) / 2, rel=1e-11)


def test_who_lays_an_angle_off_to_the_other_side_gets_other_curvatures() -> None:
    problem = vecpoly.load("curv-1")
    wrong = next(slip for slip in vecpoly.slips(problem) if str(slip) == "ψE other meeting")
    right, off = problem.solve(by="exact"), vecpoly.solve(problem, by="exact", slip=wrong)
    assert abs(off.answers["rho_E"].drawn - right.answers["rho_E"].drawn) > 0.01
    assert off.answers["delta_2"].drawn == pytest.approx(right.answers["delta_2"].drawn, rel=1e-12)
