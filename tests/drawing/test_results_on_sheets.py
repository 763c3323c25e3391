"""A sheet says what came out of it where it has room, and a red box over it hides nothing."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from tests.drawn_library import IDS, drafted
from tests.each import each
from vecpoly.algebra.formula import plain
from vecpoly.drawing.scene import Rect, Stroke, TextBox, rect_of
from vecpoly.drawing.sheets.results import CLEAR
from vecpoly.drawing.sheets.sheet import Sheet, sheets
from vecpoly.drawing.sheets.space import FRAME, STRIP
from vecpoly.drawing.style import NOTE
from vecpoly.report.answers.line import short_line
from vecpoly.report.answers.rounded import drawn_number
from vecpoly.report.plates.results import concluded
from vecpoly.solution import YES_NO
from vecpoly.typeset import Glyphs
from vecpoly.typeset.box import MM
from vecpoly.words import Words

SUSPECT = Words("存疑：与独立求得的结果不符", "Suspect: disagrees with the independent result")


@cache
def _laid(name: str, *, plates: bool = True, warned: bool = False) -> tuple[Sheet, ...]:
    solution = drafted(name)
    if solution is None:
        return ()
    construction = solution.construction
    shown = replace(construction, warning=SUSPECT) if warned else construction
    made = sheets(shown, lang="zh", on=solution.problem.paper, plates=plates)
    return concluded(made, solution, "zh")


def _block(sheet: Sheet) -> Rect:
    frame = next(item for item in sheet.results if isinstance(item, Stroke))
    return rect_of(frame)


@each(IDS)
def test_results_on_a_sheet_stand_on_nothing_and_within_its_frame(name: str) -> None:
    for sheet in _laid(name):
        if not sheet.results:
            continue
        block = _block(sheet)
        assert block.x0 > FRAME and block.x1 < sheet.size[0] - FRAME
        assert block.y0 > FRAME + STRIP and block.y1 < sheet.size[1] - FRAME
        assert all(not one.extents.overlaps(block) or _apart(sheet, block) for one in sheet.figures)
        assert all(rect_of(item).grown(-0.2).overlaps(block) for item in sheet.results)
        sizes = {
            g.size
            for item in sheet.results
            if isinstance(item, TextBox)
            for g in item.box.items
            if isinstance(g, Glyphs)
        }
        assert max(sizes) <= NOTE * MM + 1e-6


def _apart(sheet: Sheet, block: Rect) -> bool:
    """Whether no type and no end of a line stands in the block."""
    inside = block.grown(CLEAR - 0.1)
    texts = [item.rect for item in sheet.drawn if isinstance(item, TextBox)]
    ends = [z for item in sheet.drawn if not isinstance(item, TextBox) for z in item.points]
    return not any(one.overlaps(inside) for one in texts) and not any(
        inside.x0 < z.real < inside.x1 and inside.y0 < z.imag < inside.y1 for z in ends
    )


@each(IDS)
def test_a_line_on_a_sheet_ends_with_the_number_of_the_answer(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    for answer in solution.answers.values():
        if answer.is_place or answer.undefined or answer.reading.unit == YES_NO:
            continue
        assert drawn_number(answer) in plain(short_line(answer, solution, "en")), answer.key


def test_most_problems_that_are_drawn_say_on_a_sheet_what_came_out() -> None:
    made = [sheets_ for name in IDS if (sheets_ := _laid(name))]
    assert len(made) > 200 and sum(any(one.results for one in some) for some in made) > 0.6 * len(made)


@pytest.mark.parametrize("name", ["3-2", "3-7b", "4-7", "six-bar-dynamic", "scissor-lift", "geared-five-bar"])
@pytest.mark.parametrize("plates", [True, False])
def test_the_red_box_over_a_full_page_lies_over_no_figure(name: str, plates: bool) -> None:
    for sheet in _laid(name, plates=plates, warned=True):
        over = [one for item in sheet.alarm.items if (one := rect_of(item)).height < 20.0]
        assert over and not any(one.overlaps(figure.extents) for one in over for figure in sheet.figures)
