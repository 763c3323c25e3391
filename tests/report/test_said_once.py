"""The box of answers says lengths, scales and directions; the table of the check sets what was read beside the exact
values."""

from __future__ import annotations

import re
from io import BytesIO

import pytest
from pypdf import PdfReader
from vecpoly.report.answers.checks import check_tables, check_words, checked, unlisted

from tests.drawn_library import DRAFTED, IDS, drafted, drawn
from tests.each import each
from tests.laws import few
from vecpoly.algebra.formula import Txt, named, plain
from vecpoly.algebra.quantity import Product, magnitude
from vecpoly.algebra.worked import told_again, worked
from vecpoly.printed.digits import exact_number
from vecpoly.problem.load import load
from vecpoly.report.answers.placed import clean
from vecpoly.report.answers.tables import readings_tables, sign_of_deviation, tabled
from vecpoly.report.document import report_bytes
from vecpoly.report.flow.results.halved import LONG, HalvedTable
from vecpoly.report.values import called
from vecpoly.solution import solve
from vecpoly.typeset.box import MM
from vecpoly.words import Lang

COLUMN = 170.0 * MM
NUMBER_AND_UNIT = re.compile(r"[\d.]+ \S")
_SAID_ABOVE = ("On paper", "Scale", "Direction", "图上长度", "比例尺", "方向")


@each(DRAFTED)
def test_no_column_of_the_check_says_what_the_box_of_answers_says(name: str) -> None:
    solution = drafted(name)
    for lang in ("zh", "en") if solution is not None else ():
        assert solution is not None
        heads = [head for table in check_tables(solution, lang) for head in table.header]
        assert not [head for head in heads if head.startswith(_SAID_ABOVE)]


@pytest.mark.parametrize("name", few(["3-9", "4-3a", "8-14"], 2))
def test_no_sheet_of_a_report_says_what_its_box_of_answers_says(name: str) -> None:
    pages = PdfReader(BytesIO(report_bytes([solve(load(name))], lang="en"))).pages
    sheets = [text for page in pages if "50 mm when printed" in (text := page.extract_text())]
    assert sheets and not any("Results" in text for text in sheets)


@each(DRAFTED)
def test_a_column_of_the_check_has_one_unit_which_stands_in_its_head(name: str) -> None:
    """But where some are off by per cents and others by degrees, which share one table."""
    solution = drafted(name)
    for table in check_tables(solution, "en") if solution is not None else ():
        assert solution is not None
        shared = len({sign_of_deviation(one) for one in tabled(checked(solution))[1]}) > 1
        cells = [cell for row in table.rows for cell in row[1:]]
        assert shared or not [cell for cell in cells if cell.endswith(("%", "°")) or NUMBER_AND_UNIT.match(cell)]


