"""Figures open the next page where one has no room for them, and the text runs on; steps are parted where they would
leave a foot blank."""

from __future__ import annotations

import pytest
from reportlab.platypus.flowables import PageBreak

from vecpoly.algebra.formula import Txt
from vecpoly.report.flow.blocks import SMALLEST, Divider, Drawing, Heading, Plate, SheetPage
from vecpoly.report.flow.doc import Metadata, ReportDoc
from vecpoly.report.flow.formula import Formula
from vecpoly.report.flow.paging.tight import settled
from vecpoly.report.flow.paging.together import GAP
from vecpoly.report.flow.para import Para, numbered
from vecpoly.report.flow.table import DataTable
from vecpoly.tagging.tag import Role, Tag

META = Metadata(title="t", lang="en")


def lines(count: int) -> list[Para]:
    """So many paragraphs of one line; 36 of them fill a page."""
    return [Para(f"{n}", lang="en") for n in range(count)]


def sketch(height: float = 100.0) -> Drawing:
    return Drawing(80.0, height, lambda *_: None, sketch=True)


def laid_out(*story: object) -> ReportDoc:
    doc = ReportDoc(story, META)
    doc.counted()
    return doc


@pytest.mark.parametrize("figure", [sketch(), Plate(80.0, 100.0, lambda *_: None)])
def test_the_text_runs_on_where_a_figure_has_no_room_and_the_figure_opens_the_next_page(figure: Drawing) -> None:
    doc = laid_out(*lines(27), figure, *lines(20))
    assert isinstance(doc.heads[2], Drawing) and doc.filled[0] > 0.95
    fixed = Drawing(80.0, 100.0, lambda *_: None)
    assert laid_out(*lines(27), fixed, *lines(20)).filled[0] < 0.8


def test_a_sketch_is_made_smaller_rather_than_put_off_and_a_plate_is_not() -> None:
    figure = sketch()
    whole = figure.wrap(0.0, 0.0)[1]
    smaller = figure.fitted(0.9 * whole)
    assert smaller is not None and smaller.wrap(0.0, 0.0)[1] == pytest.approx(0.9 * whole)
    assert figure.wrap(0.0, 0.0)[1] == whole and figure.fitted((SMALLEST - 0.01) * whole) is None
    assert Plate(80.0, 100.0, lambda *_: None).fitted(0.9 * whole) is None


def test_figures_keep_their_order_and_stand_before_the_next_problem() -> None:
    first, second = sketch(), sketch(30.0)
    doc = laid_out(*lines(27), first, second, *lines(2), PageBreak(), *lines(3))
    assert [type(doc.heads[page]) for page in (1, 2, 3)] == [Para, Drawing, Para] and doc.heads[2].size == first.size
    ended = laid_out(*lines(27), first, *lines(2))
    assert isinstance(ended.heads[2], Drawing) and ended.page == 2


def test_a_figure_that_waits_is_not_drawn_on_a_sheet() -> None:
    sheet = SheetPage(lambda *_: None, title="s")
    sheet.behind = 1
    doc = laid_out(sheet, *lines(27), sketch(), *lines(20))
    assert [type(doc.heads[page]) for page in (1, 2, 3)] == [Para, SheetPage, Drawing]


def test_a_rule_between_two_problems_neither_ends_a_page_nor_begins_one() -> None:
    for count in range(30, 37):
        doc = laid_out(*lines(count), Divider(), Heading("Problem", 2, "en"), *lines(20))
        assert doc.page == 2 and not isinstance(doc.heads[2], Divider)
        if isinstance(doc.heads[2], Heading):
            assert doc.filled[0] < 1 - 2.0 / 700 and count >= 33


def step(formulas: int) -> list[Para | Formula]:
    """A step with so many formulas, held together as a report holds it."""
    sentence = numbered("1.", "A sentence.", "en")
    blocks = [sentence, *(Formula((Txt("a = 1"),)[0]) for _ in range(formulas))]
    for block in blocks[:-1]:
        block.keepWithNext = 1
    return blocks


@pytest.mark.parametrize("count", range(26, 36))
def test_no_formula_is_parted_from_its_sentence_where_the_step_leaves_no_hole(count: int) -> None:
    doc = laid_out(*lines(count), *step(3), *lines(5))
    assert not isinstance(doc.heads.get(2), Formula)


@pytest.mark.parametrize("count", range(21, 36))
def test_a_step_is_parted_behind_a_formula_rather_than_leave_a_foot_blank(count: int) -> None:
    doc = laid_out(*lines(count), *step(14), *lines(5))
    assert doc.filled[0] >= 1 - GAP and isinstance(doc.heads[2], Formula if doc.parted else Para)


@pytest.mark.parametrize("count", range(26, 36))
def test_a_step_that_would_leave_little_of_a_page_goes_to_the_next_as_a_whole(count: int) -> None:
    doc = laid_out(*lines(count), *step(2), *lines(5))
    assert not doc.parted and not isinstance(doc.heads.get(2), Formula)


@pytest.mark.parametrize("count", range(21, 36))
def test_a_table_of_a_step_is_parted_between_its_rows_rather_than_leave_a_foot_blank(count: int) -> None:
    sentence, table = numbered("1.", "A sentence.", "en"), DataTable(["a", "b"], [["1", "2"]] * 12, lang="en")
    sentence.keepWithNext = 1
    table.put_within(Tag(Role.BODY))
    doc = laid_out(*lines(count), sentence, table, *lines(5))
    assert doc.filled[0] >= 0.85 and isinstance(doc.heads[2], DataTable if doc.parted else Para)


def test_a_text_is_set_more_tightly_where_that_brings_a_figure_back_that_left_a_gap() -> None:
    story = [*lines(28), Drawing(80.0, 60.0, lambda *_: None), *lines(62)]
    plain = laid_out(*story)
    assert plain.gaps == 1 and isinstance(plain.heads[2], Drawing)
    assert not settled(story, META).gaps


def test_a_long_step_is_parted_behind_a_formula_where_it_would_leave_a_hole() -> None:
    doc = laid_out(*lines(20), *step(40), *lines(5))
    assert isinstance(doc.heads[2], Formula) and doc.filled[0] > 0.87  # whole bands of rows


def test_a_table_behind_its_heading_is_parted_where_it_would_leave_a_hole() -> None:
    table = DataTable(["a", "b"], [["1", "2"]] * 20, lang="en")
    doc = laid_out(*lines(20), Heading("Check", 3, "en"), table)
    assert isinstance(doc.heads[2], DataTable) and doc.filled[0] > 0.87  # whole bands of rows


@pytest.mark.parametrize("height", [215.0, 225.0, 240.0])
def test_what_has_no_room_is_put_off_again_where_a_figure_opens_the_next_page(height: float) -> None:
    """A table that was put off, and then found a figure before it, was called too large for any page."""
    table = Drawing(80.0, 60.0, lambda *_: None)
    doc = laid_out(*lines(31), Plate(80.0, height, lambda *_: None), table, *lines(3))
    assert doc.page == 3 and isinstance(doc.heads[2], Plate) and doc.heads[3] is not None
