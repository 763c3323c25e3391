"""Pages of text that are nearly full end at their foot; what stands on which page stays the same."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from reportlab.platypus import Flowable

from tests.drawn_library import drawn
from tests.laws import few
from tests.studies import in_small
from vecpoly.report.document import markup
from vecpoly.report.flow.base import Block
from vecpoly.report.flow.doc import Metadata, ReportDoc
from vecpoly.report.flow.furniture import TextFrame
from vecpoly.report.flow.paging.justified import NEARLY, OPENEST, stretches
from vecpoly.report.flow.paging.tight import settled
from vecpoly.report.flow.paging.together import first_of
from vecpoly.report.flow.xml import to_flowables
from vecpoly.words import Lang

META = Metadata(title="t", subject="t", keywords=(), lang="zh")
HEIGHT = 700.0
ROW = 0.02  # of a page: a row of a table may go over to the page that is not opened


def counted(name: str, lang: Lang, style: str) -> ReportDoc:
    with in_small():
        document, objects = markup([drawn(name).solution], lang, style, {}, None, None)
    return settled(to_flowables(document, objects.named, lang), META)


@pytest.mark.parametrize(
    ("name", "lang", "style"),
    [
        *((name, "zh", "solution") for name in few(("8-17", "3-12", "two-trains-one-sun", "7-6", "four-positions"), 5)),
        *((name, "en", "solution") for name in few(("3-6", "D-3", "C-conveyor"), 3)),
        ("D-3-knife", "zh", "course"),
        ("3-5", "zh", "question"),
    ],
)
def test_pages_nearly_full_end_lower_and_hold_what_they_held(name: str, lang: Lang, style: str) -> None:
    doc = counted(name, lang, style)
    before, heads, pages = list(doc.filled), [type(first_of(one)) for one in doc.heads.values()], doc.page
    doc.justify()
    doc.drawn()
    assert doc.page == pages and [type(first_of(one)) for one in doc.heads.values()] == heads
    for was, now in zip(before, doc.filled, strict=True):
        assert now <= max(was, 1.0) + 1e-9
        assert now > was - 1e-9 if was >= NEARLY else now == pytest.approx(was, abs=ROW)


@pytest.mark.parametrize("name", ["8-6", "two-trains-one-sun"])
def test_a_page_that_ends_above_white_is_opened_to_its_foot(name: str) -> None:
    doc = counted(name, "zh", "solution")
    (at, *_) = (n for n, full in enumerate(doc.filled) if NEARLY < full < 0.95)
    doc.justify()
    doc.drawn()
    assert doc.filled[at] > 0.96 or doc.stretched[at] == OPENEST


@pytest.mark.parametrize("stretch", [1.0, OPENEST])
def test_what_of_a_table_finds_room_on_an_opened_page_is_counted_under_its_opened_white(stretch: float) -> None:
    """Else its first part is too high for the page, and the document cannot be set."""
    rooms: list[float] = []

    class Parted(Block):
        def split(self, width: float, height: float) -> list[Flowable]:
            rooms.append(height)
            return []

    frame, block = TextFrame(0, 0, 400, HEIGHT), Parted()
    frame.stretch, frame._atTop, block.spaceBefore = stretch, 0, 6.0
    frame.split(block, None)
    assert rooms == [pytest.approx(frame._y - frame._y1p - stretch * 6.0)]


@given(st.floats(0.0, 1.0), st.floats(0.0, 500.0))
def test_the_white_of_a_page_never_grows_beyond_it(full: float, white: float) -> None:
    (stretch,) = stretches([full], [white], HEIGHT)
    assert 1.0 <= stretch <= OPENEST and full + (stretch - 1) * white / HEIGHT <= 1.0 + 1e-12
