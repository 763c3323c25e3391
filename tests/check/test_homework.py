"""The big homework: every whole-cycle column of the assignments against the truth tables,
and problem 30 against a solution of its own."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.laws import few
from vecpoly.check.truth import exact_values
from vecpoly.cycle import cycle, extremes, facts, path
from vecpoly.cycle.facts.path import Shape
from vecpoly.errors import AssemblyError
from vecpoly.problem.load import load
from vecpoly.solution import solve

Reals = NDArray[np.float64]
DATA = Path(__file__).resolve().parents[1] / "data" / "homework"
TABLES = ("A-16", "A-26", "A-27", "A-27-b", "B-24", "B-26.5", "B-29.5")

POINTS = {
    f"{stem}{axis}{p}": f"{key}_{p}.{axis}"
    for p in "EF"
    for axis in "xy"
    for stem, key in (("", "p"), ("v", "v"), ("a", "a"))
}
SLIDES = {"s_AB": "s_21", "v_AB": "v_21", "s_ED": "s_45", "v_ED": "v_45"}
LINKS_A = {
    f"{name}{n}": f"{key}_{n}" for n in "35" for name, key in (("phi", "phi"), ("omega", "omega"), ("alpha", "alpha"))
}
LINKS_B = {
    f"{name}{n}": f"{key}_{ours}"
    for n, ours in (("2", "2"), ("3", "3"), ("5", "4"), ("6", "5"))
    for name, key in (("theta", "phi"), ("omega", "omega"), ("alpha", "alpha"))
}
SIZES = {"vE": "v_E.abs", "aE": "a_E.abs"}
UNITS = {
    "rad": 1.0,
    "deg": np.degrees(1.0),
    "rad_s": 1.0,
    "rad_s2": 1.0,
    "mm": 1e3,
    "mm_s": 1e3,
    "mm_s2": 1e3,
    "m_s": 1.0,
    "m_s2": 1.0,
}


def columns(name: str) -> Iterator[tuple[str, str, float, Reals, Reals]]:
    """Heading, key, factor to its unit, the drive's angle (rad), the printed truth."""
    with (DATA / f"{name}.csv").open(encoding="utf-8") as file:
        rows = list(csv.reader(file))
    values = np.array(rows[1:], np.float64)
    known = POINTS | SLIDES | SIZES | (LINKS_B if name.startswith("B") else LINKS_A)
    for i, heading in enumerate(rows[0][1:], 1):
        quantity, unit = next(
            (heading[: -len(u) - 1], u) for u in sorted(UNITS, key=len, reverse=True) if heading.endswith("_" + u)
        )
        yield heading, known[quantity], UNITS[unit], np.radians(values[:, 0]), values[:, i]


@pytest.mark.parametrize("name", TABLES)
def test_every_whole_cycle_column_is_the_truth_to_1e_9_of_its_scale(name: str) -> None:
    told = list(columns(name))
    turn = cycle(load(name), over=told[0][3])
    for heading, key, factor, _, truth in told:
        gap = (
            factor * turn.real(key) - truth
            if not key.endswith((".x", ".y"))
            else factor * np.asarray(turn.column(key)) - truth
        )
        if key.startswith("phi"):
            gap = np.angle(np.exp(1j * gap / factor)) * factor
        assert np.abs(gap).max() <= 1e-9 * np.abs(truth).max(), heading


@pytest.mark.parametrize("name", TABLES)
def test_the_tables_hold_every_column_of_the_case_file(name: str) -> None:
    assert len(list(columns(name))) == {"A-16": 10, "A-26": 9, "A-27": 9, "A-27-b": 9}.get(name, 20)


@pytest.mark.parametrize("name", few(["A-16", "A-26", "A-27-b", "A-30", "A-30-b", "B-24", "B-26.5", "B-29.5"], 2))
def test_each_problem_is_drawn_at_its_position_and_agrees_with_the_oracle(name: str) -> None:
    problem = load(name)
    truth = exact_values(problem)
    size = {stem: max(abs(v) for k, v in truth.items() if k[0] == stem) for stem in {k[0] for k in truth}}
    for answer in solve(problem, by="exact", repeats=0).answers.values():
        assert abs(answer.drawn - answer.exact) <= 1e-9 * size[answer.key[0]], answer.key


