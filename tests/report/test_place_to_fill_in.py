"""Where the coordinates of a point are to be written."""

from __future__ import annotations

import pytest

from tests.drawn_library import IDS, drawn, given
from tests.each import each
from vecpoly.report.question.blanks import empty_table
from vecpoly.words import Lang

BRACES = str.maketrans("", "", "{}")


@pytest.mark.parametrize(("lang", "comma"), [("zh", "，"), ("en", ",")])
def test_the_coordinates_of_a_place_are_parted_as_in_the_language_of_the_sheet(lang: Lang, comma: str) -> None:
    rows = empty_table(drawn("4-4").solution, lang).rows
    places = [cell for row in rows for cell in row if cell.endswith(") mm")]
    assert len(places) == 2
    assert all(cell.replace("\u3000", "") == f"({comma}) mm" for cell in places)


@each(IDS)
def test_no_datum_is_an_intermediate_result_and_no_mean_or_extreme_speed_has_a_sense(name: str) -> None:
    table = empty_table(drawn(name).solution, "en")
    told = {symbol.translate(BRACES) for symbol in (datum.symbol for datum in given(name).given.data)}
    ways = [n for n, head in enumerate(table.header) if head.startswith("Direction")]
    between = [row for row in table.rows if any(row)]
    if between and between[0][0] == "**Intermediate results**":
        end = next(n for n, row in enumerate(between[1:], 1) if row[0].startswith("**"))
        assert not told & {row[0].strip("$").translate(BRACES) for row in between[1:end]}
    for row in table.rows:
        if row[0].strip("$").translate(BRACES) in ("ω_m", "ω_max", "ω_min"):
            assert all(row[n] == "—" for n in ways), row


def test_the_sheet_of_a_flywheel_asks_for_no_sense() -> None:
    assert not any("Direction" in head for head in empty_table(drawn("7-5").solution, "en").header)
