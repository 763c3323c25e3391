"""What was found is said in its step and once in the answer, which sets what was read beside the exact values."""

from __future__ import annotations

import re
from io import BytesIO

import pytest
from pypdf import PdfReader

from tests.drawn_library import DRAFTED, IDS, drafted, drawn
from tests.each import each
from tests.framed_answers import rows_in, tables_of
from tests.laws import few
from vecpoly.algebra.formula import Txt, named, plain
from vecpoly.algebra.quantity import Product, magnitude
from vecpoly.algebra.worked import told_again, worked
from vecpoly.problem.load import load
from vecpoly.report.answers.box import answer_box
from vecpoly.report.answers.rows import BY_FORMULA
from vecpoly.report.answers.tables import counted, readings_tables
from vecpoly.report.document import report_bytes
from vecpoly.report.flow.results.box import PAD
from vecpoly.report.flow.results.framed import FramedTable
from vecpoly.report.flow.results.halved import LONG
from vecpoly.report.flow.table import DataTable
from vecpoly.solution import YES_NO, solve
from vecpoly.typeset.box import MM
from vecpoly.words import Lang

INNER = (170.0 - 2 * PAD) * MM
LANGS: tuple[Lang, ...] = ("zh", "en")
_SAID_ABOVE = ("On paper", "Scale", "图上长度", "比例尺")


@each(DRAFTED)
def test_the_answer_has_no_column_of_what_the_steps_say(name: str) -> None:
    solution = drafted(name)
    for lang in LANGS if solution is not None else ():
        assert solution is not None
        heads = [head for table in tables_of(answer_box(solution, lang)) for head in table.header]
        assert not [head for head in heads if head.startswith(_SAID_ABOVE)]


@pytest.mark.parametrize("name", few(["3-9", "4-3a", "8-14"], 2))
def test_no_sheet_of_a_report_says_what_its_box_of_answers_says(name: str) -> None:
    pages = PdfReader(BytesIO(report_bytes([solve(load(name))], lang="en"))).pages
    sheets = [text for page in pages if "50 mm when printed" in (text := page.extract_text())]
    assert sheets and not any("Results" in text for text in sheets)


@each(DRAFTED)
def test_a_unit_stands_in_the_head_of_its_column_and_only_another_one_beside_its_number(name: str) -> None:
    solution = drafted(name)
    for table in tables_of(answer_box(solution, "en")) if solution is not None else ():
        for n, head in enumerate(table.header):
            unit, cells = head.partition(" /")[2].strip("{}"), [row[n].rstrip("*") for row in table.rows]
            assert not unit or not [cell for cell in cells if cell.endswith(unit)], head
            if head.startswith(("Deviation", "Expected error")):
                own = [cell for cell in cells if " " in cell or "°" in cell]
                told = [cell for cell in cells if cell != "—" and cell not in own]
                assert len(told) >= len(own) if unit else not told


