"""No English word in a Chinese sentence and no Chinese character in an English one:
steps, remarks, titles, notes, tables, facts."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import IDS, drawn, said
from tests.each import each
from tests.foreign_words import SYMBOL, foreign
from tests.found import APART, FOUND
from tests.laws import few
from vecpoly.cycle.facts.found import facts
from vecpoly.cycle.facts.sentences import sentences as facts_told
from vecpoly.cycle.whole_cycle import cycle
from vecpoly.problem.load import load
from vecpoly.words import Words


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
    assert len(said(name)) >= 2 * len(drawn(name).construction.steps) > 0
    found = {words: foreign(words) for words in dict.fromkeys(said(name))}
    assert {words: one for words, one in found.items() if one} == {}


@each(IDS)
def test_every_step_says_something_in_both_languages(name: str) -> None:
    steps = drawn(name).construction.steps
    assert steps and [step.number for step in steps] == list(range(1, len(steps) + 1))
    assert all(
        step.words.zh.strip() and step.words.en.strip() and step.section.zh and step.section.en for step in steps
    )


@pytest.mark.parametrize("name", few(["A-27", "3-9", "3-5", "A-30", "B-24", "4-3a", "4-6"], 3))
def test_no_fact_of_a_cycle_has_a_word_of_the_other_language(name: str) -> None:
    turn = cycle(load(name), n=73)
    told = facts_told(turn, facts(turn))
    assert len(told) >= 2 and {words: foreign(words) for words in told if foreign(words)} == {}


# -- what the one language names, the other names as well -------------------------------------------------------------

ATOM = re.compile(r"[A-Za-zΑ-Ωα-ω](?:_\{[^}]*\}|_\w+)?′*|\d+(?:\.\d+)?")  # v_{BC}, c_2′, 90; of △ABC each letter
NUMBER = re.compile(r"\d+(?:\.\d+)?")
COUNTED = re.compile(r"^方法[一二三]")  # the Chinese counts in numerals
MORE_IN_CHINESE = {"5-1": {"F_0"}}  # the symbol of the ideal force
MORE_IN_ENGLISH = {"cam-roller": {"K"}}
SENSES = {"逆时针": r"counter-clockwise|\bccw", "顺时针": r"(?<!counter-)clockwise|\bcw"}


def atoms(text: str) -> set[str]:
    """Every letter, symbol and number between dollar signs."""
    return {atom for symbols in SYMBOL.findall(text) for atom in ATOM.findall(symbols)}


def numbers(text: str) -> set[str]:
    """Every number outside of symbols."""
    return set(NUMBER.findall(SYMBOL.sub("", text)))


@each([*IDS, *FOUND, *APART])
def test_letters_symbols_and_numbers_of_a_sentence_are_the_same_in_both_languages(name: str) -> None:
    for words in set(said(name)):
        zh, en = atoms(words.zh), atoms(words.en)
        assert zh - en <= MORE_IN_CHINESE.get(name, set()) and en - zh <= MORE_IN_ENGLISH.get(name, set()), words
        assert COUNTED.search(words.zh) or numbers(words.zh) == numbers(words.en), words


@each(IDS)
def test_a_sense_of_rotation_is_told_in_both_languages_or_in_none(name: str) -> None:
    for words in set(said(name)):
        for zh, en in SENSES.items():
            assert (zh in words.zh) == bool(re.search(en, words.en)), words
