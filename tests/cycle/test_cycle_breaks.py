"""Claims about columns that break off, jump or run away,
about mechanisms that do not come back, and about change points."""

from __future__ import annotations

import csv
from collections.abc import Callable
from dataclasses import replace
from io import StringIO
from math import acos, degrees, inf, pi
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner, Result

from tests.laws import few
from vecpoly import oracle
from vecpoly.cli import app
from vecpoly.cycle import Cycle, Shape, cycle, extremes, facts, force_sentences, path, path_sentences, sentences
from vecpoly.cycle.sample import sample
from vecpoly.mechanism.model import Circle, Drive, Link, Mechanism, Prismatic, Revolute, Rolling, Side, SideOf
from vecpoly.problem.load import load, loads

Run = Callable[..., Result]


def four_bar(
    crank: float, coupler: float, rocker: float, frame: float, point: complex = 0.1 + 0.04j, rate: float = 1.0
) -> Mechanism:
    links = (
        Link(name="1", points={"A": 0j, "B": crank + 0j}),
        Link(name="2", points={"B": 0j, "C": coupler + 0j, "E": point}),
        Link(name="3", points={"D": 0j, "C": rocker + 0j}),
    )
    joints = tuple(
        Revolute(point=p, a=a, b=b) for p, a, b in (("A", "0", "1"), ("B", "1", "2"), ("C", "2", "3"), ("D", "3", "0"))
    )
    return Mechanism(
        frame={"A": 0j, "D": frame + 0j},
        links=links,
        joints=joints,
        drives=(Drive(link="1", position=1.0, rate=rate),),
        branches=(SideOf(point="C", side=Side.LEFT, ref=("B", "D")),),
    )


def planet(arm: float, gear: float, fixed: float) -> Mechanism:
    links = (Link(name="1", points={"A": 0j, "B": arm + 0j}), Link(name="2", points={"B": 0j, "P": gear + 0j}))
    rolls = Rolling(
        point="H", gear=Circle(link="2", centre="B", radius=gear), on=Circle(link="0", centre="A", radius=fixed)
    )
    return Mechanism(
        frame={"A": 0j},
        links=links,
        joints=(Revolute(point="A", a="0", b="1"), Revolute(point="B", a="1", b="2"), rolls),
        drives=(Drive(link="1", position=0.3, rate=10.0),),
    )


def in_english(turn: Cycle) -> str:
    return " ".join(words.en for words in (*sentences(turn, facts(turn)), *force_sentences(turn)))


@pytest.mark.parametrize("name", few(["4-3a", "4-5", "4-6", "slider-crank-dynamic"], 4))
def test_no_reaction_round_the_cycle_is_greater_than_the_greatest(name: str) -> None:
    fine, turn = cycle(load(name), 721), cycle(load(name))
    for column in [c for c in turn.columns if c.key.startswith(("R_", "M", "eta"))][:3]:
        values, found = fine.real(column.key), extremes(turn, column.key)
        known = values[np.isfinite(values)]
        assert found.highest is not None and found.lowest is not None
        small = 1e-9 * np.abs(known).max()
        assert found.highest.value >= known.max() - small and found.lowest.value <= known.min() + small, column.key
        for spot, best in ((found.highest, known.max()), (found.lowest, known.min())):
            assert not np.isfinite(spot.value) or abs(spot.value - best) < 0.02 * np.ptp(known) + small, column.key


def test_a_reaction_jumps_where_a_slip_changes_its_sense_and_is_greatest_on_one_side() -> None:
    turn = cycle(load("4-3a"))
    top = extremes(turn, "R_14").highest
    assert top is not None and top.end and degrees(top.phi) == pytest.approx(270.0, abs=1e-4)
    before, after = np.abs(np.asarray(turn.at("R_14", np.radians([270 - 1e-4, 270 + 1e-4]))))
    assert top.value == pytest.approx(max(before, after), rel=1e-5) and abs(before - after) > 10.0


def test_the_words_name_where_friction_locks_and_where_it_changes_its_side() -> None:
    told = in_english(cycle(load("4-3a")))
    assert (
        "162.6° … 174.26°: self-locking" in told
        and "joint $C$: 90°, 270°" in told
        and "$F$ drives and $M$ resists" in told
    )
    assert force_sentences(cycle(load("A-27"))) == ()


def test_rates_run_away_towards_a_dead_point_and_what_stays_finite_is_not_spoilt() -> None:
    turn = cycle(load("3-4a-straight"))
    rate, speed, pull = (extremes(turn, key) for key in ("omega_3", "v_C", "a_C"))
    assert (
        rate.highest is not None and rate.lowest is not None and (rate.highest.value, rate.lowest.value) == (inf, -inf)
    )
    assert (
        speed.highest is not None and pull.highest is not None
    )  # C moves on a straight line, slowly, though its links are at dead points
    inside = turn.low + (turn.high - turn.low) * np.linspace(1e-4, 1 - 1e-4, 2001)
    for found, key in ((speed.highest, "v_C"), (pull.highest, "a_C")):
        assert found.value == pytest.approx(np.abs(turn.at(key, inside)).max(), rel=2e-3)
    assert "inf" not in in_english(turn) and "nan" not in in_english(turn)


