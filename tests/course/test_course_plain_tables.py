"""Tables of a course report hold what a reader needs: no columns of dashes, numbers under each other, pages filled."""

from __future__ import annotations

import re
from math import inf

import pytest

from tests.laws import few
from tests.studies import course_text, stations, studied
from vecpoly.report.content import Objects
from vecpoly.report.course.checks import comparison
from vecpoly.report.course.checks.three_digits import figures
from vecpoly.report.course.numbering import Press
from vecpoly.report.course.results.chapter import sections
from vecpoly.report.course.results.circling import is_trivial
from vecpoly.report.course.results.extreme_values import extremes
from vecpoly.report.flow.table import DataTable
from vecpoly.report.flow.xml import to_flowables
from vecpoly.typeset.box import MM
from vecpoly.words import Lang, Words


def made(header: list[str], rows: list[tuple[str, ...]], align: str) -> DataTable:
    """A table as a press makes it."""
    kept = Press("en", Objects())
    table = kept.objects.named[kept.table(Words("表", "Told"), header, rows, align)]
    assert isinstance(table, DataTable)
    return table


def test_a_column_of_dashes_is_left_out_and_one_with_a_single_number_is_not() -> None:
    table = made(["a", "b", "c"], [("1", "—", "—"), ("2", "—", "3")], "lcr")
    assert table.header == ("a", "c") and table.align == "lr" and table.rows == (("1", "—"), ("2", "3"))


def test_a_table_in_two_halves_keeps_its_columns_and_an_empty_one_its_head() -> None:
    assert made(["a", "b", "", "a", "b"], [("1", "—", "", "2", "3")], "rrrrr").header == ("a", "b", "", "a", "b")
    assert made(["a", "b"], [], "rr").header == ("a", "b")


@pytest.mark.parametrize("name", few(["A-27", "stephenson-valve-gear"], 2))
def test_no_table_of_a_course_report_has_a_column_of_dashes(name: str) -> None:
    _, objects = course_text(name, "zh")
    tables = [one for one in objects.named.values() if isinstance(one, DataTable)]
    assert len(tables) > 8
    for table in tables:
        columns = list(zip(*table.rows, strict=True))
        assert "" in table.header or all(set(column) - {"—", ""} for column in columns), table.caption


def test_a_table_that_goes_on_fills_its_page_with_whole_bands_but_for_the_rows_that_go_on() -> None:
    rows = [(str(10 * n), "1.0") for n in range(37)]
    table = DataTable(["a", "b"], rows, None, "rr", lang="zh", caption="表 5-2　转角")
    table.whole = True
    table.wrap(160 * MM, 1e4)
    low = (table.height - 12.0) / 37  # a row is no lower
    for height in range(330, int(table.height), 15):
        head, _, tail = table.split(160 * MM, float(height))
        head.wrap(160 * MM, 1e4)
        assert len(head.rows) % 6 == 0
        assert len(tail.rows) < 10 or height - head.height < 6.3 * low, "a band more would have had room"
        assert tail.caption == "续表 5-2"


def test_the_deviations_stand_under_each_other_by_their_points() -> None:
    it = studied("3-9")
    kept = Press("en", Objects())
    name = comparison.chapter(it, kept, stations("3-9"))["table"]
    table = kept.objects.named[name]
    assert isinstance(table, DataTable) and table.align.count("d") >= 3
    for column, way in enumerate(table.align):
        if way == "d" and "%" not in table.header[column]:
            digits = [re.sub(r"^0\.0*|\.", "", row[column]) for row in table.rows if row[column] != "—"]
            assert all(len(one) == 3 or (one.isdigit() and len(one) > 3) for one in digits), digits
    assert max(len(head.partition(" /")[0]) for head in table.header) <= len("Largest deviation")


@pytest.mark.parametrize(("value", "told"), [(0.3, "0.300"), (0.00023, "0.000230"), (44.2, "44.2"), (1204.6, "1205")])
def test_a_deviation_has_three_digits_with_their_zeros(value: float, told: str) -> None:
    assert figures(value) == told and figures(0.0) == "0"


@pytest.mark.parametrize("lang", few(["zh", "en"], 2))
def test_even_motion_on_a_circle_has_a_sentence_and_neither_table_nor_curves(lang: Lang) -> None:
    """The pin B of the crank in two slots: x_B, y_B = ±50 mm are told by the data."""
    it = studied("pin-in-two-slots")
    assert is_trivial(it, "B") and not is_trivial(studied("3-9"), studied("3-9").points[-1])
    kept = Press(lang, Objects())
    told = next(one for one in sections(it, kept) if "$B$" in one["title"])
    assert told["before"] and not told["tables"] and not told["figures"]
    assert "$|v_{B}|$ = 0.5 m/s" in told["words"] and "$|a_{B}|$ = 5 m/s²" in told["words"]
    table = kept.objects.named[extremes(it, kept)]
    assert isinstance(table, DataTable) and table.rows and not any("_{B}" in row[0] for row in table.rows)


def test_a_table_that_is_read_down_one_half_and_then_the_other_is_not_parted() -> None:
    table = DataTable(["a", "", "a"], [(str(n), "", str(n)) for n in range(14)], None, "lll", lang="zh")
    assert table.split(160 * MM, 150.0)
    table.undivided = inf
    assert not table.split(160 * MM, 150.0)


@pytest.mark.parametrize("name", few(["A-27", "compound-hinge-six-bar"], 2))
def test_the_list_of_symbols_stands_on_one_page(name: str) -> None:
    text, objects = course_text(name, "zh")
    to_flowables(text, objects.named, "zh")
    (table,) = (one for one in objects.named.values() if isinstance(one, DataTable) and one.caption == "主要符号")
    assert table.undivided and len(table.rows) <= 20


def test_where_the_loads_alone_cannot_move_it_the_balancing_one_drives_with_them() -> None:
    found = stations("4-4")
    assert not found.refused and len(found.stations) == comparison.STATIONS
    assert found.worst(studied("4-4")) < 0.005


def test_links_that_turn_evenly_have_their_rate_in_words_and_neither_table_nor_plot() -> None:
    """Angles that grow evenly are no results; a link that does not turn evenly has all three columns."""
    kept = Press("en", Objects())
    even, uneven = (sections(studied(name), kept)[0] for name in ("stepped-planet", "pin-in-two-slots"))
    assert "$ω_{2}$ = −20 rad/s and $α_{2}$ = −60 rad/s^2" in even["words"]
    assert not even["tables"] and not even["figures"]
    assert uneven["tables"] and uneven["figures"]
