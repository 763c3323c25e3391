"""The table of answers prints what the solution holds:
length on paper, drawn, exact, deviation, expected error, in the unit of its line."""

from __future__ import annotations

import re

import pytest

from vecpoly.algebra.formula import Txt
from vecpoly.algebra.quantity import magnitude
from vecpoly.printed.units import printed_unit
from vecpoly.problem.load import load
from vecpoly.report.answers.tables import readings_tables
from vecpoly.solution import Solution, solve


def number(text: str) -> float:
    """The first number of a cell."""
    found = re.search(r"[−-]?\d+(?:\.\d+)?", text)
    assert found, text
    return float(found[0].replace("−", "-"))


@pytest.fixture(scope="module", params=["3-5", "4-3a", "six-bar-dynamic"])
def solution(request: pytest.FixtureRequest) -> Solution:
    return solve(load(request.param), repeats=40)


def test_every_number_of_the_table_is_that_of_the_answer(solution: Solution) -> None:
    (table,), seen = readings_tables(solution, "en"), 0
    assert len(table.rows) == len(solution.answers)
    for cells, answer in zip(table.rows, solution.answers.values(), strict=True):
        row = dict(zip(table.header, map(str, cells), strict=True))
        sense = -1 if answer.sense == "cw" else 1  # the way that stands in the column of directions counts
        factor = printed_unit(answer.reading.unit)[0] * sense
        if any("10^" in cell or "{" in row[name] for name, cell in row.items() if name != "Quantity"):
            continue  # a power of ten
        kept = max(5e-4 * abs(factor * answer.drawn), 0.25 * abs(factor) * answer.expected_error)  # no less than read
        assert number(row["Drawn"]) == pytest.approx(factor * answer.drawn, abs=kept)
        assert number(row["Exact"]) == pytest.approx(factor * answer.exact, abs=kept)
        length = row.get("On paper /mm", "—")  # no column of them where few values are read
        if answer.reading.mm is not None and length != "—":  # reckoned and laid off: not read
            assert number(length) == pytest.approx(answer.reading.mm, abs=0.051)
        if not answer.computed:
            here, there = number(row["Drawn"]), number(row["Exact"])  # whoever reads the table reckons with these
            deviation = 100 * (here - there) / abs(there)
            assert number(row["Deviation /%"]) == pytest.approx(deviation, abs=0.0051)
            expected = 100 * answer.expected_error / abs(answer.exact)
            half = 0.501 * 10.0 ** -len(row["Expected error /%"].partition(".")[2])  # as many decimals in all rows
            assert number(row["Expected error /%"]) == pytest.approx(expected, rel=0.06, abs=half)
            seen += 1
    assert seen >= 3


@pytest.mark.parametrize(("value", "shown"), [(3.0, "3"), (-3.0, "(-3)"), (0.0, "0"), (-0.25, "(-0.25)")])
def test_a_negative_number_in_a_product_stands_in_brackets_and_no_other(value: float, shown: str) -> None:
    node = magnitude("v", value, "m/s").numbers()
    assert isinstance(node, Txt) and node.text.replace("−", "-") == shown
