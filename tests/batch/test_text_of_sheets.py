"""The pages of text of a sheet that is photographed: squares under their heading, lines for answers in words."""

from __future__ import annotations

import pytest

from tests.drawn_library import DRAFTED, drawn
from tests.each import each
from vecpoly.batch.sheet.text import text_pages
from vecpoly.report.flow.blocks import Heading
from vecpoly.report.question.lined import Lined
from vecpoly.report.question.working import Squares


@each(DRAFTED)
def test_the_heading_over_the_squares_stands_on_their_page_and_ends_none(name: str) -> None:
    pages = text_pages(drawn(name).solution, "zh")
    for page in pages:
        assert not isinstance(page[-1].block, Heading), "a heading at the foot of a page"
    first = next(page for page in pages if any(isinstance(one.block, Squares) for one in page))
    assert isinstance(first[-2].block, Heading)


def test_the_heading_goes_overleaf_with_its_squares_where_the_page_is_all_but_full() -> None:
    text, work = text_pages(drawn("2-6").solution, "zh")
    assert isinstance(text[-1].block, Lined)
    assert [type(one.block) for one in work] == [Heading, Squares]


@pytest.mark.parametrize(("name", "answers"), [("8-1", 3), ("8-10", 1), ("3-9", 0)])
def test_what_is_answered_in_words_has_lines_on_a_sheet_of_a_class_too(name: str, answers: int) -> None:
    blocks = [one.block for page in text_pages(drawn(name).solution, "en") for one in page]
    assert [len(block.names) for block in blocks if isinstance(block, Lined)] == ([answers] if answers else [])
