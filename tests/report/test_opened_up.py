"""A text that leaves a good part of its pages empty is set more openly; one that fills them is left as it is."""

from __future__ import annotations

import pytest

from vecpoly.report.flow.blocks import Callout
from vecpoly.report.flow.doc import Metadata, ReportDoc
from vecpoly.report.flow.paging.loose import ENOUGH, loosened

META = Metadata(title="t", subject="t", keywords=(), lang="en")


def laid(story: list[Callout]) -> ReportDoc:
    doc = ReportDoc(story, META)
    doc.counted()
    return doc


def boxes(count: int) -> list[Callout]:
    return [Callout(f"{n}", "note", "en") for n in range(count)]


@pytest.mark.parametrize("count", [5, 12, 17, 24, 40])
def test_a_text_grows_on_its_pages_and_needs_none_more(count: int) -> None:
    story = boxes(count)
    before = laid(story)
    after = loosened(story, before)
    assert after.page == before.page
    grown = sum(after.filled) / sum(before.filled)
    assert grown > 1.02 if min(before.filled) < 0.8 else grown >= 1.0


def test_a_text_that_fills_its_pages_is_the_same_text() -> None:
    count = next(n for n in range(5, 60) if min(laid(boxes(n)).filled) >= ENOUGH)
    story = boxes(count)
    before = laid(story)
    assert loosened(story, before) is before


def test_what_it_was_made_of_is_left_as_it_is() -> None:
    story = boxes(5)
    white = [box.spaceBefore for box in story]
    opener = loosened(story, laid(story)).story
    assert [box.spaceBefore for box in story] == white
    assert all(new.spaceBefore > old for new, old in zip(opener, white, strict=True))