def test_problem_26_makes_a_figure_of_eight_whose_double_point_is_the_pivot() -> None:
    problem = load("A-26")
    found = path(cycle(problem), "E")
    assert (found.turning, len(found.crossings), found.closed) == (0, 1, True)
    assert abs(found.crossings[0].at - problem.mechanism.frame["D"]) < 1e-9  # 6-digit coordinates of D


def test_problem_27_makes_an_inner_loop_and_its_guide_turns_twice() -> None:
    for name in ("A-27", "A-27-b"):
        turn = cycle(load(name))
        found, told = path(turn, "F"), facts(turn)
        assert (found.shape, found.turning, len(found.crossings)) == (Shape.CURVE, 2, 1)
        assert told.turns is not None and told.turns["5"] == 2


def test_the_peaks_of_problem_27_are_where_the_statement_sees_them() -> None:
    turn = cycle(load("A-27"))
    for key in ("v_F", "a_F"):
        top = extremes(turn, key).highest
        assert top is not None and 50 < np.degrees(top.phi) < 100


def test_links_5_and_6_of_b_make_one_turn_backwards_near_a_folded_dyad() -> None:
    told = facts(cycle(load("B-24")))
    assert told.turns is not None and told.turns["4"] == told.turns["5"] == -1
    dyad = next(t for t in told.transmissions if t.links == "45")
    assert (
        dyad.is_folded and abs(np.sin(dyad.least.value) - 0.16) < 0.005 and abs(np.degrees(dyad.least.phi) - 343) < 0.5
    )


def meet(p: complex, q: complex, r: float, s: float, left: bool) -> complex:
    """Where circles about p and q meet, left or right of p → q."""
    d = abs(q - p)
    x = (d * d + r * r - s * s) / (2 * d)
    if x * x > r * r:
        return complex(np.nan, np.nan)
    y = np.sqrt(r * r - x * x)
    return p + (q - p) / d * complex(x, y if left else -y)


def ten_bar(
    phi: float, left: bool, g_left: bool, k_left: bool, e_left: bool = True, m_left: bool = True
) -> dict[str, complex]:
    """Problem 30 by ruler and compasses: frame from its distances, then circle by circle (mm);
    B lies opposite the crank's angle φ."""
    h, f, a = 0j, 310 + 0j, 542.3 + 41.5j
    d = meet(h, f, 363, 200, True)
    k = meet(d, f, 54, 218, k_left)
    b = a - 100 * np.exp(1j * phi)
    c = meet(b, d, 273, 136, left)
    g = meet(b, c, 490, 232, g_left)
    return {"C": c, "G": g, "E": meet(g, f, 145, 282, e_left), "M": meet(g, k, 136, 191, m_left), "K": k, "D": d}


def test_only_one_assembly_of_problem_30_goes_all_the_way_round() -> None:
    round_the_clock = np.radians(np.arange(0.0, 360.0, 3.0))
    whole = [
        sides
        for sides in product((True, False), repeat=3)
        if all(np.isfinite(list(ten_bar(q, *sides).values())).all() for q in round_the_clock)
    ]
    assert whole == [(True, False, False)]  # C left of BD, G right of BC, K right of DF: as the problem file has it


@pytest.mark.parametrize(("name", "left"), [("A-30", True), ("A-30-b", False)])
def test_problem_30_is_what_ruler_and_compasses_give(name: str, left: bool) -> None:
    problem, phi = load(name), np.radians(np.arange(0.0, 360.0, 15.0))
    turn = cycle(problem, over=phi)
    for i, q in enumerate(phi):
        known = ten_bar(float(q), True, False, False, left, left)
        for letter in "CGEM":
            assert abs(1e3 * turn.column(f"p_{letter}")[i] - known[letter]) < 1e-9 * 500
        for letter in "KD":
            assert abs(1e3 * problem.mechanism.frame[letter] - known[letter]) < 1e-9 * 500


