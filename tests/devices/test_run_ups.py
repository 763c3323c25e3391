"""Run-up, run-down and braking: drawn, exact, worked out elsewhere; what does not start is refused with its moments."""

from __future__ import annotations

from decimal import Decimal
from math import exp, log, pi, sqrt, tau
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.cam_cases import agree, device
from tests.cam_cases import drawn as paper
from tests.drawn_library import drawn
from tests.flywheels import CASES
from tests.laws import few, often
from vecpoly.board.paper.marks import Hatched, Note, Point, Segment
from vecpoly.devices.base import Device
from vecpoly.devices.dynamics.characteristic import Kloss
from vecpoly.errors import NotAskedError
from vecpoly.figures import View
from vecpoly.figures.characteristic import CHARACTERISTIC, INVERSE, SPEED
from vecpoly.methods.diagrams.strip import root, strips
from vecpoly.oracle.devices.registry import device_answers
from vecpoly.problem.load import load
from vecpoly.solution import solve


def run(**data: Any) -> Device:
    return device("run-up", **{"J": "2 kg*m^2"} | data)


def test_a_straight_characteristic_runs_up_as_it_was_worked_out() -> None:
    told, given = CASES["B16"]["results"], CASES["B16"]["inputs"]
    motor = [f"{given['a_Nm']} N*m", f"{given['b_Nms']} N*m*s"]
    found = agree(run(motor=motor, load=f"{given['M_r_Nm']} N*m", J=f"{given['J_e']} kg*m^2", at="2 s"))
    names = {"omega_s": "omega_s", "T": "time_constant_s", "t": "t95_s", "N": "turns_to_95", "omega_t": "omega_at_2s"}
    for key, name in names.items():
        assert found[key] == pytest.approx(told[name], rel=1e-8), key


def test_a_machine_runs_down_and_is_braked_as_it_was_worked_out() -> None:
    told, given = CASES["B18"]["results"], CASES["B18"]["inputs"]
    found = agree(
        run(
            load=[f"{given['dry_Nm']} N*m", f"{given['viscous_Nms']} N*m*s"],
            brake=f"{given['brake_Nm']} N*m",
            J=f"{given['J_e']} kg*m^2",
            start=f"{given['n0_rpm']} r/min",
        )
    )
    assert (found["t"], found["N"]) == pytest.approx((told["free"]["t_s"], told["free"]["turns"]), rel=1e-8)
    assert (found["t_b"], found["N_b"]) == pytest.approx((told["brake"]["t_s"], told["brake"]["turns"]), rel=1e-8)


def test_a_motor_too_weak_to_start_is_refused_with_both_moments() -> None:
    with pytest.raises(ValueError, match=r"75\.5437 N·m.* 120 N·m: it does not start") as caught:
        run(motor={"M_k": "200 N*m", "s_k": str(kloss_slip(75.5436856, 200)), "n_s": "1500 r/min"}, load="120 N*m")
    assert CASES["R08"]["results"]["M_start_Nm"] == pytest.approx(75.5436856) and caught


def kloss_slip(start: float, greatest: float) -> float:
    """Of 2 M_k / (1/s + s) = M_start the slip below 1."""
    half = greatest / start
    return half - sqrt(half**2 - 1)


@given(st.floats(50, 500), st.floats(0.2, 5), st.floats(1, 45), st.floats(0, 2), st.floats(0.1, 20), st.floats(50, 99))
@settings(max_examples=often(2))
def test_a_straight_run_up_follows_the_closed_formula(
    a: float, b: float, load: float, drag: float, inertia: float, share: float
) -> None:
    found = agree(
        run(
            motor=[f"{a} N*m", f"{b} N*m*s"],
            load=[f"{load} N*m", f"{drag} N*m*s"],
            J=f"{inertia} kg*m^2",
            to=f"{share} %",
        ),
        within=1e-8,
    )
    steady, constant = (a - load) / (b + drag), inertia / (b + drag)
    time = -constant * log(1 - share / 100)
    assert found["omega_s"] == pytest.approx(steady) and found["T"] == pytest.approx(constant)
    assert found["t"] == pytest.approx(time)
    assert found["N"] == pytest.approx(steady * (time - constant * share / 100) / tau)


@given(st.floats(0.05, 0.5), st.floats(1.0, 30.0), st.floats(0, 0.004))
@settings(max_examples=often(2))
def test_an_asynchronous_motor_reaches_its_speed_as_small_steps_do(slip: float, load: float, fan: float) -> None:
    found = agree(
        run(
            motor={"M_k": "300 N*m", "s_k": f"{slip}", "n_s": "1000 r/min"},
            load=[f"{load} N*m", "0 N*m*s", f"{fan} N*m*s^2"],
            to="90 %",
        ),
        within=1e-7,
    )
    omega = np.linspace(0, 0.9 * found["omega_s"], 50_001)
    s = 1 - omega / (1000 * pi / 30)
    surplus = 600 / (s / slip + slip / s) - load - fan * omega**2
    assert found["t"] == pytest.approx(float(np.trapezoid(2 / surplus, omega)), rel=1e-6)
    assert found["N"] == pytest.approx(float(np.trapezoid(2 * omega / surplus, omega)) / tau, rel=1e-6)


