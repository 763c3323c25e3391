"""English sentences of a step begin with a capital and with a word, whatever they are put together from."""

from __future__ import annotations

import re

from tests.drawn_library import IDS, drawn
from tests.each import each

SYMBOL = re.compile(r"(?:^|(?<!\.\.)\. \(?)\$")
HAN = re.compile("[\u4e00-\u9fff]")
SMALL = re.compile(r"(?:^|(?<!\.\.)\. )[a-z]\w+")  # B_1, B_2 ... give the curve: no end of a sentence


@each(IDS)
def test_a_sentence_of_a_step_begins_with_a_capital(name: str) -> None:
    for step in drawn(name).construction.steps:
        assert not SMALL.search(step.words.en.strip()), step.words.en


@each(IDS)
def test_no_sentence_of_a_step_begins_with_a_symbol(name: str) -> None:
    for step in drawn(name).construction.steps:
        assert not SYMBOL.search(step.words.en.strip()), step.words.en


@each(IDS)
def test_a_blank_parts_a_chinese_character_from_a_symbol(name: str) -> None:
    for step in drawn(name).construction.steps:
        texts = step.words.zh.split("$")[::2]  # between the symbols
        assert not any(HAN.match(text[-1:]) for text in texts[:-1]), step.words.zh
        assert not any(HAN.match(text) for text in texts[1:]), step.words.zh
