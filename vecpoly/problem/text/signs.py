"""Full-width signs of a Chinese keyboard, their narrow counterparts, and which keys hold texts that keep them."""

from __future__ import annotations

import re

from ...foundation.patterns import pattern

WIDE = pattern("[\u3000-\u3002\u3008-\u3011\uff01-\uff5e“”‘’]")
# words for people: kept as written
TEXTS = frozenset({"title", "source", "statement", "explain", "errata", "note", "zh", "en", "title_block"})
FILES = frozenset({"extends", "tables", "problem", "problems"})  # names of files, which may hold any letter
OPENING = {"{": "}", "[": "]", "｛": "}", "［": "]", "【": "]"}
CLOSING = {"}": "}", "]": "]", "｝": "}", "］": "]", "】": "]"}
QUOTES = {"“": "”", "”": "”", "＂": "＂"}
# keys of two components, which may stand in parentheses
PAIRS = frozenset({"frame", "guesses", "velocity", "acceleration"})
ROUND = pattern(r"[(（][^(){}（）\[\],，]+[,，][^(){}（）\[\],，]+[)）](?=[ \u3000]*(?:[,，}｝\]］】]|#|$))", re.M)
_PLAIN = {"\u3000": " ", "、": ",", "‘": "'", "’": "'"}
_DOUBTFUL = {
    "；": ",",
    "。": ".",
    "！": "",
    "？": '"?"',
    "＃": "#",
    "《": '"',
    "》": '"',
    "「": '"',
    "」": '"',
    "『": '"',
    "』": '"',
    "〈": '"',
    "〉": '"',
    "：": ": ",
    "‘": "'",
}


def narrow(sign: str) -> str:
    """The narrow counterpart of a sign: ａ → a, ， → a comma; any other sign is itself."""
    if sign in _PLAIN:
        return _PLAIN[sign]
    return chr(ord(sign) - 0xFEE0) if "\uff01" <= sign <= "\uff5e" else sign


def squared(pair: str) -> str:
    """（0 mm，0 mm） → [0 mm, 0 mm], sign by sign."""
    return f"[{''.join(map(narrow, pair[1:-1]))}]"


def remedy(sign: str) -> str | None:
    """What to write in place of a sign whose meaning is in doubt; None where there is no doubt."""
    return _DOUBTFUL.get(sign)
