"""A page of text is not turned for a single box where a little less white would hold it."""

from __future__ import annotations

from collections.abc import Callable
from io import BytesIO

import pytest
from pypdf import PdfReader
from reportlab.platypus.flowables import PageBreak

import vecpoly
from tests.drawn_library import drawn
from tests.laws import few
from vecpoly.algebra.formula import sym
from vecpoly.report.answers.line import AnswerLine
from vecpoly.report.document import report_bytes
from vecpoly.report.flow.base import Block
from vecpoly.report.flow.blocks import SMALLEST, Callout, Drawing
from vecpoly.report.flow.doc import Metadata, ReportDoc
from vecpoly.report.flow.equation import EquationFlow
from vecpoly.report.flow.paging.setting import tightened
from vecpoly.report.flow.paging.tight import DEGREES, saved
from vecpoly.report.flow.results.box import AnswerBox
from vecpoly.report.flow.table import DataTable
from vecpoly.words import Lang


def story(count: int) -> list[Callout]:
    """So many boxes one after another."""
    return [Callout(f"{n}", "note", "en") for n in range(count)]


def pages(count: int) -> tuple[int, bool]:
    """How many pages so many boxes fill, and whether the last of them is a leftover."""
    doc = ReportDoc(story(count), Metadata(title="t", subject="t", keywords=(), lang="en"))
    return doc.made()[1], bool(doc.leftover)


def test_a_box_that_is_alone_on_its_page_is_told_and_fits_with_less_white() -> None:
    most = next(count for count in range(5, 99) if pages(count)[0] == 2)
    assert pages(most) == (2, True)
    assert pages(most - 1) == (1, False)
    doc = ReportDoc(tightened(story(most), DEGREES[1]), Metadata(title="t", subject="t", keywords=(), lang="en"))
    assert doc.made()[1] == 1


@pytest.mark.parametrize(
    ("name", "lang", "count"),
    few(
        [
            ("8-9", "zh", 2),
            ("8-12", "zh", 2),
            ("four-positions-b", "zh", 3),
            ("8-1", "en", 2),
            ("8-2a", "en", 2),
            ("cam-moves-arm", "en", 4),
        ],
        3,
    ),
)
def test_no_report_turns_a_page_for_its_last_table(name: str, lang: Lang, count: int) -> None:
    data = report_bytes([vecpoly.load(name).solve()], lang=lang)
    assert len(PdfReader(BytesIO(data)).pages) == count


META = Metadata(title="t", subject="t", keywords=(), lang="en")


def test_a_sketch_is_made_smaller_and_a_figure_of_true_size_is_not() -> None:
    for sketch in (True, False):
        figure = Drawing(60.0, 40.0, lambda canvas, x, y: None, sketch=sketch)
        (small,) = tightened([figure], DEGREES[-1])
        whole, less = figure.wrap(400.0, 600.0)[1], small.wrap(400.0, 600.0)[1]
        assert less == pytest.approx(whole * (SMALLEST if sketch else 1.0))


def test_only_the_part_that_saves_a_page_is_tightened_and_nothing_is_spoilt() -> None:
    most = next(count for count in range(5, 99) if pages(count)[0] == 2)
    boxes = [*story(most), PageBreak(), *story(3)]
    before = [box.spaceBefore for box in boxes if isinstance(box, Callout)]
    assert len(PdfReader(BytesIO(saved(boxes, META))).pages) == 2
    assert [box.spaceBefore for box in boxes if isinstance(box, Callout)] == before


def test_a_table_that_was_put_off_to_the_next_page_is_set_again() -> None:
    most = next(count for count in range(5, 99) if pages(count)[0] == 2)
    table = DataTable(("a",), [("1",)] * 3, lang="en")
    boxes = [*story(most - 2), table, *story(2)]
    for _ in range(2):
        assert len(PdfReader(BytesIO(saved(boxes, META))).pages) in (1, 2)


def test_the_rows_of_an_equation_keep_clear_of_the_line_below_however_tightly_they_are_set() -> None:
    table = next(step.equation for step in drawn("3-5").construction.steps if step.equation is not None)
    block = EquationFlow(table, "en")
    block.tighten(DEGREES[-1])
    assert block.spaceBefore < 3.0 and block.spaceAfter > 5.0


def test_what_is_set_more_tightly_after_it_was_laid_out_takes_the_room_of_what_was_so_from_the_start() -> None:
    rows = [("$v_B$", "of the pin of the crank, which turns evenly"), ("$v_C$", "0.49 m/s")] * 4
    asked = [AnswerLine(key=f"v_{letter}", node=sym(f"v_{letter}"), before=f"point {letter}") for letter in "BCDEF"]
    makers: tuple[Callable[[], Block], ...] = (
        lambda: DataTable(("a", "b"), rows, lang="en"),
        lambda: AnswerBox(asked, ("Said.",), "en"),
    )
    for made in makers:
        known = made()
        known.wrap(300.0, 900.0)
        (late,), (early,) = tightened([known], DEGREES[-1]), tightened([made()], DEGREES[-1])
        assert late.wrap(300.0, 900.0) == early.wrap(300.0, 900.0)
        assert late.height < known.height
