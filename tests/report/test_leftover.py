"""A page of text is not turned for a single box where a little less white would hold it."""

from __future__ import annotations

from io import BytesIO

import pytest
from pypdf import PdfReader

import vecpoly
from vecpoly.report.document import report_bytes
from vecpoly.report.flow.blocks import Callout
from vecpoly.report.flow.contents import tightened
from vecpoly.report.flow.doc import Metadata, ReportDoc


def story(count: int) -> list[Callout]:
    """So many boxes one after another."""
    return [Callout(f"{n}", "note", "en") for n in range(count)]


def pages(count: int) -> tuple[int, bool]:
    """How many pages so many boxes fill, and whether the last of them is a leftover."""
    doc = ReportDoc(story(count), Metadata(title="t", subject="t", keywords=(), lang="en"))
    return doc.made()[1], doc.leftover


def test_a_box_that_is_alone_on_its_page_is_told_and_fits_with_less_white() -> None:
    most = next(count for count in range(5, 99) if pages(count)[0] == 2)
    assert pages(most) == (2, True)
    assert pages(most - 1) == (1, False)
    doc = ReportDoc(tightened(story(most)), Metadata(title="t", subject="t", keywords=(), lang="en"))
    assert doc.made()[1] == 1


@pytest.mark.parametrize(("name", "count"), [("8-9", 2), ("8-12", 2), ("four-positions", 3)])
def test_reports_of_chapter_8_end_with_no_lonely_box(name: str, count: int) -> None:
    data = report_bytes([vecpoly.load(name).solve()], lang="zh")
    assert len(PdfReader(BytesIO(data)).pages) == count
