"""Sheets are planned before letters have their places: what is expected of figures with details is what comes."""

from __future__ import annotations

import pytest

from benchmarks.chain import chain
from tests.drawn_library import drawn
from tests.laws import few
from vecpoly.drawing.figure import drawing, drawn_anew
from vecpoly.drawing.sheets.detailing import drawn as figures_drawn
from vecpoly.drawing.sheets.expected import Expected
from vecpoly.drawing.sheets.paging import reading_order
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.foundation.stock import ANY_A4
from vecpoly.solution import solve

DETAILED = ("A-30", "3-12", "C-inertia")
LETTERS = 12.0  # mm that they may reach farther out, or less far, on one side or both


@pytest.mark.parametrize("name", few(DETAILED, 2))
def test_a_figure_takes_about_as_much_room_with_its_letters_as_was_expected(name: str) -> None:
    figures = reading_order(drawn(name).solution.construction.figures)
    expected = Expected.unlettered(figures, "zh", ANY_A4).mains
    for before, after in zip(expected, figures_drawn(figures, "zh"), strict=True):
        assert after.size == pytest.approx(before.size, abs=LETTERS)


@pytest.mark.parametrize("name", few(DETAILED, 2))
def test_what_overflows_a_sheet_before_it_is_lettered_overflows_it_afterwards(name: str) -> None:
    expected = Expected.unlettered(reading_order(drawn(name).solution.construction.figures), "zh", ANY_A4)
    pages = expected.lettered()
    assert expected.fits(1) or pages is None or len(pages) > 1


def test_a_crowded_figure_is_lettered_once_with_as_many_details_as_its_sheet_will_hold() -> None:
    construction = solve(chain(15), repeats=0, precise=False).construction
    drawn_anew()
    shown = [one.name for sheet in sheets(construction) for one in sheet.figures]
    assert sum("detail" in name for name in shown) == 3
    assert drawing.cache_info().misses <= len(shown) + 1, "one detail was drawn in vain"
