"""Claims about loads that depend on place and speed, as the oracle knows them."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.lawful import CARD, COIL, CUT, ENGINE, PLAIN, SPRING, slider
from tests.laws import few, often
from vecpoly import loads
from vecpoly.check.truth import exact_values
from vecpoly.errors import EquilibriumError, VecpolyError
from vecpoly.oracle import solve
from vecpoly.oracle.forces import forces
from vecpoly.oracle.forces.laws.corners import corners
from vecpoly.oracle.forces.laws.period import PIECE, constant_size, cuts_of
from vecpoly.problem.problem import Problem

CRANK, ROD, RATE = 0.06, 0.22, 10 * np.pi


def travel(phi: float) -> float:
    """x of the slider's pin (m), by hand."""
    return float(CRANK * np.cos(phi) + np.sqrt(ROD**2 - (CRANK * np.sin(phi)) ** 2))


def speed(phi: float) -> float:
    """dx/dt of it (m/s), by hand."""
    lean = CRANK**2 * np.sin(phi) * np.cos(phi) / np.sqrt(ROD**2 - (CRANK * np.sin(phi)) ** 2)
    return float(-RATE * (CRANK * np.sin(phi) + lean))


def moment(problem: Problem, phi: float, key: str = "M_1") -> float:
    """What balances on the crank (N·m)."""
    assert problem.loads is not None
    return float(np.real(forces(problem.mechanism, problem.loads, phi).value(key)))


@pytest.mark.parametrize(("low", "high"), [(5, 95), (0, 60), (40, 100), (0, 100)])
def test_a_force_acts_only_while_its_point_moves_so_and_within_its_part_of_the_stroke(low: int, high: int) -> None:
    cut = slider(CUT.replace("[5 %, 95 %]", f"[{low} %, {high} %]"))
    for degrees in range(3, 360, 7):
        phi = np.radians(degrees)
        gone = (CRANK + ROD - travel(phi)) / (2 * CRANK)
        acts = speed(phi) < 0 and low / 100 <= gone < high / 100
        assert moment(cut, phi) == pytest.approx(-3000 * speed(phi) / RATE if acts else 0.0, abs=1e-9)


def test_during_counts_from_where_the_input_counts_and_goes_on_past_a_whole_turn() -> None:
    plain = PLAIN.replace("phi: 50 deg", "phi: 50 deg from AD")
    part = slider("M: {on: 2, size: 10 N*m ccw, during: [300 deg, 60 deg]}", plain=plain)
    lead = np.angle(150 + 90j)
    for degrees, acts in ((299, False), (301, True), (0, True), (59, True), (61, False), (180, False)):
        assert (moment(part, np.radians(degrees) + lead) != 0) is acts


def test_a_card_is_read_on_the_way_there_and_on_the_way_back() -> None:
    engine = slider(ENGINE)
    area = np.pi * 0.05**2 / 4
    for degrees in (10, 47, 133, 181, 250, 340):
        phi = np.radians(degrees)
        s = 1e3 * (CRANK + ROD - travel(phi))
        there, back = np.interp(s, [0, 30, 120], [3, 2, 0.4]), np.interp(s, [0, 60, 120], [0.1, 0.2, 0.4])
        force = -1e6 * area * (there if speed(phi) < 0 else back)
        assert moment(engine, phi) == pytest.approx(-force * speed(phi) / RATE, rel=1e-9)


def test_springs_and_dampers_pull_as_their_length_and_its_rate_say() -> None:
    sprung = slider(SPRING)
    for phi in np.radians([5.0, 77.0, 160.0, 284.0]):
        ray = complex(travel(phi)) - (0.15 + 0.09j)
        rate = speed(phi) * ray.real / abs(ray)
        pull = 20 + 5e3 * (abs(ray) - 0.08) + 50 * rate
        assert moment(sprung, phi) == pytest.approx(pull * rate / RATE, rel=1e-9)


def test_a_torsion_spring_turns_against_the_angle_from_its_free_one() -> None:
    coiled = slider(COIL)
    for phi in np.radians([5.0, 77.0, 160.0, 284.0]):
        lean = -np.arcsin(CRANK * np.sin(phi) / ROD)
        omega = -RATE * CRANK * np.cos(phi) / (ROD * np.cos(lean))
        own = -(1 + 20 * (lean - np.radians(10)) + 0.1 * omega)
        assert moment(coiled, phi) == pytest.approx(-own * omega / RATE, rel=1e-9)


def test_a_motor_gives_a_less_b_times_the_speed_in_its_own_sense() -> None:
    for sense, sign in (("ccw", 1), ("cw", -1)):
        plain = PLAIN.replace("ccw", sense)
        driven = slider(CUT, "M_d: {on: 1, motor: [200 N*m, 2 N*m*s]}", unknown="", find="M_b", plain=plain)
        bare = slider(CUT, plain=plain)
        gap = moment(driven, 2.0, "M_b") - moment(bare, 2.0)
        assert gap == pytest.approx(-sign * (200 - 2 * RATE), rel=1e-9)


