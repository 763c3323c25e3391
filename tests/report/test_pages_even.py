"""No page of a report is left half empty where its text, set a little otherwise, would fill it."""

from __future__ import annotations

import pytest

from tests.drawn_library import drafted
from tests.laws import few
from tests.report.test_pages_filled import FULL, LAST, META, laid_out, text
from vecpoly.report.flow.blocks import SheetPage
from vecpoly.report.flow.doc import ReportDoc
from vecpoly.report.flow.paging.balanced import balanced, emptiness
from vecpoly.words import Lang

LEFT_OVER = ("2-4", "2-10", "8-2b", "8-10", "2-11", "2-12", "D-2")  # texts that ended on a page of little
HALF_EMPTY = ("7-6", "3-4a-straight", "shaper-flywheel", "dump-hoist", "8-6", "tipper", "C-conveyor")  # as they were


@pytest.mark.parametrize("name", few(HALF_EMPTY, 2))
@pytest.mark.parametrize("lang", few(["zh", "en"], 2))
def test_every_page_of_a_report_but_the_last_is_nearly_full(name: str, lang: Lang) -> None:
    solution = drafted(name)  # as it is printed: an exact hand has no deviations to check
    assert solution is not None
    doc = laid_out([solution], lang)
    *others, last = doc.filled
    assert min(others) >= FULL and last >= LAST and not doc.widows


@pytest.mark.parametrize("name", few(LEFT_OVER, 3))
def test_no_page_is_left_to_a_few_lines_behind_a_plate(name: str) -> None:
    solution = drafted(name)
    assert solution is not None
    doc = laid_out([solution], "zh")
    *others, last = doc.filled
    assert min(others) >= FULL and last >= LAST and not doc.widows


def test_a_text_of_little_more_than_a_page_is_spread_over_two() -> None:
    story = text(44)
    plain = ReportDoc(story, META)
    plain.counted()
    assert len(plain.filled) == 2 and emptiness(plain.filled)
    doc = balanced(plain, story)
    assert doc.page == 2 and emptiness(doc.filled) < emptiness(plain.filled)


def test_a_text_that_fills_its_pages_is_left_as_it_is() -> None:
    sheet = SheetPage(lambda canvas, x, y: None, title="s")
    story = [*text(72), sheet]
    doc = ReportDoc(story, META)
    doc.counted()
    assert balanced(doc, story) is doc


def test_a_sheet_before_the_text_stays_before_it() -> None:
    sheet = SheetPage(lambda canvas, x, y: None, title="s")
    story = [sheet, *text(44)]
    doc = ReportDoc(story, META)
    doc.counted()
    found = balanced(doc, story).story
    assert isinstance(found[0], SheetPage) and len(found) == len(story)
