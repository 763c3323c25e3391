"""A table among what is given stands on the page: a printed problem can be solved without a file beside it."""

from __future__ import annotations

import pytest

from tests.lawful import CARD, ENGINE, slider
from vecpoly.problem.load import load
from vecpoly.problem.problem import Problem
from vecpoly.report.tables import MOST_GIVEN, given_tables
from vecpoly.words import Lang


def shown(problem: Problem) -> list[tuple[str, str]]:
    """The pairs of the one table, block by block."""
    (table,) = given_tables(problem, "en")
    wide = range(0, len(table.header), 3)
    return [(row[at], row[at + 1]) for at in wide for row in table.rows if row[at]]


def test_an_indicator_card_is_printed_with_its_units() -> None:
    problem = load("engine-card")
    (table,) = given_tables(problem, "zh")
    assert table.header[:2] == ("$φ$ /°", "$p$ /MPa")
    pairs = shown(problem)
    assert pairs[:2] == [("0", "2.20"), ("10", "3.40")] and pairs[-1] == ("720", "2.20") and len(pairs) == 19
    assert ("380", "−0.01") in pairs


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_what_is_given_names_the_table_by_its_quantities_and_no_file(lang: Lang) -> None:
    told = " ".join(datum.of(lang) for datum in load("engine-card").given.loads)
    assert {"zh": "$F$ 由 $p$–$φ$ 数据表给出", "en": "$F$ by the table of $p$ over $φ$"}[lang] in told
    assert ".csv" not in told


def test_a_table_that_would_fill_pages_is_not_printed() -> None:
    rows = ", ".join(f"[{n / 2}, {n}]" for n in range(MOST_GIVEN + 1))
    long = f"columns: [s (mm), p (MPa)], rows: [{rows}]"
    assert not given_tables(slider(ENGINE.replace(CARD, long)), "en")
    assert len(given_tables(slider(ENGINE), "en")) == 1


def test_a_problem_without_a_table_has_none() -> None:
    assert not given_tables(load("3-9"), "zh")
