"""What a step says holds in its problem: of a held gear no velocity is laid off, of a moment no force is told."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache

import pytest

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.algebra.formula import plain
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Point
from vecpoly.board.ruler import READABLE
from vecpoly.board.said.short import too_short
from vecpoly.problem.load import load
from vecpoly.solution import solve


@cache
def said(name: str) -> str:
    steps = solve(load(name), repeats=0, precise=False).construction.steps
    return "\n".join(step.words.en for step in steps)


@pytest.mark.parametrize(
    ("name", "held"), [("train-ring", True), ("train-stepped", True), ("train-differential", False)]
)
def test_the_velocity_of_a_held_gear_is_told_to_be_zero_and_not_laid_off(name: str, held: bool) -> None:
    assert ("lay it off in its direction" in said(name)) is ("$v_{C}$ = 0" in said(name)) is held


@pytest.mark.parametrize(("name", "several"), [("2-1", False), ("2-6", True)])
def test_multiple_joints_are_counted_as_above_where_there_were_any(name: str, several: bool) -> None:
    assert ("counted as above" in said(name)) is ("a multiple joint" in said(name)) is several


def test_a_moment_that_does_no_work_is_not_called_a_force() -> None:
    assert "The moment $M_{5}$ does no work" in said("plate-two-slides")


@pytest.mark.parametrize("name", ["plate-on-crank", "plate-two-slides"])
def test_a_component_that_vanishes_has_its_reason(name: str) -> None:
    assert "no moment about it, so $R^t_" in said(name) and ": so" not in said(name)


def test_an_arm_too_short_to_be_read_is_no_force_without_a_moment() -> None:
    """F_I3 is shifted by h_3 and all but passes through C: 0.04 mm on paper at 0.01 m/mm."""
    problem = load("C-inertia")
    small = replace(problem, scales=problem.scales.changed(View.MECHANISM.mu, 0.01))
    told = "\n".join(step.words.en for step in solve(small, repeats=0, precise=False).construction.steps)
    assert "too near for an arm to be read, so $R^t_{43}$ = 0 is taken" in told
    assert "no moment about it" not in told


def test_each_plane_is_judged_by_its_own_permissible_unbalance() -> None:
    assert "circle of radius $U_{perI}$" in said("rotor-grade") and "circle of radius $U_{perII}$" in said(
        "rotor-grade"
    )


@pytest.mark.parametrize(("mm", "short"), [(2.94, True), (2.96, False), (READABLE, False), (0.01, False)])
def test_a_length_that_reads_as_long_enough_is_not_called_too_short(mm: float, short: bool) -> None:
    assert too_short(mm) is short


def test_the_bar_of_a_knife_edge_is_as_long_as_the_circle_alone() -> None:
    (told,) = [
        words
        for step in solve(load("D-3-knife")).construction.steps
        if "OE" in (words := step.words).en and "r_1" in words.en
    ]
    assert "r_1" in told.zh and "r_2" not in told.en + told.zh


def test_a_cylinder_that_lengthens_evenly_has_one_vector_to_shift_and_no_sum_of_two() -> None:
    assert "it is then the thin line $c_2^′c_3^′$" in said("tipper") and "sum of both" not in said("tipper")
    assert "The given vector is shifted so that it ends at $c_3$" in said("tipper")


def test_a_firing_order_is_told_where_it_is_given() -> None:
    assert "firing order" not in said("engine-three") and "In the order of the cylinders" in said("engine-three")
    assert "In firing order" in said("engine-four")


def test_a_rack_is_drawn_through_its_pin_or_at_its_distance() -> None:
    assert "through $B$ draw the pitch line of rack 2" in said("crank-rack-pinion")


@each((*IDS, "shaper-cut"))
def test_a_resultant_on_the_diagram_is_that_of_a_step(name: str) -> None:
    figures = drawn(name).figures(View.MECHANISM)
    labels = {mark.label for figure in figures for mark in figure.marks if isinstance(mark, Point)}
    words = "".join(step.words.en for step in drawn(name).construction.steps)
    for label in labels:
        if re.fullmatch(r"P_\{\d\}", label):
            assert f"${label}$" in words, label


@each((*IDS, "rack-drives-pinion", "3-13", "rack-on-a-rocker", "travel-doubler"))
def test_a_vector_that_is_placed_at_its_point_has_been_told_before(name: str) -> None:
    """v_H of a rack that slides: the pinion's ω came from a v_H that nothing had given."""
    told = ""
    for step in drawn(name).construction.steps:
        own = " ".join(step.equation.symbols) if step.equation is not None else ""
        before = re.sub(r"[{}]", "", f"{told} {own} {' '.join(plain(one) for one in step.formulas)}")
        for symbol in re.findall(r"[Pp]lacing \$(\S+?)\$ at|[Ww]ith \$(\S+?)\$ placed", step.words.en):
            bare = re.sub(r"[{}]", "", "".join(symbol))
            tip = f"${bare.rpartition('_')[2].lower()}$"  # by the image of its link
            assert bare in before or tip in told, f"step {step.number}: {step.words.en}"
        told += f"{step.words.en} {own} {' '.join(plain(one) for one in step.formulas)}"


@each((*IDS, "4-5"))
def test_a_resultant_that_the_frame_balances_is_told_with_where_it_acts(name: str) -> None:
    for step in drawn(name).construction.steps:
        if "parallel to the resultant of the known forces" in step.words.en:
            assert re.search(r"resultant of the known forces(?: and couples)? \(\w", step.words.en), step.words.en
