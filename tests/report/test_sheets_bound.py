"""Sheets stand behind the text to which they belong, also in a report with a cover and a table of contents."""

from __future__ import annotations

import re
from io import BytesIO
from typing import Any

import pytest
from pypdf import PdfReader

from tests.laws import few
from tests.studies import course_report
from vecpoly.report.flow.blocks import Heading, SheetPage
from vecpoly.report.flow.contents import Contents
from vecpoly.report.flow.cover import Cover
from vecpoly.report.flow.doc import Metadata, ReportDoc
from vecpoly.report.flow.paging.running import FULL, run_on
from vecpoly.report.flow.paging.sectioned import HALF
from vecpoly.report.flow.paging.tight import settled
from vecpoly.report.flow.paging.together import led
from vecpoly.report.flow.para import Para
from vecpoly.report.flow.table import DataTable
from vecpoly.words import Lang

META = Metadata(title="t", lang="en")


def chapter(number: int, paragraphs: int) -> list[Heading | Para]:
    return [Heading(f"{number} Chapter", 2, "en"), *(Para("word " * 90, None, "en") for _ in range(paragraphs))]


def test_a_sheet_behind_a_full_page_stays_where_it_is_whatever_a_cover_and_contents_take() -> None:
    cover = Cover("kind", "title", "", (), None)
    story = [cover, *chapter(1, 17), *lines(1), SheetPage(lambda *_: None, title="Sheet"), *chapter(2, 2)]
    doc = ReportDoc(story, META)
    doc.counted()
    assert len(doc.ends) == 2 and doc.ends[0][1] > FULL > doc.ends[1][1]
    found, _ = run_on(story, doc)
    assert [type(one) for one in found] == [type(one) for one in story]
    assert not any(getattr(one, "behind", 0) for one in found)


def lines(count: int) -> list[Para]:
    """So many paragraphs of one line; 36 of them fill a page."""
    return [Para(f"{n}", lang="en") for n in range(count)]


def settled_doc(*story: object) -> ReportDoc:
    """The story with a sheet behind it, settled on its pages."""
    return settled([*story, SheetPage(lambda *_: None, title="Sheet")], META)


def head(text: str) -> Heading:
    return Heading(text, 3, "en")


def test_a_sheet_stands_before_a_heading_rather_than_in_the_midst_of_a_section() -> None:
    doc = settled_doc(*lines(31), head("Acceleration"), *lines(25))
    assert [type(doc.heads[page]) for page in (1, 2, 3)] == [Para, SheetPage, Heading]
    assert doc.page == 3 and min(doc.filled) >= HALF


def test_a_table_is_not_torn_by_a_sheet_that_may_stand_before_its_heading() -> None:
    table = DataTable(["a", "b"], [["1", "2"]] * 26, None, "cc", lang="en")
    doc = settled_doc(*lines(31), head("Check"), Para("The values:", None, "en"), table)
    assert isinstance(doc.heads[2], SheetPage) and isinstance(doc.heads[3], Heading) and doc.page == 3


def test_a_page_of_little_does_not_stand_alone_behind_a_sheet() -> None:
    doc = settled_doc(*lines(20), head("Forces"), *lines(14), head("Check"), *lines(15))
    assert doc.page == 3 and min(doc.filled) >= HALF


def test_a_sheet_is_no_reason_to_leave_a_page_mostly_white_or_to_take_another() -> None:
    early = settled_doc(*lines(10), head("Forces"), *lines(44))
    assert early.page == 3 and early.filled[0] > 0.9
    long = settled_doc(*lines(24), head("Forces"), *lines(37))
    assert long.page == 3 and min(long.filled) > 0.85


def test_of_several_parts_one_has_its_sheet_before_a_page_that_opens_with_a_section_not_with_a_piece_of_a_table() -> (
    None
):
    table = DataTable(["a", "b"], [["1", "2"]] * 36, None, "cc", lang="en")
    sheet = SheetPage(lambda *_: None, title="Sheet")
    story = [*lines(35), head("Check"), *lines(20), table, sheet, *lines(60)]
    doc = ReportDoc(story, META)
    doc.counted()
    assert [type(doc.heads[page]) for page in (1, 2, 3)] == [Para, Heading, DataTable]
    found, after = run_on(story, doc)
    assert [item.behind for item in found if isinstance(item, SheetPage)] == [1]
    assert isinstance(after.heads[2], SheetPage) and isinstance(after.heads[3], Heading)


def test_contents_take_the_room_of_their_entries_when_pages_are_only_counted() -> None:
    heads = [item for n in range(60) for item in chapter(n, 1)]
    pages = ReportDoc([Contents("en"), *heads], META).counted()
    assert pages > ReportDoc(heads, META).counted()
    assert pages == ReportDoc([Contents("en"), *heads], META).made()[1]


@pytest.mark.parametrize("lang", few(["zh", "en"], 2))
def test_the_sheets_of_a_course_report_stand_behind_the_page_on_which_chapter_six_ends(lang: Lang) -> None:
    reader = PdfReader(BytesIO(course_report("3-9", lang)))
    page = {str(one.title): reader.get_destination_page_number(one) for one in _flat(reader.outline)}
    drawn = [at for title, at in page.items() if re.match("(Figure|图) 6-", title)]
    last, seven = (next(at for title, at in page.items() if re.match(f"{n}[ \u3000]", title)) for n in ("6.3", "7"))
    assert len(drawn) == 4 and drawn == [*range(drawn[0], drawn[0] + 4)]
    assert last < drawn[0] and seven in (drawn[0] - 1, drawn[-1] + 1)  # which it may share with the next chapter


def test_the_contents_name_the_pages_also_where_a_sheet_floats() -> None:
    sheet = SheetPage(lambda *_: None, title="Sheet")
    sheet.behind = 2
    heads = [item for n in range(1, 5) for item in chapter(n, 9)]
    reader = PdfReader(BytesIO(ReportDoc([Contents("en"), sheet, *heads], META).made()[0]))
    texts = [page.extract_text() for page in reader.pages]
    listed = dict(re.findall(r"(\d Chapter)[ .·]*\n?(\d+)", texts[0]))
    outline = {str(one.title): reader.get_destination_page_number(one) + 1 for one in _flat(reader.outline)}
    assert outline["Sheet"] == 3 and {name: str(at) for name, at in outline.items() if name != "Sheet"} == listed
    assert all(name in texts[at - 1] for name, at in outline.items() if name != "Sheet")


def _flat(outline: list[Any]) -> list[Any]:
    return [one for item in outline for one in (_flat(item) if isinstance(item, list) else [item])]


def test_the_only_line_under_a_heading_goes_with_it_to_the_page_of_its_table() -> None:
    table = DataTable(["a", "b"], [["1", "2"]] * 5, None, "cc", lang="en")
    for filling in few(range(20, 60), 2):
        lines = [Para("word", None, "en") for _ in range(filling)]
        story = [*lines, Heading("5 Results", 2, "en"), Para("The values:", None, "en"), table]
        doc = ReportDoc(story, META)
        data = PdfReader(BytesIO(doc.made()[0]))
        pages = [page.extract_text() for page in data.pages]
        at = [n for n, text in enumerate(pages) if "5 Results" in text or "The values" in text]
        assert len(at) == 1 and "2" in pages[at[0]].partition("The values:")[2], filling


def test_a_longer_paragraph_under_a_heading_is_parted_as_before() -> None:
    story = led([Heading("5 Results", 2, "en"), Para("word " * 60, None, "en"), Para("x", None, "en")])
    assert [one.keepWithNext for one in story] == [1, 0, 0]
