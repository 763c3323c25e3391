"""Numbers of a column stand under each other by their points; a column keeps the zeros that were read."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from tests.studies import solved
from vecpoly.algebra.columns import padded, with_zeros
from vecpoly.algebra.formula import plain
from vecpoly.report.flow.results.decimal import aligned, grouped
from vecpoly.report.flow.table import DataTable
from vecpoly.report.tables import trimmed
from vecpoly.typeset.box import MM

EM = 9.5 / MM
NUMBERS = st.decimals(-9999, 9999, allow_nan=False, places=2).map(lambda n: str(n).replace("-", "−"))


@given(st.lists(NUMBERS, min_size=1, max_size=8))
def test_every_point_of_a_column_has_one_place(texts: list[str]) -> None:
    column = aligned(texts, EM, False)
    points = []
    for text in texts:
        indent = column.indent(text, 60.0)
        whole = aligned([text], EM, False)
        assert indent is not None and 0.0 <= indent <= 60.0 - column.width + column.before
        points.append(indent + whole.before)
    assert max(points) - min(points) < 1e-9


def test_a_value_beside_its_length_on_paper_stands_by_its_own_point() -> None:
    texts = ("0.077 m/s", "210 mm ≙ 0.08085 m/s", "−12.6 m/s")
    column = aligned(texts, EM, False)
    points = []
    for text in texts:
        indent = column.indent(text, 80.0)
        assert indent is not None
        points.append(indent + aligned([text], EM, False).before)
    assert max(points) - min(points) < 1e-9
    before = aligned(texts[1:2], EM, False).before
    assert before > aligned(["210 mm ≙"], EM, False).width


def test_what_is_no_number_is_centred() -> None:
    assert aligned(["0.5", "—"], EM, False).indent("—", 40.0) is None


def test_a_plain_zero_among_numbers_with_decimals_is_centred() -> None:
    assert aligned(["0", "5.000"], EM, False).indent("0", 40.0) is None
    assert aligned(["0", "12"], EM, False).indent("0", 40.0) is not None


def test_zeros_that_were_read_are_kept_in_a_table_of_stations() -> None:
    assert padded([("0", "4.35"), ("1", "15"), ("2", "—")]) == (("0", "4.35"), ("1", "15.00"), ("2", "—"))


def test_numbers_of_many_figures_get_no_zeros_that_nobody_read() -> None:
    rows = [("−6.828",), ("−176.6",)]
    assert padded(rows) == tuple(rows)


def test_a_column_in_which_nothing_stands_is_left_out() -> None:
    table = trimmed(["a", "b", "c"], [["1", "—", ""], ["2", "—", "3"]], (), "ldd")
    assert table.header == ("a", "c") and table.align == "ld"


def test_a_table_is_as_wide_as_its_aligned_numbers() -> None:
    narrow = DataTable(["x"], [["1.5"], ["2.5"]], None, "d")
    wide = DataTable(["x"], [["1111.5"], ["2.5555"]], None, "d")
    for table in (narrow, wide):
        table.wrap(500.0, 500.0)
    (one,), (two,) = narrow.set_in(500.0).widths, wide.set_in(500.0).widths
    assert two > one


def test_a_value_with_which_several_lines_go_on_has_one_form_in_all_of_them() -> None:
    """ω_1 = 12.566 also where 12.57 would do, since another line needs it."""
    lines = [plain(line) for step in solved("press-flywheel").construction.steps for line in step.formulas]
    with_it = [line for line in lines if "12.5" in line]
    assert len(with_it) > 5 and all("12.566" in line for line in with_it)
    assert any("ω_1\u2009l_AB = 12.566 × 0.1 = 1.257" in line for line in with_it)


def test_numbers_of_other_units_do_not_push_a_unit_s_own_aside() -> None:
    texts, units = ["0.2825", "6161", "0.5", "12"], ["kg·m²", "N", "kg·m²", "N"]
    columns = grouped(texts, units, EM, False)
    assert columns[0] == columns[2] == aligned(["0.2825", "0.5"], EM, False)
    assert columns[1] == columns[3] == aligned(["6161", "12"], EM, False) != columns[0]


def test_numbers_of_neighbouring_columns_do_not_run_into_each_other_where_room_is_short() -> None:
    """A column that is narrowed keeps the room of its aligned numbers; a length on paper before a value breaks off."""
    told = "wrong: follows from the values printed before it, which a long verdict says at length"
    rows = [["22.105 kg", "21.564 kg", told], ["0.00597 kg·m²", "0.0077642 kg·m²", told]]
    table = DataTable(["a", "b", "c"], [*rows, ["113 mm ≙ 0.02882 m/s", "1.3347 m/s", told]], None, "ddl")
    found = table.set_in(110.0 * MM)
    assert sum(found.widths) <= 110.0 + 1e-6 and len(found.body[2][0]) == 2
    for column, width in zip(found.points[:2], found.widths, strict=False):
        assert column is not None and all(one.width <= width for one in column)


def test_a_zero_has_the_decimals_of_the_numbers_under_which_it_stands() -> None:
    assert with_zeros(("0", "90.0", "—")) == ("0.0", "90.0", "—")
    assert with_zeros(("0", "1.25", "3.5")) == ("0", "1.25", "3.5"), "they have no one count"
    assert with_zeros(("0", "90.0", "0"), ("N", "°", "°")) == ("0", "90.0", "0.0"), "each unit its own"