@each(DRAFTED)
def test_whatever_was_read_is_checked_and_what_is_computed_has_no_row(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    every, told = [row for table in check_tables(solution, "en") for row in table.rows], check_words(solution, "en")
    rows = {symbol: row for row in every for symbol in re.split(r"(?<=\$) = |(?<=[$)]), ", row[0])}
    listed = {one.key for one in checked(solution)}
    for answer in solution.answers.values():
        read = answer.expected_error > 1e-9 * abs(answer.exact)
        assert not read or answer.key in listed, answer.key
        if answer.key in listed and not answer.is_place:
            name, exact = called(answer.reading.symbol, answer.key, "en"), exact_number(answer, clean(answer))
            if f"The value of {name} was read as" in told:  # alone
                assert f"exactly it is {exact}" in told and name not in rows
                continue
            if name not in rows:  # it vanishes, as others do
                assert exact == "0" and re.search(rf"{re.escape(name)}.*were read as 0", told)
                continue
            row = rows[name]
            assert row[1:] != ("—",) * (len(row) - 1)
            assert exact in row or answer.reading.unit == "yes/no"
    assert unlisted(solution) is (0 < len(listed) < len(solution.answers))


@pytest.mark.parametrize("name", ["peaucellier", "A-27", "4-5-circles"])
def test_a_lone_point_has_a_sentence_in_place_of_a_table_of_one_row(name: str) -> None:
    solution = solve(load(name), repeats=20)
    (table,) = check_tables(solution, "en")
    (place,) = (one for one in checked(solution) if one.is_place)
    assert len(table.rows) > 1 and check_words(solution, "en").startswith(
        f"Point ${place.reading.symbol}$ was drawn at"
    )
    assert check_words(solution, "zh").startswith(f"点 ${place.reading.symbol}$ 量得")


def test_points_that_are_several_or_all_that_is_asked_have_their_table() -> None:
    solution = solve(load("3-6"), repeats=20)
    assert not check_words(solution, "en") and len(check_tables(solution, "en")) == 2


@each(DRAFTED)
def test_a_check_has_one_table_of_values_and_no_row_of_zeros(name: str) -> None:
    solution = drafted(name)
    tables = check_tables(solution, "en") if solution is not None else ()
    assert sum("Distance /mm" not in table.header for table in tables) <= 1
    for table in tables:
        values = [n for n, head in enumerate(table.header) if head.startswith(("Drawn", "Exact"))]
        sizes = [row for row in table.rows if "°" not in row]  # 0° is a direction
        assert len(table.rows) == 1 or not [row for row in sizes if {row[n] for n in values} == {"0"}]


@each(IDS)
def test_a_long_check_stands_in_two_halves_side_by_side(name: str) -> None:
    for lang in ("zh", "en"):
        for table in check_tables(drawn(name).solution, lang):
            assert isinstance(table, HalvedTable)
            table.wrap(COLUMN, 1e4)
            halves = table._parted(COLUMN)
            if halves is None:
                continue
            first, second = halves
            assert len(table.rows) > LONG and (*first.rows, *second.rows) == table.rows
            assert 0 <= len(first.rows) - len(second.rows) <= 1
            assert 2 * sum(first.widths or ()) < 170.0 and first.header == second.header == table.header


def test_halves_take_little_more_than_half_the_height_and_are_not_torn() -> None:
    (table,) = check_tables(solve(load("3-5")), "zh")
    whole = readings_tables(solve(load("3-5")), "zh")[0]
    high = table.wrap(COLUMN, 1e4)[1]
    assert len(table.rows) > LONG and high < 0.65 * whole.wrap(COLUMN, 1e4)[1]
    assert table.split(COLUMN, 0.8 * high) == []


@pytest.mark.parametrize(("lang", "head"), [("zh", "校核"), ("en", "Check")])
def test_the_report_says_that_what_is_not_listed_is_exact(lang: Lang, head: str) -> None:
    text = "".join(
        page.extract_text() for page in PdfReader(BytesIO(report_bytes([solve(load("7-6"))], lang=lang))).pages
    )
    flat = "".join(text.split())
    told = {
        "zh": "未列的量由计算得出，与精确值一致。",
        "en": "Quantities that are not listed were computed, and equal the exact values.",
    }
    assert head in text and told[lang].replace(" ", "") in flat


def test_what_is_one_vector_by_the_drawing_and_exactly_is_checked_in_one_row() -> None:
    (table,) = readings_tables(solve(load("3-14")), "en")
    symbols = [row[0] for row in table.rows]
    assert "$v_{B3}$ = $v_{C}$" in symbols and "$a_{B3}$ = $a_{C}$" in symbols
    assert len(table.rows) == len(set(symbols)) == 7, "v_B2, v_B3B2, ω_2, a_B2, a^r_B3B2 by themselves"


def test_a_quantity_under_another_name_keeps_that_name_where_its_end_is_told_again() -> None:
    line = worked(named("J_e"), Product((magnitude("J_1", 0.2, "kg*m^2"),)), "kg·m²")
    again = told_again(line, Txt(" = 0.20 kg·m²"), "0.20", lambda node, value: "")
    assert plain(line) == "J_e = J_1 = 0.2 kg·m²" and plain(again) == "J_e = J_1 = 0.20 kg·m²"
