"""What a synthesis says of its linkages and refusals is true of them."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np
import pytest

from tests.drawn_library import drawn
from tests.each import Later, each
from tests.laws import few
from vecpoly.board.paper.marks import Point
from vecpoly.check.designs.found_words import told as said
from vecpoly.check.grashof import grashof
from vecpoly.designs.base import Design
from vecpoly.errors import VecpolyError
from vecpoly.problem.library import library
from vecpoly.problem.load import load, loads
from vecpoly.report.answers.moved import moved_told, preferred
from vecpoly.solution import solve

PROBLEM = "id: told\ntitle: told\nsynthesis: {kind}\ndata: {{{data}}}\nfind: [{find}]\n"


def told(kind: str, data: str, find: str) -> str:
    """What the verification says of the only solution."""
    (one,) = solve(loads(PROBLEM.format(kind=kind, data=data, find=find)), by="exact", repeats=0).verification
    return said(one, alone=True).en


def refused(kind: str, data: str) -> str:
    with pytest.raises(VecpolyError) as told:
        solve(loads(PROBLEM.format(kind=kind, data=data, find="theta")), by="exact", repeats=0)
    return told.value.words.en


@pytest.mark.parametrize("ratio", [2.0, 4.0, 8.0])
def test_a_rod_is_long_enough_exactly_where_the_ram_turns_back_with_its_lever(ratio: float) -> None:
    """The ram led from limit to limit by small steps of the lever goes one way only past the length that is told."""
    data, half = f"K: {ratio}, H: 200 mm, AB: 60 mm, DE: 1 mm", pi * (ratio - 1) / (ratio + 1) / 2
    least = float(refused("shaper", data).split(" = ")[2].split(" mm")[0])
    lever = 100.0 / sin(half)
    at = lever * np.exp(1j * (pi / 2 + np.linspace(half, -half, 4001)))
    for rod, goes_back in ((0.98 * least, True), (1.02 * least, False)):
        ram = at.real + np.sqrt(rod**2 - (lever * (1 + cos(half)) / 2 - at.imag) ** 2)
        assert bool((np.diff(ram) < -1e-9).any()) is goes_back


def test_no_best_angle_is_refused_for_the_reason_that_holds() -> None:
    best = "CD: 50 mm, swing: 60 deg, best: gamma_min"
    assert "θ = 120 deg is too large" in refused("crank-rocker", f"K: 5, {best}")
    assert "the coupler gets longer" in refused("crank-rocker", f"K: 1, {best}")


def test_a_rod_that_is_taken_for_the_motion_alone_is_told() -> None:
    assert "and a rod DE = 240 mm of our choice" in told("whitworth", "K: 2, H: 160 mm, AC: 60 mm", "AB, CD")
    assert "of our choice" not in told("whitworth", "K: 2, H: 160 mm, AC: 60 mm, DE: 240 mm", "AB, CD")


def test_sums_of_lengths_that_differ_by_rounding_are_equal() -> None:
    kind, margin = grashof(56.25, 123.75, 60.0, 127.5)
    assert margin == 0 and kind.en == "crank-rocker"
    assert grashof(56.25, 123.75, 60.0, 127.6)[1] == pytest.approx(-0.1)


def test_a_limit_that_is_zero_is_no_bar_that_has_vanished() -> None:
    text = PROBLEM.format(kind="grashof", data="AB: 40 mm, BC: 60 mm, CD: 50 mm, AD: 100 mm", find="CD_min, CD_max")
    solution = solve(loads(text), by="exact", repeats=0)
    assert solution.answers["CD_min"].drawn == pytest.approx(0, abs=1e-9) and not solution.verification


@pytest.mark.parametrize(("name", "low"), [("K-crank-rocker-BC", "every solution"), ("8-15", "solution 2 ")])
def test_of_several_solutions_that_with_the_largest_transmission_angle_is_preferred(name: str, low: str) -> None:
    solution = solve(load(name))
    found = preferred(solution)
    one, two = (moved.gamma for moved in solution.verification)
    assert found is not None and one > two + 1 and low in found.en.lower() and found.zh in moved_told(solution, "zh")
    assert "olution 1, " in found.en and "解 1 的" in found.zh


def test_of_solutions_with_all_but_equal_transmission_angles_none_is_preferred() -> None:
    found = preferred(solve(load("8-4")))
    assert found is not None and "every solution" in found.en.lower() and "preferable" not in found.en


def test_a_lone_solution_is_not_preferred_to_others() -> None:
    assert preferred(solve(load("8-12"))) is None


@each(Later(lambda: few([one.id for one in library() if isinstance(load(one.id).subject, Design)], 4)))
def test_a_lone_solution_below_the_usual_transmission_angle_is_said_to_be(name: str) -> None:
    """8-14 had γ_min = 22.5° and no word about it."""
    solution = solve(load(name), by="exact", repeats=0, precise=False)
    if len(solution.verification) != 1:
        return
    (one,) = solution.verification
    least = one.gamma if one.full else one.between
    for lang in ("zh", "en"):
        assert ("40°" in moved_told(solution, lang)) == (one.broken is None and least < 39.5), (name, least)


def test_the_cutter_is_said_to_transmit_force_poorly_and_a_good_linkage_is_not() -> None:
    assert "传力性能较差" in moved_told(solve(load("8-14")), "zh") and not moved_told(solve(load("8-17")), "en")


def test_on_either_circle_a_and_its_trial_positions_have_the_letters_that_the_steps_name() -> None:
    """A′ stood on the second circle, between 1′ and 2′, and the steps and its curve spoke of 1 and 2. A′ is the A of
    the second solution, whichever circle has it."""
    construction = drawn("best-gamma").construction
    charts = [figure for figure in construction.figures if figure.name.startswith("gamma of A")]
    assert len(charts) == 2
    for figure, primes in zip(charts, ("", "′"), strict=True):
        letters = {mark.label for mark in figure.marks if isinstance(mark, Point) and "/" not in mark.label}
        assert letters - {""} == {f"A{primes}", *(f"{n}{primes}" for n in range(1, 8))}
        assert figure.title.zh.startswith(f"$A$ 在圆 $η{primes}$")
        taken = "同样选取" if primes else "最大的一点为"
        assert any(f"{taken} $A{primes}$。" in step.words.zh for step in construction.steps)
        (chosen,) = (step.words for step in construction.steps if f"在圆 $η{primes}$ 上依次取" in step.words.zh)
        assert f"1{primes}、2{primes}、3{primes}" in chosen.zh and "of $A$ on the circle" in chosen.en
