"""A reader who rounds what lies midway up is told why a printed result went down."""

from __future__ import annotations

import pytest

from tests.studies import solved
from vecpoly.printed.midway import goes_down, some_go_down
from vecpoly.problem.load import load
from vecpoly.report.content import scales, statement
from vecpoly.solution import solve


@pytest.mark.parametrize(("name", "down"), [("lift-gate", True), ("geared-five-bar", False)])
def test_that_midway_goes_to_the_even_digit_is_said_where_it_goes_down(name: str, down: bool) -> None:
    """0.0225/0.0004 = 56.25 is told as 56.2; 3.5/0.08 = 43.75 as 43.8, as everybody would."""
    solution = solved(name)
    assert some_go_down(solution.construction) is down
    assert bool(statement(solution, "zh")["to_even"]) is down


def test_a_title_in_brackets_has_none_of_its_own() -> None:
    assert "）)" not in scales(solved("straight-roberts"), "zh").replace("））", "）)")


@pytest.mark.parametrize(
    ("line", "down"),
    [
        ("ω_3 = (μ_v pc)/(l_DC) = (0.005 × 32.5)/(0.08) = 2.0312 rad/s ≈ 2.03 rad/s", True),
        ("l_AB = μ_l AB_2 = 0.0015 × 18.3 = 0.0274 m = 27.4 mm", True),
        ("l_BC = μ_l (A′C_2 + A′C_1)/(2) = 0.0025 × (25.3 + 5.3)/(2) = 0.0382 m = 38.2 mm", True),
        ("l_BC = μ_l (A′C_2 + A′C_1)/(2) = 0.0025 × (25.3 + 5.4)/(2) = 0.0384 m = 38.4 mm", False),
        ("x = −a b^2 = −0.5 × 5^2 = −12 m", True),
        ("l_AB = μ_l AB_2 = 0.0015 × 18.4 = 0.0276 m = 27.6 mm", False),
    ],
)
def test_what_goes_down_is_seen_where_the_line_goes_on_behind_its_result(line: str, down: bool) -> None:
    assert goes_down(line) is down


def test_a_synthesis_says_so_too() -> None:
    assert statement(solve(load("dead-centre")), "zh")["to_even"]
