"""A course report speaks of a cycle where there is one, tells in which way a moment was found, defines what it uses,
and prints no number that rounding has left."""

from __future__ import annotations

import re

import pytest

from tests.laws import few
from tests.studies import course_text, course_words, studied
from vecpoly.report.content import Objects
from vecpoly.report.course.analysis.stated import stated
from vecpoly.report.course.checks.chapter import _checked, chapter
from vecpoly.report.course.numbering import Press
from vecpoly.report.flow.blocks import Heading, Subheading
from vecpoly.report.flow.table import DataTable
from vecpoly.report.flow.xml import to_flowables
from vecpoly.words import Lang

_TONGUES: tuple[Lang, ...] = ("en", "zh")
_FIRST = few(_TONGUES, 2)


@pytest.mark.parametrize("lang", _FIRST)
def test_a_stroke_is_called_a_working_range_and_no_cycle(lang: Lang) -> None:
    """The cylinder of the tipper goes from end to end."""
    text, _ = course_words("tipper", lang)
    assert not re.search("循环" if lang == "zh" else r"\bcycle\b", text)
    assert ("工作范围" if lang == "zh" else "working range") in text


def test_of_a_whole_turn_the_cycle_is_told() -> None:
    text, _ = course_text("3-9", "zh")
    assert "一个运动循环内的位置、速度和加速度" in text and "工作范围" not in text


@pytest.mark.parametrize("lang", _TONGUES)
def test_heads_within_a_section_stand_at_the_margin_and_keep_with_what_follows(lang: Lang) -> None:
    text, objects = course_text("3-9", lang)
    heads = [one for one in to_flowables(text, objects.named, lang) if isinstance(one, Subheading)]
    assert heads and all(one.style.first == 0 and one.keepWithNext and not hasattr(one, "outline") for one in heads)
    assert not any(isinstance(one, Heading) for one in heads)


@pytest.mark.parametrize("lang", _TONGUES)
def test_a_moment_that_is_found_in_several_ways_is_told_with_its_way(lang: Lang) -> None:
    (said,) = stated(studied("slider-crank-dynamic"))
    ways = ("虚功率法", "速度多边形杠杆法") if lang == "zh" else ("virtual power", "Zhukovsky lever")
    assert all(said.of(lang).count(way) == 1 for way in ways)


@pytest.mark.parametrize("lang", _FIRST)
def test_an_energy_that_is_nothing_is_told_as_nothing_and_a_turn_begins_at_nought(lang: Lang) -> None:
    text, _ = course_words("slider-crank-dynamic", lang)
    assert "= 360 − 0 = 360 J" in text and not re.search(r"10⁻\S+ (?:J|N|W)", text)
    assert not re.search(r"360\.00°[～–]", text)


def listed(name: str, lang: Lang) -> list[str]:
    """The symbols of the list at the head of a report."""
    return symbols_of(course_words(name, lang))


def symbols_of(report: tuple[str, Objects]) -> list[str]:
    _, objects = report
    (table,) = (
        one for one in objects.named.values() if isinstance(one, DataTable) and one.caption in ("主要符号", "Symbols")
    )
    return [cell for row in table.rows for cell in (row[0], row[4])]


def test_a_point_called_E_is_no_energy() -> None:
    assert "$E$" not in symbols_of(course_text("3-9", "en")) and "$E$" in listed("slider-crank-dynamic", "en")


@pytest.mark.parametrize("lang", _FIRST)
def test_the_radius_in_the_shaking_moment_is_defined(lang: Lang) -> None:
    text, _ = course_words("slider-crank-dynamic", lang)
    assert ("矢径" if lang == "zh" else "position vector") in text and "$r_{Si}$" in listed(
        "slider-crank-dynamic", lang
    )


def test_reactions_at_both_ends_of_a_two_force_link_are_told_once() -> None:
    it = studied("4-3a")
    sizes = [tuple(abs(it.turn.real(key)[::40])) for key in it.forces if key.startswith("R_")]
    assert len(sizes) == len(set(sizes)) > 1


def test_a_shaking_force_that_is_least_at_two_positions_is_told_with_both() -> None:
    _, objects = course_words("slider-crank-dynamic", "en")
    tables = [one for one in objects.named.values() if isinstance(one, DataTable)]
    (row,) = (row for one in tables for row in one.rows if row[0] == "$|F_I|$ /N")
    assert re.fullmatch(r"[\d.]+° and [\d.]+°", row[4]) and row[2] == "0°"


def test_the_check_of_the_model_leaves_out_what_is_nothing_across_a_guide() -> None:
    """The pin of a slider has no acceleration across its guide: what rounding leaves of it was compared, 147 % off."""
    rows = {one.symbol: one for one in _checked(studied("slider-crank-dynamic"))}
    assert "a_{Cx}" in rows and "a_{Cy}" not in rows
    assert all(3.5 < one.wide / one.narrow < 4.5 for one in rows.values() if one.wide and one.narrow)


@pytest.mark.parametrize("lang", few(["zh", "en"], 2))
def test_the_check_of_the_model_is_a_sentence_with_the_largest_of_each(lang: Lang) -> None:
    it, kept = studied("A-26"), Press(lang, Objects(), "7")
    told, rows = chapter(it, kept), _checked(it)
    worst = max(rows, key=lambda one: one.wide or 0.0)
    assert not told["table"] and worst.wide is not None and worst.narrow is not None
    assert f"${worst.symbol}$" in told["told"]
    for share in (worst.wide, worst.narrow):
        assert f"{100 * share:.4f} %" in told["told"]
