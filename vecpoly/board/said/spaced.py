"""A blank between a Chinese character and a symbol, and none before a Chinese stop or bracket, however a sentence is
put together."""

from __future__ import annotations

import re

from ...words import Words

_HAN = "\u4e00-\u9fff"
_BEFORE, _BEHIND = re.compile(rf"(?<=[{_HAN}])$"), re.compile(rf"^(?=[{_HAN}])")
_BLANK = re.compile(rf"(?<=[{_HAN}\d]) +(?=[，。；：、）（])")
_SYMBOL = re.compile(r"\$[^$]+\$")


def spaced(words: Words) -> Words:
    """The sentence with such blanks alone: 圆 $η$ 上, 从动件（构件 3）."""
    pieces = words.zh.split("$")
    pieces[::2] = [_BLANK.sub("", piece) for piece in pieces[::2]]
    if len(pieces) < 3:
        return Words("$".join(pieces), words.en)
    for n in range(0, len(pieces), 2):  # between the symbols
        if n + 1 < len(pieces):
            pieces[n] = _BEFORE.sub(" ", pieces[n])
        if n:
            pieces[n] = _BEHIND.sub(" ", pieces[n])
    return Words("$".join(pieces), words.en)


def shape(words: Words) -> Words:
    """A sentence without its symbols: what says the same of others has the same shape."""
    return Words(_SYMBOL.sub("$", words.zh), _SYMBOL.sub("$", words.en))
