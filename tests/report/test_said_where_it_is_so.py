"""What a step says holds in its problem: of a held gear no velocity is laid off, of a moment no force is told."""

from __future__ import annotations

from functools import cache

import pytest

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


@pytest.mark.parametrize("name", ["C-inertia", "plate-on-crank", "plate-two-slides"])
def test_a_component_that_vanishes_has_its_reason(name: str) -> None:
    assert "no moment about it, so $R^t_" in said(name) and ": so" not in said(name)


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
