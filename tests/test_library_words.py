"""No English word in a Chinese sentence and no Chinese character in an English one: steps, remarks, titles, notes, tables, facts."""

from __future__ import annotations

import re
from functools import cache

import pytest

from tests.drawn_library import IDS, drawn, sentences
from vecpoly.cycle.cycle import cycle
from vecpoly.cycle.facts import facts
from vecpoly.cycle.sentences import sentences as facts_told
from vecpoly.problem.load import load
from vecpoly.report.document import markup
from vecpoly.report.flow.table import DataTable
from vecpoly.solution import Solution, solve
from vecpoly.words import Lang, Words

CHINESE = re.compile(r"[\u3000-\u303f\u3400-\u9fff\uff00-\uffef]")
ENGLISH = re.compile(r"[A-Za-z]{3,}")
UNITS = re.compile(r"(?:(?<=\d )|(?<=r/))(mm|rad|min|deg|kg)\b")
NAMES = {"Assur", "Grashof", "tan", "arctan", "sin", "cos", "rad", "extends"}  # as Chinese textbooks print them; a key of the problem file


def foreign(words: Words) -> list[str]:
    """What in a sentence belongs to the other language; symbols, units and letters of points aside."""
    zh, en = (re.sub(r"\$[^$]*\$", " ", text) for text in (words.zh, words.en))
    return CHINESE.findall(en) + [word for word in ENGLISH.findall(UNITS.sub("", zh)) if word not in NAMES and not word.isupper()]


@pytest.mark.parametrize(("words", "found"), [
    (Words("由极点 $p$ 作 $pb$", "from the pole"), []), (Words("from the pole", "由极点"), ["由", "极", "点", "from", "the", "pole"]),
    (Words("半径 5 mm，△ABC", "radius 5 mm"), []), (Words("", "，"), ["，"]),
])
def test_a_foreign_word_is_seen(words: Words, found: list[str]) -> None:
    assert foreign(words) == found


@pytest.mark.parametrize("name", IDS)
def test_no_sentence_of_a_construction_has_a_word_of_the_other_language(name: str) -> None:
    said = list(sentences(drawn(name).construction))
    assert len(said) >= 2 * len(drawn(name).construction.steps) > 0
    assert {words: foreign(words) for words in said if foreign(words)} == {}


@pytest.mark.parametrize("name", IDS)
def test_every_step_says_something_in_both_languages(name: str) -> None:
    steps = drawn(name).construction.steps
    assert steps and [step.number for step in steps] == list(range(1, len(steps) + 1))
    assert all(step.words.zh.strip() and step.words.en.strip() and step.section.zh and step.section.en for step in steps)


@pytest.mark.parametrize("name", ["A-27", "3-9", "3-5", "A-30", "B-24", "4-3a", "4-6"])
def test_no_fact_of_a_cycle_has_a_word_of_the_other_language(name: str) -> None:
    turn = cycle(load(name), n=73)
    said = facts_told(turn, facts(turn))
    assert len(said) >= 2 and {words: foreign(words) for words in said if foreign(words)} == {}


@cache
def solved(name: str) -> Solution:
    return solve(load(name), repeats=0)


def printed(name: str, lang: Lang, style: str) -> str:
    """The running text of a report, without symbols, formulas and drawings."""
    text, objects = markup([solved(name)], lang, style, {}, None, None)
    tables = [table for table in objects.named.values() if isinstance(table, DataTable)]
    cells = [cell for table in tables for row in (table.header, *table.rows) for cell in row if isinstance(cell, str)]
    return " ".join([re.sub(r"<[^>]*>", " ", text), *cells, *(table.caption for table in tables)])


@pytest.mark.parametrize(("name", "style"), [*((name, "solution") for name in IDS[1::5]), ("4-3a", "course"), ("3-9", "course")])
def test_no_page_has_a_word_of_the_other_language(name: str, style: str) -> None:
    zh, en = printed(name, "zh", style), printed(name, "en", style)
    assert len(CHINESE.findall(zh)) > 100 and len(ENGLISH.findall(en)) > 50
    assert foreign(Words(zh, "")) == [] and foreign(Words("", en)) == []