@pytest.mark.parametrize(
    "entries", few([(CUT,), (ENGINE, SPRING), (CUT, COIL), (ENGINE, CUT.replace("F:", "F_r:"), SPRING, COIL)], 2)
)
def test_the_constant_moment_does_the_work_of_all_others_over_the_period(entries: tuple[str, ...]) -> None:
    problem = slider(*entries, unknown="M_d: {on: 1, size: constant}", find="M_d, M_b")
    assert problem.loads is not None
    phi = (np.arange(360_000) + 0.5) * 2 * np.pi / 360_000
    mean = float(np.mean(forces(problem.mechanism, problem.loads, phi).value("M_b").real))
    assert constant_size(problem.mechanism, problem.loads) == pytest.approx(mean, rel=1e-5)
    assert moment(problem, 1.0, "M_d") == constant_size(problem.mechanism, problem.loads)


def test_the_constant_moment_is_the_area_of_the_card_and_springs_leave_none() -> None:
    """2π M = F · 0.9 H of a constant force; = A ∮ p ds of a card, a polygon; a spring gives back what it took."""
    stroke, area = 2 * CRANK, np.pi * 0.05**2 / 4
    s, p = np.array([0, 30, 120, 60, 0]) * 1e-3, np.array([3, 2, 0.4, 0.2, 0.1]) * 1e6
    loop = float(np.sum((p[1:] + p[:-1]) / 2 * np.diff(s)))
    bare = SPRING.replace(", c: 50 N*s/m", "")
    for entry, work in ((CUT, 0.9 * stroke * 3000), (ENGINE, -area * loop), (bare, 0.0)):
        problem = slider(entry, unknown="M_d: {on: 1, size: constant}", find="M_d")
        assert problem.loads is not None
        found = constant_size(problem.mechanism, problem.loads)
        assert found == pytest.approx(work / (2 * np.pi), rel=1e-8, abs=1e-9)
        assert exact_values(problem)["M_d"] == found


def test_the_corners_are_where_the_windows_open_and_close_and_tables_bend() -> None:
    problem = slider(CUT)
    assert problem.loads is not None
    gone = [(CRANK + ROD - travel(float(q))) / (2 * CRANK) for q in corners(problem.mechanism, problem.loads)]
    assert sorted(round(part, 9) for part in gone) == pytest.approx([0, 0.05, 0.05, 0.95, 0.95, 1], abs=1e-8)
    engine = slider(ENGINE)
    assert engine.loads is not None
    bent = [1e3 * (CRANK + ROD - travel(float(q))) for q in corners(engine.mechanism, engine.loads)]
    assert sorted(bent) == pytest.approx([0, 30, 30, 60, 60, 120], abs=1e-5)


# C passes where DC lies along 82° at full speed: it turns back in that direction, and F goes on to do work there.
ACROSS = """
id: across
title: a load that ends while its point moves on
frame: {A: [0 mm, 0 mm], D: [146.777 mm, 0 mm]}
links: {1: {AB: 64.968 mm}, 2: {BC: 208.173 mm}, 3: {DC: 198.463 mm}}
branch: [C below AD]
input: {link: 1, phi: 182 deg, omega: 108 r/min cw}
loads:
  F: {on: 3, at: C, size: 764 N, direction: 13 deg, while: C moves along 82 deg}
  M_c: {on: 1, size: constant}
find: [M_c]
"""


def test_a_corner_where_a_point_turns_back_is_found_to_the_last_digit_though_it_moves_across() -> None:
    problem = loads(ACROSS)
    assert problem.loads is not None
    places = corners(problem.mechanism, problem.loads)
    motion = solve(problem.mechanism, places)
    ray = motion.body("3").point(0.198463 + 0j) - 0.146777
    square, still = np.sin(np.angle(ray) - np.radians(82)), motion.omega("3") / RATE
    assert len(places) == 4
    assert sorted(np.minimum(abs(square), abs(still))) == pytest.approx([0, 0, 0, 0], abs=1e-13)


def test_the_constant_moment_does_the_work_of_a_load_that_ends_while_its_point_moves_on() -> None:
    problem = loads(ACROSS)
    assert problem.loads is not None
    places = solve(problem.mechanism, corners(problem.mechanism, problem.loads)).body("3").point(0.198463 + 0j)
    lowest = 0.146777 - 0.198463 * np.exp(1j * np.radians(82))
    places = np.where(abs(places - lowest) < 1e-6, lowest, places)
    force, gone = 764 * np.exp(1j * np.radians(13)), np.real(places * np.exp(-1j * np.radians(82)))
    rises = [(a, b) for n, a in enumerate(places) for b in [places[n - 1]] if gone[n] < gone[n - 1]]  # it turns cw
    work = sum(float(np.real((b - a) * np.conj(force))) for a, b in rises)
    assert constant_size(problem.mechanism, problem.loads) == pytest.approx(work / (2 * np.pi), rel=1e-12)