@each(DRAFTED)
def test_whatever_was_read_has_a_row_and_what_is_counted_a_line(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    box = answer_box(solution, "en")
    rows = {key for row in rows_in(box) for key in row.keys}
    for answer in solution.answers.values():
        read = answer.expected_error > 1e-9 * abs(answer.exact) and answer.reading.unit != YES_NO
        assert not read or answer.key in rows, answer.key
        assert not counted(answer) or answer.key not in rows, answer.key
    computed = {key for row in rows_in(box) for key in row.keys if row.exact == BY_FORMULA.en}
    assert len(computed) <= len(rows - computed), "many that are computed are no table"


@pytest.mark.parametrize("name", ["peaucellier", "A-27", "4-5-circles"])
def test_a_lone_point_has_a_row_among_the_values(name: str) -> None:
    solution = solve(load(name), repeats=20)
    box = answer_box(solution, "en")
    assert len(tables_of(box)) == 1
    (row,) = (row for row in rows_in(box) if solution.answers[row.keys[0]].is_place)
    assert row.value.startswith("(") and row.exact.startswith("(") and row.off.endswith(" mm") and "mm" in row.error


def test_points_that_are_several_or_all_that_is_asked_have_their_table() -> None:
    assert len(tables_of(answer_box(solve(load("3-6"), repeats=20), "en"))) == 2
    (table,) = tables_of(answer_box(solve(load("3-1d"), repeats=20), "en"))
    assert table.header[0] == "Point" and "Distance /mm" in table.header


def test_what_vanishes_has_its_expected_error_in_its_own_unit() -> None:
    (row,) = (row for row in rows_in(answer_box(solve(load("hypocycloid-drive")), "en")) if "alpha_2" in row.keys)
    assert (row.value, row.exact, row.off) == ("0", "0", "—") and row.error.endswith(" rad/s^2")


@each(IDS)
def test_long_tables_that_are_narrow_stand_in_two_halves_side_by_side(name: str) -> None:
    for lang in LANGS:
        for table in tables_of(answer_box(drawn(name).solution, lang)):
            table.wrap(INNER, 1e4)
            halves = table._parted(INNER)
            if halves is None:
                continue
            first, second = halves
            assert len(table.rows) > LONG and (*first.rows, *second.rows) == table.rows
            assert 0 <= len(first.rows) - len(second.rows) <= 1
            assert first.header == second.header == table.header


def test_halves_take_little_more_than_half_the_height_and_are_not_torn() -> None:
    rows = [(f"$l_{{{n}}}$", f"{n}.5", f"{n}.51", "+0.1", "1.2") for n in range(12)]
    table = FramedTable(("Quantity", "Drawn", "Exact", "Deviation", "Expected"), rows, None, "ldddd", lang="en")
    high, alone = table.wrap(INNER, 1e4)[1], DataTable(table.header, rows, None, "ldddd", lang="en")
    assert table._parted(INNER) is not None and high < 0.65 * alone.wrap(INNER, 1e4)[1]
    assert table.split(INNER, 0.8 * high) == []


@pytest.mark.parametrize(("lang", "word"), [("zh", "计算值"), ("en", "computed")])
def test_the_answer_says_what_is_computed_and_ends_without_a_sentence_on_it(lang: Lang, word: str) -> None:
    text = "".join(
        page.extract_text() for page in PdfReader(BytesIO(report_bytes([solve(load("7-6"))], lang=lang))).pages
    )
    assert word in text and "未列的量" not in text and "not listed" not in text


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_every_value_of_an_answer_is_printed_in_its_step_and_in_the_answer_and_nowhere_else(lang: Lang) -> None:
    """No box and table and sentence of the same numbers."""
    solution = solve(load("3-9"))
    text = "".join(page.extract_text() for page in PdfReader(BytesIO(report_bytes([solution], lang=lang))).pages)
    after = text[text.index("3σ") :].partition({"zh": "原书答案的校核", "en": "Textbook answers compared"}[lang])[0]
    values = [row.value for row in rows_in(answer_box(solution, lang))]
    for one in (value for value in values if len(value) > 3):
        assert len(re.findall(rf"(?<![\d.]){re.escape(one)}(?![\d.])", after)) == values.count(one), one


def test_what_the_columns_mean_is_explained_once_in_a_report_of_several_problems() -> None:
    solutions = [solve(load(name)) for name in ("3-9", "3-5")]
    text = "".join(page.extract_text() for page in PdfReader(BytesIO(report_bytes(solutions, lang="en"))).pages)
    assert text.count("3σ") == 1 and " ".join(text.split()).count("counter-clockwise from the x axis") == 1


def test_what_is_one_vector_by_the_drawing_and_exactly_is_checked_in_one_row() -> None:
    (table,) = readings_tables(solve(load("3-14")), "en")
    symbols = [row[0] for row in table.rows]
    assert "$v_{B3}$ = $v_{C}$" in symbols and "$a_{B3}$ = $a_{C}$" in symbols
    assert len(table.rows) == len(set(symbols)) == 7, "v_B2, v_B3B2, ω_2, a_B2, a^r_B3B2 by themselves"


def test_a_quantity_under_another_name_keeps_that_name_where_its_end_is_told_again() -> None:
    line = worked(named("J_e"), Product((magnitude("J_1", 0.2, "kg*m^2"),)), "kg·m²")
    again = told_again(line, Txt(" = 0.20 kg·m²"), "0.20", lambda node, value: "")
    assert plain(line) == "J_e = J_1 = 0.2 kg·m²" and plain(again) == "J_e = J_1 = 0.20 kg·m²"
