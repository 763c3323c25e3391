"""Tables and the list of symbols of a course report: vectors in black, symbols that the words use."""

from __future__ import annotations

import pytest

from tests.studies import course_text, solved, studied
from vecpoly.board.paper.tones import whose
from vecpoly.drawing.hues import ink_of
from vecpoly.figures.hue import Hue
from vecpoly.report.answers.tables import readings_at
from vecpoly.report.course.results.drawings import chosen
from vecpoly.report.course.spoken_symbols import used, words_in
from vecpoly.report.flow.table import DataTable
from vecpoly.report.flow.text.breaks import Line
from vecpoly.report.tables import inks_of
from vecpoly.words import Lang


def tables(name: str, lang: Lang) -> list[DataTable]:
    return [one for one in course_text(name, lang)[1].named.values() if isinstance(one, DataTable)]


def test_what_is_read_stands_in_black_in_tables_behind_the_position() -> None:
    it = solved("3-9")
    (table,) = readings_at([("45°", it, it.answers.values())], "$φ_1$", "en")
    assert table.header[1] == "Quantity"
    coloured = [item for row in table.set_in(480.0).body for cell in row for line in cell for item in _coloured(line)]
    assert not coloured and any(inks_of(it, it.answers)), "vectors have inks in equations and figures"


def _coloured(line: Line) -> list[object]:
    return [item for cell in line.cells for item in cell.box.items if getattr(item, "rgb", None) is not None]


def test_directions_stand_under_each_other_by_their_points() -> None:
    (table,) = (one for one in tables("3-9", "en") if "6-2" in one.caption)
    assert table.align[table.header.index("Direction")] == "d"


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_the_list_of_symbols_has_those_of_the_words(lang: Lang) -> None:
    (listed,) = (one for one in tables("3-9", lang) if one.caption in ("主要符号", "Symbols"))
    symbols = {cell for row in listed.rows for cell in (row[0], row[4])}
    assert {"$K$", "$θ$", "$F$"} <= symbols and any("p_L" in one for one in symbols)
    assert not {"$J_e$", "$δ$", "$J_F$"} & symbols  # 3-9 is no machine


def test_a_symbol_is_listed_where_a_table_or_a_sentence_has_it_and_only_there() -> None:
    table = DataTable(["$J_F$ /(kg·m²)"], [["1"]], lang="en", caption="")
    assert [row[0] for row in used(words_in({"a": ["x $δ$ y"], "t": table}), loaded=True)] == ["$δ$", "$J_F$"]
    assert not [*used(words_in([1, None, "delta"]), loaded=True)]


@pytest.mark.parametrize(("name", "key", "drawn"), [("3-12", "v_D", "v_D4"), ("excavator-boom", "a_C", "a_C3")])
def test_a_point_under_the_number_of_a_link_has_the_ink_of_that_vector_in_the_tables(
    name: str, key: str, drawn: str
) -> None:
    it = solved(name)
    (ink,) = inks_of(it, [key])
    assert ink == ink_of(drawn, it.construction.tones).value != Hue.BLACK.value


def test_what_one_mass_of_a_rotor_gives_has_one_ink() -> None:
    """Its W, the parts of that in the planes, and its couple; the correction in another plane is another vector."""
    assert whose("W_1") == whose("W_1I") == whose("W_1II") == whose("C_1") != whose("W_2")
    assert whose("W_bI") == whose("C_bI") != whose("W_bII") and whose("W_S") == "W_S"
    tones = solved("6-4").construction.tones
    assert len({ink_of(key, tones) for key in ("W_1", "W_1I", "C_1")}) == 1


def test_a_vector_has_the_ink_of_the_given_position_at_all_others() -> None:
    it = studied("press-flywheel")
    tones = [one.solution.construction.tones for one in chosen(it, "en")]
    assert len(tones) > 2 and all(dict(tones[0]).items() <= dict(other).items() for other in tones)
