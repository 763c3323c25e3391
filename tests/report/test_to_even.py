"""A reader who rounds what lies midway up is told why a printed result went down."""

from __future__ import annotations

import pytest

from tests.studies import solved
from vecpoly.printed.midway import some_go_down
from vecpoly.report.content import scales, statement


@pytest.mark.parametrize(("name", "down"), [("lift-gate", True), ("geared-five-bar", False)])
def test_that_midway_goes_to_the_even_digit_is_said_where_it_goes_down(name: str, down: bool) -> None:
    """0.0225/0.0004 = 56.25 is told as 56.2; 3.5/0.08 = 43.75 as 43.8, as everybody would."""
    solution = solved(name)
    assert some_go_down(solution.construction) is down
    assert bool(statement(solution, "zh")["to_even"]) is down


def test_a_title_in_brackets_has_none_of_its_own() -> None:
    assert "）)" not in scales(solved("straight-roberts"), "zh").replace("））", "）)")