def test_a_measured_characteristic_has_corners_and_is_integrated_over_them() -> None:
    rows = [["0 rad/s", "100 N*m"], ["50 rad/s", "160 N*m"], ["80 rad/s", "0 N*m"]]
    found = agree(run(motor=rows, load="40 N*m", to="60 rad/s"))
    first, second = 2 * 50 / 60 * log(120 / 60), 2 * (30 / 160) * log(120 / (120 - 160 / 30 * 10))
    assert found["t"] == pytest.approx(first + second, rel=1e-9)


def test_a_constant_surplus_gives_a_constant_acceleration() -> None:
    found = agree(run(motor="50 N*m", load="10 N*m", to="100 rad/s", at="1.5 s"))
    assert (found["t"], found["N"], found["omega_t"]) == pytest.approx((5.0, 250 / tau, 30.0))


@pytest.mark.parametrize("name", ["motor-run-up", "run-down"])
@pytest.mark.parametrize("by", ["drafting", "pencil"])
def test_an_unsteady_hand_stays_within_its_expected_error(name: str, by: str) -> None:
    solution = solve(load(name), by=by, seed=5)
    assert not solution.suspect
    near = 0.03 if by == "drafting" else 0.2  # 95 % lies close to the crossing, where ΔM is a few millimetres
    assert all(one.expected_error < near * one.exact for one in solution.answers.values())


def test_the_speed_tends_to_the_steady_one_by_the_time_constant() -> None:
    found = device_answers(run(motor=["240 N*m", "1.5 N*m*s"], load="60 N*m", at="1 s"))
    assert found["omega_t"] == pytest.approx(120 * (1 - exp(-0.75)), rel=1e-10)


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"motor": "50 N*m", "to": "100 %"}, "below 100 %"),
        ({"motor": "50 N*m", "brake": "3 N*m"}, "without a motor"),
        ({"load": "5 N*m"}, "neither a motor nor a speed"),
        ({"load": ["0 N*m", "1 N*m*s"], "start": "60 r/min"}, "never stands still"),
        ({"load": "5 N*m", "start": "60 r/min", "to": "70 r/min"}, "a speed below 'start'"),
        ({"motor": {"M_k": "3 N*m"}}, "a characteristic is one value"),
        ({"motor": {"M_k": "3 N*m", "s_k": "2", "n_s": "90 r/min"}}, "lies between 0 and 1"),
        ({"motor": [["0 rad/s", "3 N*m"], ["0 rad/s", "4 N*m"]]}, "rising order"),
    ],
)
def test_what_is_no_run_is_refused_with_the_reason(data: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        run(**data)


DIPPING = [["0 rad/s", "5 N*m"], ["50 rad/s", "0 N*m"], ["90 rad/s", "40 N*m"]]


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"motor": "50 N*m", "load": "10 N*m"}, "no steady speed"),
        ({"motor": ["50 N*m", "1 N*m*s"], "load": "10 N*m", "to": "50 rad/s"}, r"at 40\.\d+ rad/s the driving moment"),
        ({"load": DIPPING, "start": "90 rad/s", "brake": "5 N*m"}, r"at 50 rad/s 0 N·m resist: the speed never falls"),
        ({"motor": ["50 N*m", "1 N*m*s"], "load": "10 N*m", "start": "45 rad/s"}, r"is 5 N·m less .* slows down"),
        (
            {"motor": ["50 N*m", "1 N*m*s"], "start": "49 rad/s"},
            r"at 49 rad/s, which is not below its end, 47\.5 rad/s",
        ),
    ],
)
def test_a_speed_that_is_never_reached_is_refused_with_its_number(data: dict[str, Any], said: str) -> None:
    with pytest.raises(NotAskedError, match=said):
        device_answers(run(**data))


def test_a_motor_whose_moment_is_flat_at_first_has_no_time_constant_and_runs_up() -> None:
    """ΔM = 70 N·m up to 100 rad/s, then a straight line; the time constant divided by nothing."""
    flat = [["0 rad/s", "100 N*m"], ["100 rad/s", "100 N*m"], ["150 rad/s", "0 N*m"]]
    found = agree(run(motor=flat, load="30 N*m"))
    assert found["omega_s"] == pytest.approx(135) and "T" not in found
    assert found["t"] == pytest.approx(2 * 100 / 70 + 2 / 2 * log(70 / (70 - 2 * (0.95 * 135 - 100))))


@given(st.floats(0.01, 3), st.floats(3.1, 9))
def test_strips_are_as_fine_as_the_curve_asks_for(low: float, high: float) -> None:
    found = strips(lambda x: 1 / x, (low, high))
    area = sum(w / x for strip in found for x, w in zip(strip.places, strip.weights, strict=True))
    assert area == pytest.approx(log(high / low), rel=1e-10)
    assert root(lambda x: x * x - low, 0.0, 4.0) == pytest.approx(low**0.5)


