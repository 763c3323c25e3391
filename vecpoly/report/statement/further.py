"""A further solution of a synthesis, of which a question tells nothing but that there may be one."""

from __future__ import annotations

import re
from collections.abc import Mapping

from ...board.construction import Reading
from ...words import Words

IF_ANY = Words("（如有）", " (if there is one)")
THE_SAME = Words("若有另一解，同样求其各量", "the same of a further solution, if there is one")
_NUMBER = re.compile(r"\^\{?\((\d)\)")
_TITLED = (re.compile(r"（解 ([2-9])）"), re.compile(r"\(solution ([2-9])\)"))


def further(readings: Mapping[str, Reading]) -> frozenset[str]:
    """The keys of what belongs to a second solution, or to one after that; none where the first has a number too: then
    the problem says how many there are."""
    numbers = {key: number for key, one in readings.items() if (number := number_in(one.symbol))}
    return frozenset() if 1 in numbers.values() else frozenset(numbers)


def number_in(symbol: str) -> int:
    """The number above a symbol, l_{AB}^{(2)}; 0 where there is none."""
    return int(found[1]) if (found := _NUMBER.search(symbol)) else 0


def doubtful(title: Words) -> Words:
    """The title of the figure of such a solution, which does not tell that there is one."""
    zh, en = (one.sub(into, text) for one, into, text in zip(_TITLED, _INTO, (title.zh, title.en), strict=True))
    return Words(zh, en)


_INTO = (r"（解 \1，如有）", r"(solution \1, if there is one)")
