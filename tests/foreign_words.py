"""What in a text belongs to the other language."""

from __future__ import annotations

import re

from vecpoly.words import Words

CHINESE = re.compile(r"[\u3000-\u303f\u3400-\u9fff\uff00-\uffef]")
ENGLISH = re.compile(r"[A-Za-z]{3,}")
UNITS = re.compile(r"(?:(?<=\d )|(?<=r/))(mm|rad|min|deg|kg)\b")
SYMBOL = re.compile(r"\$([^$]*)\$")
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
