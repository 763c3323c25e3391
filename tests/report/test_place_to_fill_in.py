"""Where the coordinates of a point are to be written."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn
from vecpoly.report.question.blanks import empty_table
from vecpoly.words import Lang


@pytest.mark.parametrize(("lang", "comma"), [("zh", "，"), ("en", ",")])
def test_the_coordinates_of_a_place_are_parted_as_in_the_language_of_the_sheet(lang: Lang, comma: str) -> None:
    rows = empty_table(drawn("4-4").solution, lang).rows
    places = [cell for row in rows for cell in row if cell.endswith(") mm")]
    assert len(places) == 2
    assert all(cell.replace("\u3000", "") == f"({comma}) mm" for cell in places)
