"""What a statement asks in words has its sentence in the box of answers."""

from __future__ import annotations

import pytest

from tests.drawn_library import drafted, given
from vecpoly import loads
from vecpoly.report.content import conclusions
from vecpoly.solution import solve
from vecpoly.words import Lang


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_the_motion_of_a_translating_link_is_told_under_the_symbol_that_the_statement_asks_by(lang: Lang) -> None:
    asked = given("3-5").text.replace("$v_F$", "$v_5$").replace("$a_F$", "$a_5$")
    told = conclusions(solve(loads(asked), repeats=0), lang)
    assert all(any(f"${symbol}$ = $" in text for text in told) for symbol in ("v_5", "a_5"))


def test_an_in_line_four_leaves_the_force_of_second_order() -> None:
    solution = drafted("engine-four")
    assert solution is not None
    (told,) = conclusions(solution, "en")
    assert told == "Left unbalanced is the force of second order $F_{II}$; the others are balanced."
    assert conclusions(solution, "zh") == ["未平衡的是二阶惯性力 $F_{II}$，其余各项均已平衡。"]