def test_kloss_is_symmetric_about_its_greatest_moment() -> None:
    motor = Kloss(greatest=10.0, slip=0.25, synchronous=100.0, text="")
    at = {share: 2 * motor.greatest / (share + 1 / share) for share in (0.5, 1.0, 2.0)}
    assert at[0.5] == at[2.0] < at[1.0] == motor.greatest


@pytest.mark.parametrize("read", few(["0 mm", "60 mm"], 2))
def test_a_steady_speed_misread_so_far_that_no_area_is_left_is_refused_with_its_numbers(read: str) -> None:
    with pytest.raises(NotAskedError, match="read O S′ again"):
        solve(load("motor-run-up"), by="exact", repeats=0, readings={"OS′": read})


def test_the_table_of_a_run_subtracts_as_it_is_printed_and_its_columns_have_one_count_of_decimals() -> None:
    for name, columns in (("motor-run-up", 5), ("run-down", 4)):
        tables = [step.listing for step in solve(load(name)).construction.steps if step.listing is not None]
        for table in tables:
            assert len(table.head) == columns, "without a motor there is no column of M_d"
            values = [[Decimal(cell.replace("−", "-")) for cell in row] for row in table.rows]
            for row in values if columns == 5 else ():
                assert row[1] - row[2] == row[3]
            for cells in zip(*values, strict=True):
                tens = {cell.as_tuple().exponent for cell in cells}
                figures = {len(cell.as_tuple().digits) for cell in cells}
                assert len(tens) == 1 or figures == {4}


def test_a_speed_whose_sense_nobody_gave_is_told_without_one() -> None:
    answers = solve(load("motor-run-up")).answers
    assert answers["omega_s"].sense is None and answers["omega_t"].sense is None


@pytest.mark.parametrize("name", ["motor-run-up"])
def test_the_ends_of_every_length_measured_stand_in_the_figures(name: str) -> None:
    solution = solve(load(name))
    letters = {mark.label for f in solution.construction.figures for mark in f.marks if isinstance(mark, Point)}
    assert letters >= {"O", "A", "B", "S", "S′", "H", "P", "A_y", "A_φ"}


@pytest.mark.parametrize("view", [INVERSE, SPEED])
def test_an_area_below_a_curve_is_closed_by_the_ordinate_of_its_end(view: View) -> None:
    (figure,) = (one for one in drawn("motor-run-up").construction.figures if one.view is view)
    (hatched,) = (mark for mark in figure.marks if isinstance(mark, Hatched))
    right = max(one.real for one in hatched.points)
    closing = [one for one in figure.marks if isinstance(one, Segment) and one.a.real == one.b.real == right]
    assert [one.a.imag for one in closing] == [0.0] and closing[0].b in hatched.points


@pytest.mark.parametrize(("view", "letters"), [(INVERSE, "ω/(rad/s)"), (SPEED, "t/s")])
def test_the_unit_stands_behind_the_letter_of_an_axis_and_at_none_of_its_numbers(view: View, letters: str) -> None:
    (figure,) = (one for one in drawn("motor-run-up").construction.figures if one.view is view)
    assert letters in {one.label for one in figure.marks if isinstance(one, Point)}
    assert all(float(one.words.en) for one in figure.marks if isinstance(one, Note))


@pytest.mark.parametrize(("moment", "time"), [(1e-3, 1.0), (1.0, 1e3), (1e3, 0.1)])
def test_a_small_machine_and_a_slow_one_are_drawn_as_large_as_others(moment: float, time: float) -> None:
    """Units of moment and of time that are powers of ten: the same drawing to other scales."""

    def curves(m: float, t: float) -> list[complex]:
        motor, load = [f"{120 * m} N*m", f"{1.1 * m * t} N*m*s"], f"{30 * m} N*m"
        figures = paper(run(motor=motor, load=load, J=f"{2 * m * t * t} kg*m^2")).figures
        return [mark.b for figure in figures for mark in figure.marks if isinstance(mark, Segment)]

    assert curves(moment, time) == pytest.approx(curves(1.0, 1.0), abs=1e-6)


def test_what_slows_a_braked_machine_is_called_resistance_and_brake_and_not_resistance_alone() -> None:
    figures = [one for one in drawn("run-down").construction.figures if one.view is CHARACTERISTIC]
    letters = [{mark.label for mark in one.marks if isinstance(mark, Point)} for one in figures]
    tables = [step.listing for step in drawn("run-down").construction.steps if step.listing is not None]
    for sign, there, table in zip(("M_r", "M_r + M_b"), letters, tables, strict=True):
        assert {one for one in there if one.startswith("M_")} == {sign} and f"${sign}$" in table.head[1].en


def test_the_letters_at_which_a_speed_is_read_are_named_and_the_end_of_the_run_is_marked() -> None:
    """HP was measured and no step said what H and P are; ω_1 and t_1 of the data were nowhere."""
    construction = drawn("motor-run-up").construction
    told = [step.words for step in construction.steps]
    for text in (" ".join(one.zh for one in told), " ".join(one.en for one in told)):
        assert all(f"${one}$" in text for one in ("H", "P", "HP", "t_1", "ω_1", "ω_t"))
    assert any(getattr(mark, "label", "") == "ω_1" for figure in construction.figures for mark in figure.marks)
