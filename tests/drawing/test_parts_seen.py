"""What stands alone on its sheet is as large as that allows, and no part drawn apart is too small to be seen."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn
from tests.drawn_sheets import laid, span
from tests.each import each
from vecpoly.board.construction import Figure
from vecpoly.board.paper.extent import extent, figured
from vecpoly.drawing.details.larger import may_be_larger
from vecpoly.drawing.sheets.readied import LEAST, SEEN, readied
from vecpoly.drawing.sheets.sheet import Sheet

APART = ("2-4", "2-5fix", "2-6", "2-6red", "2-7", "2-9", "2-10", "2-11", "2-12", "2-13")  # with a crank of 3 to 20 mm
ALONE = (("three-positions", 0.6), ("two-pairs", 0.6), ("8-11", 0.85), ("8-2d", 0.38), ("8-2e", 0.36))  # as they were:
# 0.48, 0.64 of a plate half as wide, 0.56, 0.29, 0.32


def _across(figure: Figure) -> float:
    return max(extent(figured(figure.marks)))


def _filled(sheet: Sheet) -> float:
    wide, high = span(sheet)
    return wide * high


@each(APART)
def test_a_part_of_a_sketched_mechanism_is_large_enough_to_be_seen(name: str) -> None:
    apart = [one for one in readied(drawn(name).solution.construction.figures) if may_be_larger(one)]
    assert apart and all(_across(one) >= SEEN - 1e-9 or _across(one) <= LEAST for one in apart)
    shown = [one.figure for sheet in laid(name) for one in sheet.figures if one.figure and may_be_larger(one.figure)]
    assert len(shown) == len(apart) and all(_across(one) >= SEEN - 1e-9 for one in shown)


def test_a_figure_that_has_a_scale_keeps_its_size() -> None:
    figures = drawn("8-2b").solution.construction.figures
    assert any(one.scale.symbol for one in figures)
    assert readied(figures) == figures


@pytest.mark.parametrize(("name", "share"), ALONE)
def test_a_figure_alone_is_as_large_as_its_sheet_allows(name: str, share: float) -> None:
    (sheet,) = laid(name)
    assert _filled(sheet) >= share


def test_letters_that_crowd_a_construction_have_a_sheet_more_on_which_they_find_room() -> None:
    made = laid("four-positions-b")
    assert len(made) == 2 and min(map(_filled, made)) > 0.7
