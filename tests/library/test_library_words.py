"""No English word in a Chinese sentence and no Chinese character in an English one:
steps, remarks, titles, notes, tables, facts."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path

import pytest

from tests.drawn_library import IDS, drawn, sentences
from tests.each import each
from tests.laws import few
from tests.studies import solved, studied
from vecpoly.check.table.whole import TableCheck, check_table
from vecpoly.cycle.facts.found import facts
from vecpoly.cycle.facts.sentences import sentences as facts_told
from vecpoly.cycle.whole_cycle import cycle
from vecpoly.problem.load import load
from vecpoly.report import printed_tables
from vecpoly.report.content import Objects
from vecpoly.report.course import document
from vecpoly.report.document import markup
from vecpoly.report.flow.blocks import Drawing
from vecpoly.report.flow.table import DataTable
from vecpoly.words import Lang, Words

CHINESE = re.compile(r"[\u3000-\u303f\u3400-\u9fff\uff00-\uffef]")
ENGLISH = re.compile(r"[A-Za-z]{3,}")
UNITS = re.compile(r"(?:(?<=\d )|(?<=r/))(mm|rad|min|deg|kg)\b")
NAMES = {
    "Assur",
    "Grashof",
    "tan",
    "arctan",
    "sin",
    "cos",
    "cot",
    "asin",
    "log",
    "rad",
    "extends",
}  # as Chinese textbooks print them; a key of the problem file


def foreign(words: Words) -> list[str]:
    """What in a sentence belongs to the other language; symbols, units and letters of points aside."""
    zh, en = (re.sub(r"\$[^$]*\$", " ", text) for text in (words.zh, words.en))
    return CHINESE.findall(en) + [
        word for word in ENGLISH.findall(UNITS.sub("", zh)) if word not in NAMES and not word.isupper()
    ]


@pytest.mark.parametrize(
    ("words", "found"),
    [
        (Words("由极点 $p$ 作 $pb$", "from the pole"), []),
        (Words("from the pole", "由极点"), ["由", "极", "点", "from", "the", "pole"]),
        (Words("半径 5 mm，△ABC", "radius 5 mm"), []),
        (Words("", "，"), ["，"]),
    ],
)
def test_a_foreign_word_is_seen(words: Words, found: list[str]) -> None:
    assert foreign(words) == found


@each(IDS)
def test_no_sentence_of_a_construction_has_a_word_of_the_other_language(name: str) -> None:
    said = list(sentences(drawn(name).construction))
    assert len(said) >= 2 * len(drawn(name).construction.steps) > 0
    assert {words: foreign(words) for words in said if foreign(words)} == {}


@each(IDS)
def test_every_step_says_something_in_both_languages(name: str) -> None:
    steps = drawn(name).construction.steps
    assert steps and [step.number for step in steps] == list(range(1, len(steps) + 1))
    assert all(
        step.words.zh.strip() and step.words.en.strip() and step.section.zh and step.section.en for step in steps
    )


@pytest.mark.parametrize("name", ["A-27", "3-9", "3-5", "A-30", "B-24", "4-3a", "4-6"])
def test_no_fact_of_a_cycle_has_a_word_of_the_other_language(name: str) -> None:
    turn = cycle(load(name), n=73)
    said = facts_told(turn, facts(turn))
    assert len(said) >= 2 and {words: foreign(words) for words in said if foreign(words)} == {}


@cache
def checked(name: str, file: Path) -> TableCheck:
    return check_table(solved(name).problem, file)


@cache
def marked_up(name: str, lang: Lang, style: str) -> tuple[str, Objects]:
    """A report in both languages is about one study, and its tables are checked once."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(document, "study", lambda one: studied(one.problem.id))
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
PAGES = [*((name, "solution") for name in few(IDS, 24)), *((name, "course") for name in COURSES)]


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


# -- what the one language names, the other names as well -------------------------------------------------------------

SYMBOL = re.compile(r"\$([^$]*)\$")
ATOM = re.compile(r"[A-Za-zΑ-Ωα-ω](?:_\{[^}]*\}|_\w+)?′*|\d+(?:\.\d+)?")  # v_{BC}, c_2′, 90; of △ABC each letter
NUMBER = re.compile(r"\d+(?:\.\d+)?")
COUNTED = re.compile(r"^方法[一二三]")  # the Chinese counts in numerals
MORE_IN_CHINESE = {"5-1": {"F_0"}}  # the symbol of the ideal force
MORE_IN_ENGLISH = {"cam-roller": {"K"}}
SENSES = {"逆时针": r"counter-clockwise|\bccw", "顺时针": r"(?<!counter-)clockwise|\bcw"}

DIGITS = "0123456789"


def atoms(text: str) -> set[str]:
    """Every letter, symbol and number between dollar signs."""
    return {atom for symbols in SYMBOL.findall(text) for atom in ATOM.findall(symbols)}


def numbers(text: str) -> set[str]:
    """Every number outside of symbols."""
    return set(NUMBER.findall(SYMBOL.sub("", text)))


@each(IDS)
def test_letters_symbols_and_numbers_of_a_sentence_are_the_same_in_both_languages(name: str) -> None:
    for words in set(sentences(drawn(name).construction)):
        zh, en = atoms(words.zh), atoms(words.en)
        assert zh - en <= MORE_IN_CHINESE.get(name, set()) and en - zh <= MORE_IN_ENGLISH.get(name, set()), words
        assert COUNTED.search(words.zh) or numbers(words.zh) == numbers(words.en), words


@each(IDS)
def test_a_sense_of_rotation_is_told_in_both_languages_or_in_none(name: str) -> None:
    for words in set(sentences(drawn(name).construction)):
        for zh, en in SENSES.items():
            assert (zh in words.zh) == bool(re.search(en, words.en)), words


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
            assert (here.width, here.height) == pytest.approx((there.width, there.height), abs=12.0), key


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
