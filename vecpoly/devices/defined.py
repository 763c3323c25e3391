"""What the symbols of a task are called, in a sentence: $m_i$ are the masses; $b$ is the thickness of the disc."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from ..words import Words, plural

_MANY = 3  # symbols of one letter that are told by their index
_INDEXED = re.compile(r"([^_]+)_\{?[^_{}]+\}?")


def listed(symbols: Sequence[str]) -> Words:
    """$m_1$、$m_2$; $m_i$ where there are many of one letter."""
    indexed = [_INDEXED.fullmatch(one) for one in symbols]
    stems = {found[1] for found in indexed if found is not None}
    if len(symbols) >= _MANY and len(stems) == 1 and all(indexed):
        return Words.same(f"${stems.pop()}_i$")
    signs = [f"${one}$" for one in symbols]
    *first, last = signs
    return Words("、".join(signs), f"{', '.join(first)} and {last}" if first else last)


def defined(symbols: Iterable[str], names: Mapping[str, Words]) -> tuple[Words, ...]:
    """Symbols with the name that they share, $m_i$ 为质量, by patterns of symbols; nothing of one without a name."""
    found: dict[str, list[str]] = {}
    for symbol in symbols:
        pattern = next((one for one in names if re.fullmatch(one, symbol)), None)
        if pattern is not None:
            found.setdefault(pattern, []).append(symbol)
    return tuple(_said(names[pattern], own) for pattern, own in found.items())


def _said(name: Words, symbols: Sequence[str]) -> Words:
    signs = listed(symbols)
    if len(symbols) == 1:
        return Words(f"{signs.zh} 为{name.zh}", f"{signs.en} is the {name.en}")
    return Words(f"{signs.zh} 为{name.zh}", f"{signs.en} are the {plural(name.en)}")


def sentence(*parts: Words) -> Words:
    """The parts behind each other, with the full stop; nothing of those that are empty."""
    told = [one for one in parts if one.zh]
    zh, en = "；".join(one.zh for one in told), "; ".join(one.en for one in told)
    return Words(f"{zh}。", f"{en[:1].upper()}{en[1:]}.")
