"""A step that a page break parts keeps its sentence with a display, its last display with the box of answers, and no
line alone; sheets and plates stand where the pages are full and no step is torn."""

from __future__ import annotations

from itertools import pairwise

import pytest

from vecpoly.algebra.formula import Row, Txt, sym
from vecpoly.report.answers.line import AnswerLine
from vecpoly.report.flow.base import Block
from vecpoly.report.flow.blocks import Drawing, Heading, Plate, SheetPage
from vecpoly.report.flow.doc import Metadata, ReportDoc
from vecpoly.report.flow.formula import Formula
from vecpoly.report.flow.furniture import COLUMN
from vecpoly.report.flow.paging.parting import ALONE, parted
from vecpoly.report.flow.paging.placing import advanced, placed
from vecpoly.report.flow.para import Para, numbered
from vecpoly.report.flow.results.box import AnswerBox

META = Metadata(title="t", lang="en")
ROOMS = range(10, 120, 3)


def high(blocks: list[Block]) -> float:
    return float(sum(one.wrap(COLUMN, 0.0)[1] for one in blocks))


def step(lines: int = 1, formulas: int = 4) -> list[Block]:
    return [
        numbered("1.", "word " * 14 * lines, "en"),
        *(Formula(Row((Txt("a = "), sym(f"b_{n}")))) for n in range(formulas)),
    ]


def box() -> AnswerBox:
    return AnswerBox([AnswerLine(key="v_B", node=sym("v_B"), before="point B")], (), "en")


@pytest.mark.parametrize("room", ROOMS)
@pytest.mark.parametrize("lines", [1, 2, 5])
def test_a_page_ends_behind_a_display_or_two_lines_of_a_sentence_and_none_opens_with_one_line(
    room: float, lines: int
) -> None:
    whole = step(lines)
    halves = parted(whole, COLUMN, room, 1.0)
    if halves is None or room >= high(whole):
        return
    here, overleaf = halves
    assert high(here) <= room and (len(overleaf) > 1 or high(overleaf) >= ALONE)
    if isinstance(here[-1], Para):
        assert len(here[-1].lines(COLUMN)) >= 2 and isinstance(overleaf[0], Para)
    assert len(here) + len(overleaf) == len(whole) + isinstance(here[-1], Para)


@pytest.mark.parametrize("room", ROOMS)
def test_no_box_of_answers_is_parted_from_the_display_before_it(room: float) -> None:
    halves = parted([*step(), box()], COLUMN, room, 1.0)
    assert halves is None or (len(halves[1]) > 1 and isinstance(halves[1][-1], AnswerBox))


@pytest.mark.parametrize("room", ROOMS)
def test_no_heading_ends_a_page_and_two_lines_stand_under_it(room: float) -> None:
    halves = parted([Heading("Check", 3, "en"), Para("word " * 120, None, "en")], COLUMN, room, 1.0)
    if halves is not None:
        (_, text), _ = halves
        assert isinstance(text, Para) and len(text.lines(COLUMN)) >= 2


def test_more_room_holds_no_less() -> None:
    found = [parted(step(5, 8), COLUMN, room, 1.0) for room in ROOMS]
    depths = [high(one[0]) for one in found if one is not None]
    assert depths and all(one <= other + 1e-9 for one, other in pairwise(depths))


def text(count: int) -> list[Para]:
    return [numbered(f"{n}.", "word", "en") for n in range(count)]


def sheet() -> SheetPage:
    return SheetPage(lambda *_: None, title="s")


def test_a_sheet_is_tried_behind_the_last_pages_only_and_before_what_begins_there() -> None:
    story = [Heading("Problem", 2, "en"), *text(150), sheet()]
    doc = ReportDoc(story, META)
    doc.counted()
    ways = [*placed(story, doc)]
    assert len(doc.filled) == 5 and all(sum(isinstance(one, SheetPage) for one in way) == 1 for way in ways)
    assert {one.behind for way in ways for one in way if isinstance(one, SheetPage)} == {0, 3, 4}
    early = [n for way in ways for n, one in enumerate(way) if isinstance(one, SheetPage) and not one.behind]
    assert min(early) > 36 * 2


def test_a_plate_is_met_earlier_but_behind_the_sketch_and_the_sheet_before_it() -> None:
    sketch, plate = Drawing(80.0, 30.0, lambda *_: None, sketch=True), Plate(80.0, 90.0, lambda *_: None)
    story = [*text(2), sketch, *text(3), plate]
    places = [way.index(plate) for way in advanced(story)]
    assert places == [5, 4, 3]
    assert [way.index(plate) for way in advanced([*text(2), sheet(), *text(3), plate])] == [5, 4, 3]