def test_a_range_is_told_on_the_turn_of_the_given_position() -> None:
    problem = load("4-7")
    turn = cycle(problem)
    assert not turn.whole and turn.low < problem.mechanism.drive.position < turn.high


def test_a_greatest_value_just_beside_a_dead_point_is_found() -> None:
    turn = cycle(load("3-4a"))
    found = extremes(turn, "p_C").highest
    fine = np.abs(np.asarray(cycle(load("3-4a"), 14401).column("p_C")))
    assert found is not None and found.value >= np.nanmax(fine)


def test_a_point_that_runs_off_to_infinity_has_no_length() -> None:
    turn = cycle(load("3-11"))
    assert path(turn, "B").length == inf and path(turn, "B").shape is Shape.LINE
    assert "infinity" in path_sentences(turn, path(turn, "D"))[0].en
    highest = extremes(turn, "p_B").highest
    assert highest is not None and highest.value == inf


@pytest.mark.parametrize(
    ("gear", "fixed", "turns", "laps"), few([(0.02, 0.04, 3, 1), (0.02, 0.03, 2.5, 2), (0.016, 0.03, 2.875, 8)], 2)
)
def test_a_planet_comes_back_after_as_many_turns_as_its_ratio_says(
    gear: float, fixed: float, turns: float, laps: int
) -> None:
    turn = cycle(planet(gear + fixed, gear, fixed))
    told = facts(turn)
    assert told.turns is not None and told.turns["2"] == pytest.approx(turns, abs=1e-9) and told.laps == laps
    assert path(turn, "P").closed == (laps == 1) and (f"after {laps} turns" in in_english(turn)) == (laps > 1)


def test_change_points_are_named_and_no_quick_return_is_told_of_what_is_undetermined() -> None:
    turn = cycle(four_bar(0.06, 0.15, 0.06, 0.15))
    told = facts(turn)
    ((key, spots),) = told.changes
    assert (
        key == "gamma_23"
        and [degrees(s.phi) % 360 for s in spots] == pytest.approx([0.0, 180.0], abs=1e-3)
        and not told.strokes
    )
    assert "change points" in in_english(turn) and "remains a parallelogram" in in_english(turn)
    assert path(turn, "E").turning == 1  # every point of the coupler runs round a circle, as B does
    assert facts(cycle(four_bar(0.05, 0.2, 0.15, 0.18))).changes == ()


@pytest.mark.parametrize("phi", [0.3, 1.2, 4.4])
def test_a_coupler_point_on_the_moving_centrode_has_a_cusp_there(phi: float) -> None:
    plain = four_bar(0.05, 0.2, 0.15, 0.18)
    motion = oracle.solve(plain, np.array([phi]))
    pole = (motion.velocity_pole("2")[0] - motion.position("B")[0]) / np.exp(1j * motion.angle("2")[0])
    for rate in (1.0, -3.0):
        found = path(cycle(four_bar(0.05, 0.2, 0.15, 0.18, complex(pole), rate)), "E")
        ((_, where),) = found.cusps
        assert where == pytest.approx(phi, abs=1e-9) and found.turning is None and found.closed


def test_a_rocking_crank_pin_does_not_go_round_its_circle() -> None:
    assert path(cycle(four_bar(0.1, 0.08, 0.12, 0.15)), "B").shape is Shape.ARC


def test_a_slide_without_limits_is_not_said_to_be_limited() -> None:
    links = (Link(name="1", points={"B": 0j}), Link(name="2", points={"C": 0j}), Link(name="3", points={"B": 0j}))
    joints = (
        Revolute(point="B", a="1", b="3"),
        Revolute(point="C", a="2", b="0"),
        Prismatic(guide="0", block="1", origin=0j, direction=0.0, pin="B"),
        Prismatic(guide="2", block="3", origin=0j, direction=0.0, pin="B", through="C"),
    )
    free = Mechanism(
        frame={"A": 0j, "C": 0.08j},
        links=links,
        joints=joints,
        drives=(Drive(link="1", position=0.05, rate=0.5, slide=True),),
    )
    assert (
        facts(cycle(free)).unlimited == (True, True)
        and facts(cycle(free)).dead == ()
        and "without limit" in in_english(cycle(free))
    )


