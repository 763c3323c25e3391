"""The table of verification of a synthesis."""

from __future__ import annotations

from functools import cache

import pytest

import vecpoly
from vecpoly.report.verification import verification_table


@cache
def table(name: str) -> dict[str, tuple[str, ...]]:
    """Item by item what is said of each solution."""
    found = verification_table(vecpoly.load(name).solve(by="drafting", seed=1), "en")
    assert found is not None
    return {row[0]: tuple(row[1:]) for row in found.rows}


def test_both_solutions_of_8_4_stand_beside_their_exact_values() -> None:
    found = table("8-4")
    assert all(text.endswith("(1.5)") and abs(float(text.split()[0]) - 1.5) < 0.01 for text in found["$K$ (exact)"])
    assert [text.partition("(")[2] for text in found["Swing (exact)"]] == ["40.74°)", "105.8°)"]
    assert all(text.startswith("crank-rocker") for text in found["Type (margin of lengths)"])
    assert found["The driver turns fully"] == ("yes", "yes")


@pytest.mark.parametrize("name", ["8-4", "8-8", "8-13", "8-18", "three-positions"])
def test_the_bars_of_a_solution_have_one_length_in_all_its_positions(name: str) -> None:
    differ = table(name)["Closes in its positions; bars differ by"]
    assert all(float(text.split()[0]) < 0.5 for text in differ)


def test_three_positions_are_passed_in_their_order_and_two_have_none() -> None:
    assert table("8-8")["Passes through them in order"] == ("1 → 2 → 3",)
    assert "Passes through them in order" not in table("8-13")


def test_what_a_solution_has_not_leaves_no_line() -> None:
    assert not any("Swing" in item or "Stroke" in item for item in table("8-13"))
    assert verification_table(vecpoly.load("3-9").solve(), "en") is None
