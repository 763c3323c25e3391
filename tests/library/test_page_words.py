"""The pages of a report are each in one language, and say the same in both."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path

import pytest

from tests.foreign_words import CHINESE, ENGLISH, SYMBOL, foreign
from tests.laws import few
from tests.studies import course_text, solved
from vecpoly.check.table.whole import TableCheck, check_table
from vecpoly.problem.library import library
from vecpoly.report import printed_tables
from vecpoly.report.content import Objects
from vecpoly.report.document import markup
from vecpoly.report.flow.blocks import Drawing
from vecpoly.report.flow.table import DataTable
from vecpoly.words import Lang, Words

DIGITS = "0123456789"


@cache
def checked(name: str, file: Path) -> TableCheck:
    return check_table(solved(name).problem, file)


@cache
def marked_up(name: str, lang: Lang, style: str) -> tuple[str, Objects]:
    """The tables of a report in both languages are checked once."""
    if style == "course":
        return course_text(name, lang)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(printed_tables, "check_table", lambda problem, file: checked(problem.id, file))
        return markup([solved(name)], lang, style, {}, None, None)


def printed(name: str, lang: Lang, style: str) -> str:
    """The running text of a report, without symbols, formulas and drawings."""
    text, objects = marked_up(name, lang, style)
    tables = [table for table in objects.named.values() if isinstance(table, DataTable)]
    cells = [cell for table in tables for row in (table.header, *table.rows) for cell in row if isinstance(cell, str)]
    whole = " ".join([re.sub(r"<[^>]*>", " ", text), *cells, *(table.caption for table in tables)])
    for column in columns_of(name):
        whole = whole.replace(column, " ")
    return whole


def columns_of(name: str) -> list[str]:
    """How the printed tables of a problem name their columns: in whatever language they were printed."""
    texts = [table.read_text(encoding="utf-8") for table in solved(name).problem.tables if isinstance(table, Path)]
    heads = [next(line for line in text.splitlines() if not line.startswith("#")) for text in texts]
    return [column for head in heads for column in head.split(",")]


COURSES = few(("3-9", "4-3a"), 2)
SOLUTIONS = few([entry.id for entry in library()], 48)
PAGES = few([*((name, "course") for name in COURSES), *((name, "solution") for name in SOLUTIONS)], 2)


@pytest.mark.parametrize(("name", "style"), PAGES)
def test_no_page_has_a_word_of_the_other_language(name: str, style: str) -> None:
    zh, en = printed(name, "zh", style), printed(name, "en", style)
    assert len(CHINESE.findall(zh)) > 100 and len(ENGLISH.findall(en)) > 50
    assert foreign(Words(zh, "")) == [] and foreign(Words("", en)) == []


@pytest.mark.parametrize(("name", "style"), PAGES)
def test_a_number_below_zero_is_printed_with_a_minus_and_no_hyphen(name: str, style: str) -> None:
    for lang in ("zh", "en"):
        text = SYMBOL.sub(" ", printed(name, lang, style))
        assert len(text) > 100 and re.findall(r"(?:(?<=[\s(（=,，])|^)-\d.{,20}", text) == []


@pytest.mark.parametrize(("name", "style"), PAGES)
def test_both_pages_of_a_report_hold_the_same_objects_with_the_same_numbers(name: str, style: str) -> None:
    one, two = marked_up(name, "zh", style)[1].named, marked_up(name, "en", style)[1].named
    assert [key.rstrip(DIGITS) for key in besides_sheets(one)] == [key.rstrip(DIGITS) for key in besides_sheets(two)]
    assert len(one) >= 1  # a sheet more, where titles of figures are longer in one language, moves the others on
    for key, other in zip(besides_sheets(one), besides_sheets(two), strict=True):
        here, there = one[key], two[other]
        assert type(here) is type(there), key
        if isinstance(here, DataTable) and isinstance(there, DataTable):
            assert decimals_of(here) == decimals_of(there), key
        elif isinstance(here, Drawing) and isinstance(there, Drawing):
            assert here.size == pytest.approx(there.size, abs=34.0), key  # 12 mm: titles are wider in one language


def besides_sheets(objects: Mapping[str, object]) -> list[str]:
    return [key for key in objects if not key.startswith("sheet")]


def decimals_of(table: DataTable) -> list[list[set[str]]]:
    return [[decimals(cell) for cell in row] for row in table.rows]


def decimals(cell: object) -> set[str]:
    """The numbers with a decimal point of a cell."""
    return set(re.findall(r"\d+\.\d+", str(cell))) if isinstance(cell, str) else set()


@pytest.mark.parametrize(("name", "style"), PAGES)
def test_both_pages_of_a_report_tell_the_same_decimals(name: str, style: str) -> None:
    zh, en = (decimals(re.sub(r"<[^>]*>", " ", marked_up(name, lang, style)[0])) for lang in ("zh", "en"))
    assert zh == en and (zh or style == "solution")