def test_a_table_over_two_turns_makes_the_period_two_turns() -> None:
    rows = "rows: [[0, 10], [180, 0], [720, 10]]"
    table = f"M: {{on: 2, size: {{columns: [phi (deg), M (N*m)], {rows}}}}}"
    twice = slider(table, unknown="M_d: {on: 1, size: constant}", find="M_d")
    assert twice.loads is not None and twice.loads.turns == 2
    assert moment(twice, np.radians(30), "M_b") != pytest.approx(moment(twice, np.radians(390), "M_b"))
    assert moment(twice, np.radians(30), "M_b") == pytest.approx(moment(twice, np.radians(750), "M_b"))


@given(st.floats(0.0, 6.28), st.sampled_from([(CUT,), (ENGINE, SPRING), (SPRING, COIL)]))
@settings(max_examples=often(12))
def test_what_balances_is_what_the_energy_of_springs_and_the_work_of_the_rest_say(
    phi: float, entries: tuple[str, ...]
) -> None:
    """Virtual power by central differences of the places alone: no velocity of the oracle's is used."""
    problem = slider(*entries)
    assert problem.loads is not None
    statics = forces(problem.mechanism, problem.loads, phi)
    step = 1e-5
    ahead, behind = (solve(problem.mechanism, phi + way * step, order=0) for way in (1, -1))
    work = 0.0
    for act in statics.system.known:
        for part in act.parts:
            if part.link in ahead.bodies:
                local = np.conj(statics.motion.bodies[part.link].unit) * (part.at - statics.motion.bodies[part.link].at)
                gap = [
                    motion.bodies[part.link].at + motion.bodies[part.link].unit * local for motion in (ahead, behind)
                ]
                turn = np.angle(ahead.bodies[part.link].unit / behind.bodies[part.link].unit)
                work += float(np.real(np.conj(part.force) * (gap[0] - gap[1]))[0] + (part.couple * turn)[0])
    assert moment(problem, phi) == pytest.approx(-work / (2 * step), rel=1e-6, abs=1e-4)


def test_a_period_that_does_not_exist_is_refused_with_the_range_of_the_drive() -> None:
    short = PLAIN.replace("BC: 220 mm", "BC: 50 mm").replace("phi: 50 deg", "phi: 20 deg")
    rocks = slider(CUT, unknown="M_d: {on: 1, size: constant}", find="M_d", plain=short)
    with pytest.raises(EquilibriumError, match=r"makes no whole turns \(it goes from .*-?56\.4.*° to 56\.44°"):
        moment(rocks, np.radians(20), "M_d")


def test_a_table_that_does_not_cover_the_travel_is_refused_with_both_numbers() -> None:
    short = slider(ENGINE.replace(CARD, "columns: [s (mm), p (MPa)], rows: [[0, 3], [90, 1]]"))
    assert moment(short, np.radians(60)) != 0
    with pytest.raises(EquilibriumError, match=r"goes from 0 mm to 90 mm, and \$C\$ comes to 120 mm"):
        moment(short, np.pi)


def test_a_stroke_of_nothing_is_refused() -> None:
    with pytest.raises(VecpolyError, match="point C of link 3 does not move along 90°: its stroke is 0"):
        moment(slider(CUT.replace("left, ", "up, ")), 1.0)


def test_a_constant_moment_that_must_do_the_opposite_of_its_role_is_refused_with_its_size() -> None:
    wrong = slider(CUT, unknown="M_d: {on: 1, size: constant, role: resisting}", find="M_d")
    with pytest.raises(EquilibriumError, match=r"called resisting, but the work .* wants it to drive \(51\.\d+ N·m\)"):
        moment(wrong, 1.0, "M_d")


@pytest.mark.parametrize("entries", [(CUT,), (ENGINE, SPRING)])
def test_the_pieces_of_a_period_are_small_and_cover_it_once(entries: tuple[str, ...]) -> None:
    problem = slider(*entries, unknown="M_d: {on: 1, size: constant}", find="M_d, M_b")
    assert problem.loads is not None
    cuts = cuts_of(problem.mechanism, problem.loads)
    assert np.ptp(cuts) == pytest.approx(2 * np.pi, rel=1e-9)
    assert (np.diff(cuts) > 0).all() and np.diff(cuts).max() <= PIECE * (1 + 1e-9)
