"""Flywheels by areas: drawn, exact, worked out elsewhere; what cannot run uniformly is refused with its numbers."""

from __future__ import annotations

import re
from math import degrees, pi, tau
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from tests.cam_cases import agree, drawn
from tests.drawn_library import drawn as of_library
from tests.flywheels import CASES, pairs, rimmed, two_stroke, wheel
from tests.laws import often
from vecpoly import slips
from vecpoly.algebra.formula import plain
from vecpoly.board.acts import Area, Way
from vecpoly.board.otherwise.slip import Mistake
from vecpoly.board.paper.marks import Segment, Vector
from vecpoly.errors import FaultError, ProblemFileError, UnknownNameError
from vecpoly.figures.torque import TORQUE
from vecpoly.grading.derive.keyed import answer_key
from vecpoly.grading.student import check_answers
from vecpoly.oracle.devices.registry import device_answers
from vecpoly.problem.load import load, loads
from vecpoly.solution import solve

NEAR = 1e-8


def test_a_polygonal_diagram_gives_the_worked_flywheel() -> None:
    found, told = agree(two_stroke()), CASES["B14"]["results"]
    assert found["M_r"] == pytest.approx(told["M_r_Nm"], rel=NEAR)
    assert [found["phi_b"], found["phi_c"]] == pytest.approx(told["crossings_deg"], rel=NEAR)
    assert found["W_2"] == pytest.approx(told["dW_max_J"], rel=NEAR)
    assert found["W_1"] + found["W_3"] == pytest.approx(-told["dW_max_J"], rel=NEAR)
    for key, name in (("dW_max", "dW_max_J"), ("J_need", "J_needed"), ("J_F", "J_F"), ("P", "P_kW")):
        assert found[key] == pytest.approx(told[name], rel=NEAR), key
    assert (found["phi_max"], found["phi_min"]) == pytest.approx((told["phi_wmax_deg"], told["phi_wmin_deg"]))
    assert (found["n_max"], found["n_min"]) == pytest.approx((told["n_max_rpm"], told["n_min_rpm"]))


def test_six_given_areas_give_the_worked_bar_flywheel_and_rim() -> None:
    found, told = agree(rimmed()), CASES["B11"]["results"]
    assert {key: found[f"E_{key}"] for key in "bcdef"} == pytest.approx({key: told["levels_J"][key] for key in "bcdef"})
    names = {"dW_max": "dW_max_J", "J_F": "J_F", "GD2": "GD2_Nm2", "m_rim": "rim_mass_kg", "h": "h_mm", "b": "b_mm"}
    for key, name in (names | {"v_rim": "rim_speed_m_s", "J_rim": "J_of_this_rim_exact"}).items():
        assert found[key] == pytest.approx(told[name] * (1e-3 if name.endswith("_mm") else 1), rel=NEAR), key
    assert bool(found["v_allowed"]) is told["speed_ok"]


@pytest.mark.parametrize(
    ("name", "keys"),
    [
        ("7-4", {"dW_max": "dW_max_J", "J_F": "J_crank_kgm2", "J_F2": "J_motor_kgm2"}),
        ("7-5", {"M_r": "M_r_Nm", "phi_min": "phi_min_deg", "phi_max": "phi_max_deg", "dW_max": "dW_max_J"}),
        ("7-6", {"dW_max": "dW_max_Nm", "delta": "delta", "n_max": "n_max_rpm", "n_min": "n_min_rpm"}),
    ],
)
def test_an_exercise_of_the_book_has_its_numbers(name: str, keys: dict[str, str]) -> None:
    answers, told = solve(load(name), by="exact").answers, CASES[name]["results"]
    for key, other in keys.items():
        assert answers[key].drawn == pytest.approx(told[other], rel=NEAR), key


def test_the_mean_power_of_the_shaper_is_that_of_its_strokes() -> None:
    assert solve(load("7-4"), by="exact").answers["P"].drawn == pytest.approx(2.5739, rel=NEAR)


