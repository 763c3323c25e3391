"""True motion: runs, stalls, oscillations, steady motion, against cases, energy, and arithmetic-geometric means."""

from __future__ import annotations

from textwrap import dedent
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import often
from tests.machine.engines import DATA, SHAPER, engine, machine
from vecpoly.check.truth import exact_values
from vecpoly.errors import EquilibriumError
from vecpoly.oracle.machine import periodic, reduce
from vecpoly.oracle.machine.forward import Mover, Outcome
from vecpoly.oracle.machine.run import follow
from vecpoly.oracle.machine.started import ending, motion_of
from vecpoly.problem.load import loads as read
from vecpoly.problem.problem import Problem

RUN = "machine: {start: {phi: 30 deg, omega: 0 rad/s}, until: 360 deg, at: [90 deg, 180 deg, 270 deg]}\n"
PENDULUM = """
    id: pendulum
    title: {zh: 偏心飞轮, en: An unbalanced flywheel}
    frame: {A: [0 mm, 0 mm]}
    links: {1: {AB: 90 mm}}
    input: {link: 1, phi: 30 deg, omega: ccw}
    masses:
      1: {mass: 6 kg, inertia: 0.1014 kg*m^2, centre: B}
    weight: yes
    machine: {start: {phi: 30 deg, omega: 0 rad/s}, until: 1080 deg}
    find: [T_cycle, omega_max]
"""


def moved(problem: Problem) -> Any:
    assert problem.machine is not None
    return motion_of(problem.mechanism, problem.machine)


def test_a_slider_crank_is_started_by_a_constant_moment_as_in_the_case() -> None:
    keys = [f"{what}_at_{way}" for way in (90, 180, 270) for what in ("omega", "t")]
    push = ("M_1: {on: 1, size: 5 N*m ccw}",)
    exact = exact_values(engine(["alpha_0", "omega_end", "t_end", *keys], phi=30, loads=push, more=RUN))
    wanted = DATA["C01"]["results"]
    for way in (90, 180, 270):
        assert exact[f"omega_at_{way}"] == pytest.approx(wanted["omega_after_deg"][str(way)], rel=5e-9)
        assert exact[f"t_at_{way}"] == pytest.approx(wanted["t_after_deg"][str(way)], rel=5e-9)
    assert [exact[key] for key in ("alpha_0", "omega_end", "t_end")] == pytest.approx(
        [wanted["alpha0"], wanted["omega_after_deg"]["360"], wanted["t_after_deg"]["360"]], rel=5e-9
    )


def test_an_unbalanced_wheel_swings_with_the_period_of_a_pendulum() -> None:
    problem, wanted = read(dedent(PENDULUM)), DATA["C04"]["results"]
    exact = exact_values(problem)
    assert exact["T_cycle"] == pytest.approx(wanted["T_s"], rel=5e-9)
    assert abs(exact["omega_max"]) == pytest.approx(wanted["omega_bottom"], rel=5e-9)
    assert moved(problem).outcome is Outcome.OSCILLATES
    assert "swings to and fro" in ending(moved(problem)).en


def test_a_shaper_with_a_linear_motor_settles_to_the_steady_motion_of_the_case() -> None:
    motor = "M_d: {on: 1, motor: [2400 N*m, 330 N*m*s], role: driving}"
    text = SHAPER.replace("M_d: {on: 1, size: constant, role: driving}", motor)
    text = text.replace("inertia: 0.5 kg*m^2, centre: A", "inertia: 30 kg*m^2, centre: A")
    keys = ("omega_max", "omega_min", "phi_max", "phi_min", "delta", "T_cycle")
    exact = exact_values(machine(text, keys, "start: {phi: 0 deg, omega: 5 rad/s}, until: steady"))
    wanted, close = DATA["C03"]["results"], DATA["C03"]["agreement"]
    assert [exact[key] for key in ("omega_max", "omega_min", "delta", "T_cycle")] == pytest.approx(
        [wanted[key] for key in ("omega_max", "omega_min", "delta", "T_s")], rel=close
    )
    flat = 0.1  # deg: of a flat top the case knows the height to 3e-6, and its place no better
    assert exact["phi_max"] == pytest.approx(wanted["at_phi_deg"], abs=flat)
    assert exact["phi_min"] == pytest.approx(wanted["at_phi_min_deg"], abs=flat)


@settings(max_examples=often(8))
@given(push=st.floats(1.0, 30.0), phi=st.floats(0.0, 6.28), omega=st.floats(-20.0, 20.0).filter(lambda w: abs(w) > 1))
def test_the_work_done_is_the_energy_gained(push: float, phi: float, omega: float) -> None:
    problem = engine(["J_e"], loads=(f"M_1: {{on: 1, size: {push} N*m ccw}}",))
    assert problem.machine is not None
    acting, mech = problem.machine.loads, problem.mechanism
    found = follow(Mover(mech, acting), phi, omega, 2.0)
    _, end, speed = found.end
    before, after = (float(reduce(mech, acting, q).energy[0]) for q in (phi, end))
    gained = after * speed**2 / 2 - before * omega**2 / 2
    assert gained == pytest.approx(push * (end - phi), rel=1e-8, abs=1e-8)
    if omega > 0:
        assert found.outcome is Outcome.REACHED


