"""The sketch beside a statement is drawn larger where its page would end early, and nothing else changes."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn
from vecpoly.board.paper.marks import Point
from vecpoly.report.document import PICTURE
from vecpoly.report.flow.blocks import Drawing
from vecpoly.report.flow.doc import Metadata, ReportDoc
from vecpoly.report.flow.paging.ample import ROOM, ample
from vecpoly.report.flow.para import Para
from vecpoly.report.picture import magnified
from vecpoly.report.question.sketch import sketched
from vecpoly.typeset.box import MM

META = Metadata(title="t", author="a", lang="en")


def _page(white: float) -> tuple[ReportDoc, Drawing]:
    """A page with a sketch 40 mm high, of which so much (mm) stays white."""

    def sketch(times: float) -> Drawing:
        made = Drawing(50.0 * times, 40.0 * times, lambda *_: None, sketch=True)
        made.ampler = sketch
        return made

    first = sketch(1.0)
    room = ReportDoc([first], META).column / MM - 40.0 - white - 10.0
    space = Drawing(10.0, room, lambda *_: None)
    doc = ReportDoc([first, space], META)
    doc.counted()
    return doc, first


@pytest.mark.parametrize(("white", "grows"), [(60.0, True), (8.0, False)])
def test_a_sketch_takes_the_white_of_its_page_if_that_is_much(white: float, grows: bool) -> None:
    doc, first = _page(white)
    assert (1 - doc.filled[0] >= ROOM) is grows
    found = ample(doc)
    (new, _) = found.story
    assert (found is not doc) is grows and (new.size[1] > 1.2 * first.size[1]) is grows
    assert found.page == doc.page and found.filled[0] >= doc.filled[0]


def test_a_page_without_a_sketch_of_its_own_is_left_as_it_is() -> None:
    doc = ReportDoc([Para("a", lang="en")], META)
    doc.counted()
    assert ample(doc) is doc


def test_a_sketch_that_is_drawn_larger_keeps_its_letters_and_spreads_its_points() -> None:
    solution = drawn("C-inertia").solution
    figure = sketched(solution.problem, solution.construction, *PICTURE)
    assert figure is not None
    larger = magnified(figure, 1.4)
    points, spread = ([m for m in one.marks if isinstance(m, Point)] for one in (figure, larger))
    assert [m.label for m in points] == [m.label for m in spread]
    assert all(abs(1.4 * one.at - two.at) < 1e-9 for one, two in zip(points, spread, strict=True))
