"""What the strip of a sheet tells of the hand that drew it."""

from __future__ import annotations

from itertools import islice

import pytest

from tests.drawn_library import drafted, given, ids
from tests.drawn_sheets import laid
from tests.each import Later, each
from tests.laws import few
from vecpoly.board.acts.inkless import Measure
from vecpoly.devices.structure import Structure
from vecpoly.drawing.labels.notes import WIDE_SPACE, folded
from vecpoly.drawing.scene import TextBox
from vecpoly.drawing.sheets.boxes import titleblock
from vecpoly.drawing.sheets.space import STRIP
from vecpoly.drawing.style import NOTE
from vecpoly.problem.load import load
from vecpoly.typeset import Glyphs, layout_words
from vecpoly.words import Lang, label


def structures() -> list[str]:
    """Three exercises about structure, and one whose counting is not measured either."""
    some = islice((name for name in ids(mechanisms=False) if isinstance(given(name).subject, Structure)), 3)
    return [*some, "2-10"]


def printed(name: str) -> list[str]:
    """What each sheet says in its strip, without spaces."""
    boxes = [[one.box for one in sheet.furniture.items if isinstance(one, TextBox)] for sheet in laid(name)]
    said = ["".join(g.text for box in some for g in box.items if isinstance(g, Glyphs)) for some in boxes]
    return [text.replace(" ", "") for text in said]


@each(Later(structures))
def test_sheets_on_which_nothing_is_measured_do_not_say_how_finely_they_are_read(name: str) -> None:
    assert all("仪器绘图" in text and "0.1" not in text for text in printed(name))


@pytest.mark.parametrize("name", ["3-9", "8-1"])
def test_sheets_that_are_measured_say_how_finely(name: str) -> None:
    solution = drafted(name)
    assert solution is not None and any(isinstance(act, Measure) for act in solution.construction.acts)
    assert all("读至0.1" in text for text in printed(name))


ROOMS = (52.0, 74.0, 79.6)  # mm: cells of titles on plates and on an upright sheet


@pytest.mark.parametrize("room", few(ROOMS, 2))
@pytest.mark.parametrize("lang", ["zh", "en"])
def test_a_long_title_parts_no_word_and_fits_its_cell(lang: Lang, room: float) -> None:
    for name in ids(mechanisms=False):
        task = load(name)
        text = f"{label(name).of(lang)}{WIDE_SPACE}{task.title.of(lang)}".strip(WIDE_SPACE)
        assert titleblock._fitted(text, 1.2 * NOTE, room).width <= room
        first, *rest = folded(text, NOTE, room).split("\n")
        assert len(rest) <= 1
        if rest and lang == "en":
            assert text[len(first)] in f" {WIDE_SPACE}" and first.split()[-1] in text.split()


def test_a_title_of_two_lines_keeps_a_margin_and_parts_its_name_first() -> None:
    text = "图 6-1　题 8-9　摇杆与滑块的三组对应位置"
    assert folded(text, NOTE, 52.0) == "图 6-1　题 8-9\n摇杆与滑块的三组对应位置"
    assert folded("平面四杆机构和滑块的力分析", NOTE, 30.0) == "平面四杆机构\n和滑块的力分析"
    title, hand = titleblock._fitted(text, 1.2 * NOTE, 52.0), layout_words("作图：精确", NOTE)
    assert (1 - titleblock._lower(title, hand)) * STRIP - title.height > 2 * 1.2
