"""Columns of numbers: rounded once to one count of decimals, that of the figures of the largest."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.algebra.columns import column, significant
from vecpoly.report.flow.results.banded import Rules, is_banded
from vecpoly.report.flow.table import DataTable

MOMENTS = [240.0, 218.625, 197.25, 111.75, 69.0]


def test_a_column_is_rounded_once_and_never_padded_after() -> None:
    assert column(MOMENTS) == ("240.0", "218.6", "197.2", "111.8", "69.0")
    assert column([0.0, 14.25, 28.5, 114.0]) == ("0.00", "14.25", "28.50", "114.00")
    assert column([-0.001, 30.0, 60.0], 0) == ("0", "30", "60") and column([0.0]) == ("0",)


@given(st.lists(st.floats(-1e4, 1e4), min_size=1, max_size=9))
def test_no_number_of_a_column_is_more_than_half_a_unit_beside_what_it_tells(values: list[float]) -> None:
    told = column(values)
    (places,) = {len(text.partition(".")[2]) for text in told}
    for text, value in zip(told, values, strict=True):
        assert abs(float(text.replace("−", "-")) - value) <= 0.5 * 10.0**-places * (1 + 1e-9)


@pytest.mark.parametrize(("value", "told"), [(0.25, "0.2500"), (0.00863, "0.008630"), (0.99996, "1.000"), (0.0, "0")])
def test_a_number_keeps_its_figures(value: float, told: str) -> None:
    assert significant(value) == told


def test_a_long_table_of_numbers_has_white_under_every_sixth_row_and_is_parted_there() -> None:
    """A rule seemed to have strayed where a page break left one of them."""
    degrees = [(str(10 * n), "−0.1") for n in range(37)]
    assert is_banded(degrees) and not is_banded(degrees[:17]) and not is_banded([("$v_B$", "1")] * 37)
    rules = Rules.of(degrees)
    assert [n for n in range(37) if rules.white(0, n)] == [6, 12, 18, 24, 30], "no band is the last row alone"
    assert not any(rules.over(n, row) for n, row in enumerate(degrees))
    assert rules.over(3, ["Σ", "0"]) and not rules.over(3, ["3", "0"]), "the sums stand apart"
    table = DataTable(["φ", "v"], degrees)
    table.wrap(400.0, 1000.0)
    for room in (200.0, 230.0, 260.0):
        first, _, behind = table.split(400.0, room)
        assert len(first.rows) % 6 == 0 and len(first.rows) + len(behind.rows) == 37
    rest = table._part(20, 37, 400.0, table.set_in(400.0))
    assert rest._ruling.banded and rest._before == 20


def test_a_rule_stands_between_positions_of_several_rows_and_over_no_last_row_alone() -> None:
    rules = Rules.of(rows := [("286.3", "v"), ("", "ω"), ("349.1", "v"), ("", "ω")])
    assert [n for n, row in enumerate(rows) if rules.over(n, row)] == [2]
    assert not Rules.of([("v", "1"), ("ω", "2")]).grouped
    long = [(str(n), "1") for n in range(25)]
    assert [n for n in range(25) if Rules.of(long).white(0, n)] == [6, 12, 18]
    assert Rules.of([*long, ("25", "1")]).white(0, 24) and not Rules.of(long).white(6, 0)