@pytest.mark.parametrize("by", ["drafting", "pencil"])
@pytest.mark.parametrize("name", ["7-4", "7-5", "7-6"])
def test_an_unsteady_hand_stays_within_its_expected_error(name: str, by: str) -> None:
    solution = solve(load(name), by=by, seed=3)
    assert not solution.suspect
    answer = solution.answers["dW_max"]
    assert abs(answer.drawn - answer.exact) <= answer.expected_error < 0.06 * answer.exact


def test_the_areas_that_decide_can_be_counted() -> None:
    for name in ("7-4", "7-5"):
        areas = [act for act in solve(load(name)).construction.acts if isinstance(act, Area) and act.key[0] == "A"]
        assert max(act.mm2 for act in areas) > 400 and all(act.way is Way.SQUARES for act in areas)


def test_a_planimeter_is_taken_where_it_is_asked_for() -> None:
    ways = {act.way for act in drawn(wheel(M_d=TRIANGLE, measured="planimeter")).acts if isinstance(act, Area)}
    assert ways == {Way.PLANIMETER}


TRIANGLE = pairs([[0, 0], [90, 100], [180, 0]])


def test_somebodys_own_area_shifts_the_work_and_all_that_follows() -> None:
    own = solve(load("7-5"), by="exact", repeats=0, precise=False, readings={"A_2": "1500 mm^2"}).answers
    plain = solve(load("7-5"), by="exact", repeats=0, precise=False).answers
    assert own["dW_max"].drawn > plain["dW_max"].drawn and own["J_F"].drawn > plain["J_F"].drawn
    assert own["M_r"].drawn == plain["M_r"].drawn


@pytest.mark.parametrize("reading", [{"A_2": "1500 mm"}, {"O b": "12 mm^2"}])
def test_a_reading_of_another_kind_is_refused(reading: dict[str, str]) -> None:
    with pytest.raises(FaultError, match=r"is not an area|is not a length"):
        solve(load("7-5"), by="exact", repeats=0, precise=False, readings=reading)
    with pytest.raises(UnknownNameError):
        solve(load("7-5"), by="exact", repeats=0, precise=False, readings={"A_9": "5 mm^2"})


@pytest.mark.parametrize(
    ("mistake", "key", "factor"), [(Mistake.DEGREES, "mu_A", 180 / pi), (Mistake.PER_MINUTE, "omega_m", 1.0)]
)
def test_degrees_for_radians_and_speed_for_angular_velocity_are_slips(
    mistake: Mistake, key: str, factor: float
) -> None:
    problem = load("7-5")
    (slip,) = (one for one in slips(problem) if one.mistake is mistake)
    assert slip.key == key
    wrong, right = (solve(problem, by="exact", repeats=0, precise=False, slip=one).answers for one in (slip, None))
    assert wrong["dW_max"].drawn == pytest.approx(factor * right["dW_max"].drawn, rel=1e-6)
    share = factor if mistake is Mistake.DEGREES else (pi / 30) ** 2
    assert wrong["J_F"].drawn == pytest.approx(share * right["J_F"].drawn, rel=1e-6)


def same_signs() -> str:
    return """
id: x
title: x
device: flywheel
data: {areas: [300, 200, -450, -50], mu_A: 10 J/mm^2, n: 600 r/min, J: 5 kg*m^2}
find: [dW_max, E_c]
"""


def test_neighbours_of_one_sign_are_no_crossing_and_to_count_one_is_a_slip() -> None:
    problem = loads(same_signs())
    right = solve(problem, by="exact", repeats=0, precise=False).answers
    assert right["dW_max"].drawn == pytest.approx(5000)
    counted = [one for one in slips(problem) if one.mistake is Mistake.COUNTED]
    assert [one.key for one in counted] == ["b", "d"]
    wrong = solve(problem, by="exact", repeats=0, precise=False, slip=counted[0]).answers
    assert wrong["dW_max"].drawn != pytest.approx(5000, rel=0.01)


