"""Claims about sheets in the text: their frames end where its lines do."""

from __future__ import annotations

import pytest

from tests.drawn_library import DRAFTED
from tests.drawn_sheets import laid
from tests.each import each
from vecpoly.drawing.sheets.sheet import Sheet
from vecpoly.drawing.sheets.space import PLATE, STRIP
from vecpoly.report.flow.furniture import COLUMN
from vecpoly.typeset.box import MM


def _plates(name: str) -> list[Sheet]:
    return [sheet for sheet in laid(name) if sheet.plate]


@each(DRAFTED)
def test_the_frame_of_a_sheet_in_the_text_is_as_wide_as_the_text(name: str) -> None:
    assert pytest.approx(COLUMN / MM) == PLATE
    for sheet in _plates(name):
        assert sheet.room[0] == PLATE, sheet.room
        assert sheet.size[1] > STRIP


@each(["8-6-2", "cognates"])
def test_what_is_narrower_stands_in_the_middle_of_its_frame(name: str) -> None:
    (sheet,) = _plates(name)
    (figure,) = (one for one in sheet.figures if one.count)
    assert figure.extents.centre.real == pytest.approx(sheet.size[0] / 2, abs=2.5)