def test_a_machine_whose_resistance_is_the_greater_stalls_and_says_where() -> None:
    push = ("M_1: {on: 1, size: 5 N*m ccw}", "M_r: {on: 1, size: 8 N*m cw, role: resisting}")
    run = "machine: {start: {phi: 30 deg, omega: 20 rad/s}, until: 720 deg}\n"
    problem = engine(["phi_end", "omega_end", "t_end"], phi=30, loads=push, more=run)
    exact = exact_values(problem)
    inertia = float(reduce(problem.mechanism, problem.machine.loads, np.radians(30)).energy[0])  # type: ignore[union-attr]
    assert np.radians(exact["phi_end"] - 30) == pytest.approx(inertia * 20**2 / 2 / 3, rel=1e-8)
    assert exact["omega_end"] == 0
    assert moved(problem).outcome is Outcome.STALLED
    assert ending(moved(problem)).en.startswith("the machine stalls at φ =")


def test_a_place_that_is_not_reached_is_refused_with_how_it_ended() -> None:
    push = ("M_1: {on: 1, size: 5 N*m ccw}", "M_r: {on: 1, size: 8 N*m cw, role: resisting}")
    run = "machine: {start: {phi: 30 deg, omega: 20 rad/s}, until: 720 deg, at: [600 deg]}\n"
    with pytest.raises(EquilibriumError, match="there is no omega_at_600: the machine stalls"):
        exact_values(engine(["omega_at_600"], phi=30, loads=push, more=run))


def test_a_drive_that_never_weakens_comes_to_no_steady_motion(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(periodic, "TURNS", 20)
    run = "machine: {start: {phi: 30 deg, omega: 0 rad/s}, until: steady}\n"
    with pytest.raises(EquilibriumError, match="after 20 turns it has not settled"):
        exact_values(engine(["T_cycle"], phi=30, loads=("M_1: {on: 1, size: 5 N*m ccw}",), more=run))


def test_the_power_flow_of_the_case_goes_into_its_links() -> None:
    push = ("F: {on: 3, at: C, size: 3000 N, direction: 180 deg}", "M_1: {on: 1, size: 60 N*m cw}")
    run = "machine: {start: {phi: 50 deg, omega: 157.08 rad/s}, until: 1 deg}\n"
    exact = exact_values(engine(["alpha_0", "power_F", "power_M_1", "dT_1", "dT_2", "dT_3"], loads=push, more=run))
    wanted = DATA["C07"]["results"]
    gains = wanted["dT_dt_by_mass_W"]
    assert exact["alpha_0"] == pytest.approx(wanted["alpha"], rel=5e-9)
    assert [exact["power_F"], exact["power_M_1"]] == pytest.approx([wanted["P_load"], wanted["P_motor"]], rel=5e-9)
    assert exact["dT_1"] == pytest.approx(gains["J of link 1"], rel=5e-9)
    assert exact["dT_2"] == pytest.approx(gains["m at S2"] + gains["J of link 2"], rel=5e-9)
    assert exact["dT_3"] == pytest.approx(gains["m at C"], rel=5e-9)
    assert sum(exact[f"dT_{n}"] for n in "123") == pytest.approx(exact["power_F"] + exact["power_M_1"], rel=1e-12)


class _Given(Mover):
    """A machine of which J_e and M_e are given over φ."""

    def acceleration(self, phi: float, omega: float) -> float:
        moment = 120 * (1 - phi / (2 * np.pi)) - 52
        return float((moment + 0.25 * np.sin(2 * phi) * omega**2) / (0.6 + 0.25 * np.cos(2 * phi)))

    def next_corner(self, phi: float, sense: float) -> float:
        return sense * np.inf


def test_given_courses_of_inertia_and_moment_lead_to_the_speeds_of_the_case() -> None:
    problem, wanted = engine(["J_e"], loads=("M_1: {on: 1, size: 5 N*m ccw}",)), DATA["B20"]["results"]
    assert problem.machine is not None
    places = (60, 120, 180, 270)
    found = follow(_Given(problem.mechanism, problem.machine.loads), 0.0, 14.0, 2 * np.pi, tuple(np.radians(places)))
    assert [speed for _, speed in found.passed.values()] == pytest.approx(
        [wanted["omega"][str(q)] for q in places], rel=5e-9
    )
    assert found.end[2] == pytest.approx(wanted["omega"]["360"], rel=5e-9)
    assert found.end[0] == pytest.approx(wanted["T_s"], rel=5e-9)
    (place, top), _ = found.extremes
    assert (np.degrees(place), top) == pytest.approx((wanted["at_deg"], wanted["omega_max"]), rel=1e-7)


SWUNG = PENDULUM.replace("phi: 30 deg, omega: 0 rad/s}, until: 1080 deg", "phi: 260 deg, omega: 5 rad/s}, MORE")


def swung(at: str, find: str) -> dict[str, complex]:
    text = SWUNG.replace("MORE", f"until: 170 deg, at: [{at}]").replace("[T_cycle, omega_max]", find)
    return dict(exact_values(read(dedent(text))))


def test_a_place_that_a_swinging_machine_never_comes_to_has_no_speed_of_another_place() -> None:
    assert swung("15 deg, 85 deg", "[omega_at_15]")["omega_at_15"].real > 0
    with pytest.raises(EquilibriumError, match="there is no omega_at_85: the machine swings"):
        swung("15 deg, 85 deg", "[omega_at_85]")


def test_a_place_that_is_named_twice_is_one_place() -> None:
    once, twice = (swung(f"{more}20 deg, 35 deg", "[omega_at_20, omega_at_35]") for more in ("", "20 deg, "))
    assert once == twice