def test_work_left_over_a_period_is_refused_with_the_change_per_turn() -> None:
    told = CASES["R04"]
    with pytest.raises(ValueError, match=r"-62\.8319 J"):
        wheel(M_d=f"{told['inputs']['M_d_Nm']} N*m", M_r=pairs(told["inputs"]["M_r"]))
    assert told["results"]["dW_per_turn_J"] == pytest.approx(-62.8318531)


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"M_d": "100 N*m", "M_r": "100 N*m"}, "both constant"),
        ({"M_d": TRIANGLE, "areas": ["3", "-3"]}, "only one"),
        ({"areas": ["320", "-200"], "mu_A": "1 J/mm^2"}, r"\+120 J \(\+120 mm²\)"),
        ({"areas": ["320", "-320"]}, "go with their scale"),
        ({"M_d": pairs([[10, 0], [90, 1]])}, "begins at 10 deg"),
        ({"M_d": pairs([[0, 0], [90, 1], [80, 1]])}, "place 3, 80 deg"),
        ({"M_d": TRIANGLE, "period": "360 deg"}, "period of 360 deg"),
        ({"M_d": TRIANGLE, "delta": "1.5"}, "between 0 and 1"),
        ({"M_d": TRIANGLE, "delta": None}, "delta or J is missing"),
        ({"M_d": pairs([[0, 5], [360, 5]])}, "speed does not vary"),
        ({"powers": [["90 deg", "368 W"], ["90 deg", "368 W"]]}, "speed does not vary"),
        ({"M_d": TRIANGLE, "delta": None, "J": "1e-4 kg*m^2"}, r"not below 2.*machine stops; J must exceed"),
        ({"M_d": TRIANGLE, "rim": {"D": "30 mm", "b/h": "1.5", "density": "7300 kg/m^3"}}, "D must exceed"),
        ({"M_d": pairs([[0, 0], [90, 1], [90, 2], [90, 3], [360, 0]])}, "three or more moments stand at 90 deg"),
        ({"M_d": {"columns": ["phi", "M (N*m)"], "rows": [["0", "1"]]}}, "must name an angle"),
    ],
)
def test_data_that_make_no_flywheel_are_refused_with_the_reason(data: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        wheel(**data)


def test_the_least_inertia_that_is_told_is_that_with_which_the_slowest_speed_vanishes() -> None:
    with pytest.raises(ValueError, match="machine stops") as refused:
        wheel(M_d=TRIANGLE, delta=None, J="1e-4 kg*m^2")
    least = refused.value.errors()[0]["ctx"]["error"].numbers["J"]  # type: ignore[attr-defined]
    found = agree(wheel(M_d=TRIANGLE, delta=None, J=f"{1.001 * least:.9g} kg*m^2"))
    assert 0 < found["n_min"] < 1


def test_idle_strokes_take_no_power_and_equal_extremes_are_told_with_all_their_places() -> None:
    halves = [["90 deg", "0 W"], ["90 deg", "300 W"]] * 2
    shaper = wheel(powers=halves)
    found = agree(shaper)
    assert found["dW_max"] == pytest.approx(150 / (600 * tau / 60) * pi / 2)
    assert (found["phi_max"], found["phi_min"]) == (90, 0)
    assert [one.en for one in shaper.noted({"phi_max", "phi_min", "dW_max"})] == [
        "the speed is greatest at b, d alike; phi_max tells the first of them",
        "the speed is least at a, c alike; phi_min tells the first of them",
    ]
    assert not two_stroke().noted({"phi_max", "phi_min"})


def test_enough_inertia_needs_no_flywheel_and_tells_its_delta() -> None:
    found = agree(wheel(M_d=TRIANGLE, J="50 kg*m^2"))
    assert found["J_F"] == 0 and 0 < found["delta"] < 0.02
    steps = drawn(wheel(M_d=TRIANGLE, J="50 kg*m^2")).steps
    assert any("no flywheel is needed" in step.words.en for step in steps)


def test_a_table_lies_beside_the_problem(tmp_path: Any) -> None:
    (tmp_path / "m.csv").write_text("phi (deg), M (N*m)\n0, 0\n90, 100\n180, 0\n", encoding="utf-8")
    file = tmp_path / "x.yaml"
    text = "id: x\ntitle: x\ndevice: flywheel\ndata: {M_d: {table: m.csv}, n: 600 r/min, delta: 0.02}\n"
    file.write_text(text, encoding="utf-8")
    assert load(file).device == wheel(
        M_d={"table": "m.csv", "columns": ["phi (deg)", "M (N*m)"], "rows": [["0", "0"], ["90", "100"], ["180", "0"]]}
    )
    (tmp_path / "m.csv").write_text("phi (deg), M (N*m)\n0, 0\n90\n", encoding="utf-8")
    with pytest.raises(ProblemFileError, match=r"line 4.*row 3 has 1 columns"):
        load(file)


MOMENT = st.integers(-200, 500)


@st.composite
def diagrams(draw: st.DrawFn) -> list[list[float]]:
    """Corners at random places of a period, some of them jumps."""
    inner = sorted(draw(st.lists(st.integers(5, 355), min_size=1, max_size=8, unique=True)))
    rows: list[list[float]] = [[0, draw(MOMENT)]]
    for phi in inner:
        rows.append([phi, draw(MOMENT)])
        if draw(st.booleans()):
            rows.append([phi, draw(MOMENT)])
    return [*rows, [360, draw(MOMENT)]]


def integral(rows: list[list[float]], mean: float) -> np.ndarray[Any, np.dtype[np.float64]]:
    """The running work, by very many steps."""
    phi, moment = np.radians([row[0] for row in rows]), np.array([row[1] for row in rows])
    fine = np.linspace(0, tau, 200_001)
    middle = (fine[1:] + fine[:-1]) / 2
    return np.cumsum((np.interp(middle, phi, moment) - mean) * np.diff(fine))


@given(diagrams())
@settings(max_examples=often(5))
def test_drawn_and_exact_agree_with_very_many_small_steps(rows: list[list[float]]) -> None:
    moments = [row[1] for row in rows]
    if max(moments) - min(moments) < 5:
        return
    found = agree(wheel(M_d=pairs(rows)), within=1e-8)
    energy = integral(rows, found["M_r"])
    assert energy[-1] == pytest.approx(0, abs=0.05)
    assert found["dW_max"] == pytest.approx(float(np.ptp(np.r_[0, energy])), abs=0.1)
    turning = [0.0, *(value for key, value in found.items() if key.startswith("phi_")), 360.0]
    assert found["phi_max"] in turning and degrees(tau) >= found["phi_max"] >= 0


def test_every_refusal_of_a_flywheel_names_no_machinery() -> None:
    with pytest.raises(ValueError) as caught:
        wheel(M_d="3")
    assert re.search(r"N\*m", str(caught.value))
    assert device_answers(wheel(M_d=TRIANGLE))["M_r"] == pytest.approx(50)


def test_the_motion_simulated_with_the_flywheel_has_the_demanded_delta() -> None:
    told = CASES["B14"]["inputs"]
    found = device_answers(two_stroke())
    phi, moment = np.radians([row[0] for row in told["M_d"]]), np.array([row[1] for row in told["M_d"]])
    inertia = abs(found["J_F"]) + told["J_other"]

    def flow(at: float, omega: Any) -> list[float]:
        return [(np.interp(at % tau, phi, moment) - abs(found["M_r"])) / (inertia * omega[0])]

    start = told["n_rpm"] * pi / 30
    for _ in range(3):  # the mean of the extremes is to be n
        run = solve_ivp(flow, (0, tau), [start], max_step=0.01, rtol=1e-10, atol=1e-10)
        start += told["n_rpm"] * pi / 30 - (run.y.max() + run.y.min()) / 2
    assert 2 * np.ptp(run.y) / (run.y.max() + run.y.min()) == pytest.approx(told["delta"], rel=2e-4)
    assert degrees(run.t[int(np.argmax(run.y[0]))]) == pytest.approx(found["phi_max"], abs=0.6)
    assert run.y[0, -1] == pytest.approx(run.y[0, 0], abs=1e-3)


def test_a_graded_sheet_knows_the_areas_and_names_degrees_for_radians() -> None:
    key = answer_key(load("7-5"))
    areas = {one.key: one for one in key.quantities if one.unit == "mm^2"}
    assert set(areas) == {"S1", "A1", "A2", "A3"} and all(0 < one.allowed < 0.2 * one.exact for one in areas.values())
    told = str(check_answers(load("7-5"), {"dW_max": "5104", "J_F": "121"}))
    assert "mu_A" in told and re.search("degrees in place of radians|以度代弧度", told)


@pytest.mark.parametrize(("name", "difference"), [("7-6", "$E_{b}$ − $E_{e}$ = 3500 J"), ("flywheel-rim", "= 6480 J")])
def test_beside_exact_energies_the_swing_is_told_to_be_read(name: str, difference: str) -> None:
    remark = solve(load(name)).answers["dW_max"].reading.remark
    assert remark is not None and difference in remark.en and remark.en.startswith("read off the bar")


@pytest.mark.parametrize("name", ["7-4", "7-5", "7-6"])
def test_the_axes_of_a_diagram_reach_a_little_beyond_its_curves(name: str) -> None:
    for figure in (one for one in of_library(name).construction.figures if one.view is TORQUE):
        across, up = (mark.b for mark in figure.marks if isinstance(mark, Vector) and not mark.label)
        ends = [end for mark in figure.marks if isinstance(mark, Segment) for end in (mark.a, mark.b)]
        assert across.imag == 0 and 5 < across.real - max(end.real for end in ends) < 15, figure.name
        assert up.real == 0 and 5 < up.imag - max(end.imag for end in ends) < 15, figure.name


def test_the_section_of_a_rim_goes_on_as_it_is_printed() -> None:
    lines = [plain(line) for step in of_library("rim-of-a-flywheel").construction.steps for line in step.formulas]
    (section,), (height,) = ([line for line in lines if line.startswith(f"{one} = ")] for one in "Sh")
    assert f"({section.rsplit(' = ', 1)[1].removesuffix(' m^2')})/(1.4)" in height


def test_a_deficit_has_a_negative_area_beside_its_work_and_lengths_of_a_rim_are_told_in_metres_first() -> None:
    construction = of_library("flywheel-rim").construction
    ((head, rows),) = [(one.listing.head, one.listing.rows) for one in construction.steps if one.listing is not None]
    area, work = ([one.zh.startswith(start) for one in head].index(True) for start in ("$A$", "$W$"))
    for row in rows[:-1]:
        assert float(row[area].replace("−", "-")) * 12 == float(row[work].replace("−", "-")), row
    lines = [plain(line) for step in construction.steps for line in step.formulas]
    (height,) = (line for line in lines if line.startswith("h = "))
    assert height.endswith(" = 0.2288 m = 228.8 mm")


def test_a_constant_moment_below_zero_is_told_to_drive() -> None:
    told = [step.words for step in of_library("constant-moment-below-zero").construction.steps]
    assert any("$M_r$ is negative: it drives" in words.en and "$M_r$ 为负" in words.zh for words in told)
    assert not any("is negative: it" in step.words.en for step in of_library("rim-of-a-flywheel").construction.steps)