def test_a_driven_slider_crank_has_its_dead_points_at_the_ends_of_the_stroke() -> None:
    problem = load("3-1a")
    mech = replace(
        problem.mechanism,
        drives=(Drive(link="3", position=0.11, rate=0.5, slide=True),),
        branches=(SideOf(point="B", side=Side.ABOVE, ref=("A",)),),
    )
    turn = cycle(mech)
    assert [spot.phi for spot in facts(turn).dead] == [turn.low, turn.high] and facts(turn).unlimited == (False, False)


def test_facts_are_the_same_from_two_positions_as_from_thousands() -> None:
    for name in ("A-27", "B-24"):
        coarse, fine = (cycle(load(name), n) for n in (2, 3601))
        assert in_english(coarse) == in_english(fine)
        assert coarse.at("phi_5", 2.0) == pytest.approx(fine.at("phi_5", 2.0), abs=1e-12)


def test_limits_of_a_double_rocker_are_the_closed_form() -> None:
    turn = cycle(four_bar(0.12, 0.05, 0.13, 0.15))
    reach = [acos((0.12**2 + 0.15**2 - d * d) / (2 * 0.12 * 0.15)) for d in (0.13 - 0.05, 0.13 + 0.05)]
    assert (turn.low, turn.high) == pytest.approx(tuple(reach), abs=1e-9) and turn.high < pi


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)
    return lambda *words: CliRunner().invoke(app, [str(word) for word in words], prog_name="vecpoly")


def test_a_step_makes_its_whole_multiples_and_a_dash_is_standard_output(run: Run) -> None:
    done = run("cycle", "A-27", "--step", "7", "--of", "omega_5", "-o", "-")
    rows = list(csv.reader(StringIO(done.stdout)))
    assert done.exit_code == 0 and rows[:2] == [["phi_1", "omega_5"], ["°", "rad/s"]]
    assert [float(row[0]) for row in rows[2:]] == pytest.approx(list(range(0, 360, 7)), abs=1e-12)


def test_an_angle_that_the_problem_counts_from_a_line_is_told_to_count_so_here(run: Run) -> None:
    Path("turned.yaml").write_text(
        "extends: C-conveyor\nid: turned\ntitle: {zh: 转, en: turned}\nframe: {A: [0 mm, 0 mm], D: [0 mm, 380 "
        "mm]}\nprinted: null\nerrata: null\n",
        "utf-8",
    )
    assert "φ_1 counts as the problem tells it (from AD to AB)" in run("cycle", "turned.yaml").stdout
    assert "counts" not in run("cycle", "C-conveyor").stdout.lower()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("A-27", "--step", "500"), "fewer than 2"),
        (("A-27", "--path", "F", "--hodograph", "a_F", "--plot", "a.svg"), "two drawings"),
        (("2-1",), "structure"),
    ],
)
def test_what_makes_no_sense_is_refused_in_one_sentence(run: Run, words: tuple[str, ...], said: str) -> None:
    done = run("cycle", *words)
    assert done.exit_code == 2 and said in done.stderr and "Traceback" not in done.stderr


ECCENTRIC = """
id: t
title: t
frame: {A: [0 mm, 0 mm], D: [-3.73 mm, -96.55 mm]}
links:
  1: {AB: 53.772 mm, disc: B, radius: 47.0383 mm}
  2: {block: C, disc: C, radius: 17.9059 mm}
joints: [2 slides on line through D at 118.015216522 deg, 1 touches 2 at E]
branch: [C above B]
input: {link: 1, phi: -76.7458 deg, omega: 9 rad/s}
loads:
  F_q: {on: 2, at: C, size: 383 N, direction: -103 deg}
  X_b: {on: 1, size: "?"}
"""


@pytest.mark.filterwarnings("error")
def test_nothing_is_grumbled_about_the_places_where_an_eccentric_reaches_its_follower_no_more() -> None:
    turn = cycle(loads(ECCENTRIC), over=np.linspace(0, 2 * pi, 37))
    balancing = turn.column("X_b")
    assert np.isfinite(balancing).any() and not np.isfinite(balancing).all()


def test_a_cylinder_keeps_its_rates_up_to_the_ends_of_its_range_where_all_else_runs_away() -> None:
    """There a_54 was −1·10⁻⁶ m/s², what is left of two accelerations of 10⁹: a column of 159 turning points."""
    mech = load("scissor-lift").mechanism
    turn = sample(mech, None, [mech.drive.position, 0.81300883])
    assert turn.value("v_54").tolist() == [0.05, 0.05] and turn.value("a_54").tolist() == [0.0, 0.0]
    assert abs(turn.value("omega_1")[1]) > 1e2 * abs(turn.value("omega_1")[0])


def test_an_angle_begins_within_half_a_turn_where_nothing_rolls() -> None:
    """φ_2 of the scissor lift was −232°, while its figure showed the arc of 128°."""
    mech = load("scissor-lift").mechanism
    own = sample(mech, None, [mech.drive.position]).value("phi_2")
    assert degrees(float(own[0])) == pytest.approx(128.0, abs=0.5)