@pytest.mark.parametrize("link", ["2", "4", "5", "6", "7", "8", "9"])
def test_the_rates_of_problem_30_are_derivatives_of_its_angles(link: str) -> None:
    turn = cycle(load("A-30"), 7201)
    step = turn.phi[1] - turn.phi[0]
    for of, rate in (("phi", "omega"), ("omega", "alpha")):
        values, truth = turn.column(f"{of}_{link}"), turn.column(f"{rate}_{link}")
        slope = np.convolve(values, np.array([-1, 9, -45, 0, 45, -9, 1])[::-1] / 60, "valid") * 10.0 / step
        assert np.abs(slope - truth[3:-3]).max() < 2e-6 * np.abs(truth).max()


def test_dyads_of_problem_30_reach_as_far_as_the_case_file_says() -> None:
    turn = cycle(load("A-30"))
    frame = turn.mech.frame
    for pivot, low, high in (("F", 236.1, 419.9), ("K", 55.4, 258.0)):
        reach = 1e3 * np.abs(turn.at("p_G", np.radians(np.arange(0.0, 360.0, 0.05))) - frame[pivot])
        assert abs(reach.min() - low) < 0.05 and abs(reach.max() - high) < 0.05


def test_a_length_that_cannot_close_is_refused_in_one_sentence() -> None:
    problem = load("B-24")
    links = tuple(
        link if link.name != "5" else type(link)(name="5", points={"G": 0j, "F": 0.001})
        for link in problem.mechanism.links
    )
    with pytest.raises(AssemblyError, match="do not meet"):
        cycle(
            type(problem.mechanism)(
                frame=problem.mechanism.frame,
                links=links,
                joints=problem.mechanism.joints,
                drives=problem.mechanism.drives,
                branches=problem.mechanism.branches,
            )
        )


def test_the_last_dyad_of_problem_30_comes_within_0_37_mm_of_its_folded_position_near_159_degrees() -> None:
    turn = cycle(load("A-30"))
    dyad = next(t for t in facts(turn).transmissions if t.links == "78")
    reach = 1e3 * abs(complex(np.asarray(turn.at("p_G", [dyad.least.phi]))[0]) - turn.mech.frame["K"])
    assert (
        dyad.is_folded
        and np.degrees(dyad.least.phi) == pytest.approx(159.42, abs=0.01)
        and reach - (191 - 136) == pytest.approx(0.37, abs=0.005)
    )


@pytest.mark.parametrize(
    ("phi", "omega", "alpha", "speeds", "pulls"),
    [
        (45, -1.834541725, 43.55556526, (0.26637098, 0.19540085), (1.7177985, 3.4525344)),
        (135, 1.995240068, 8.418687999, (0.22575274, 0.29129059), (2.6053981, 2.4129386)),
    ],
)
def test_exercise_10_at_both_readings_of_its_crank_angle(
    phi: float, omega: float, alpha: float, speeds: tuple[float, ...], pulls: tuple[float, ...]
) -> None:
    turn = cycle(load("ex10"), over=np.radians([phi]))
    told = {"omega_2": omega, "alpha_2": alpha, "v_D": speeds[0], "v_E": speeds[1], "a_D": pulls[0], "a_E": pulls[1]}
    for key, value in told.items():
        assert (
            complex(turn.column(key)[0]).real == pytest.approx(value, rel=1e-8)
            if "_2" in key
            else turn.real(key)[0] == pytest.approx(value, rel=1e-7)
        ), key


@pytest.mark.parametrize("rate", [2 * np.pi * 40 / 60, 40 / 60])
def test_the_conveyor_at_the_right_speed_and_at_the_speed_of_the_report(rate: float) -> None:
    mech = load("C-conveyor").mechanism
    turn = cycle(replace(mech, drives=(replace(mech.drive, rate=rate),)), over=np.radians([0.0, 150.0, 300.0]))
    scale = rate / (2 * np.pi * 40 / 60)
    for key, power, told in (
        ("phi_2", 0, (1.1994168, 0.76010321, 1.4001201)),
        ("omega_2", 1, (-1.8177769, 0.60268823, 0.34411519)),
        ("alpha_2", 2, (-3.812965, 3.2408062, -7.6764047)),
        ("omega_3", 1, (-1.8177769, 1.2415487, -1.0243069)),
        ("alpha_3", 2, (4.2522599, -1.4787358, -5.8113029)),
    ):
        assert turn.real(key) == pytest.approx(np.array(told) * scale**power, rel=1e-7), key
