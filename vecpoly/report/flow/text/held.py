"""What no line break parts: a number and its unit, the sides of a short equation, a word and the number after it,
a pair of coordinates, a sense of turning."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache

from ....typeset.atoms import is_unit

RELATIONS, SIGNS = frozenset("=≈≙≤≥<>≠"), frozenset("+−×")
_NUMBER = re.compile(r"[(（]?[+−-]?\d[\d.,:]*(?:×10\^\{?[−-]?\d+\}?)?\)?")
_OPENS, _COORDINATE = re.compile(r"\([+−-]?\d[\d.]*,?"), re.compile(r"[+−-]?\d[\d.]*")
_MARKS = "°),.;:!?，。；：、"
_SENSES = frozenset(("逆时", "顺时", "时针"))
_BEFORE_NUMBERS = frozenset(
    ("link", "links", "step", "steps", "Step", "problem", "Problem", "figure", "Figure", "table", "Table")
)
_BEFORE_NUMBERS |= {"chapter", "Chapter", "sheet", "Sheet", "body", "gear", "group", "point"}
_HAN_BEFORE_NUMBERS = frozenset("件第题图表步")
UNBROKEN = "\u00a0"  # a blank at which no line ends


@lru_cache(maxsize=4096)
def held(before: str, after: str) -> bool:
    """Whether two neighbouring pieces of text stay on one line; a formula is ``$``."""
    if is_number(before) and is_unit(after.rstrip(",.;:!?，。；：、)）")):
        return True
    if before in RELATIONS:
        return is_number(after.rstrip("°,.;:，。；、"))
    if after in RELATIONS:
        return before == "$" or is_number(before)
    if before + after in _SENSES or (before == "$" and after in ("逆", "顺")):
        return True
    return (before in _BEFORE_NUMBERS or before in _HAN_BEFORE_NUMBERS) and after[:1].isdigit()


def in_brackets(texts: Sequence[str]) -> Iterator[int]:
    """Which pieces go on with a pair of coordinates: (46 mm, 9 mm), (0, −130)."""
    start: int | None = None
    for n, text in enumerate(texts):
        if (
            start is not None
            and _COORDINATE.fullmatch(text.rstrip(_MARKS)) is None
            and not is_unit(text.rstrip(_MARKS))
        ):
            start = None
        if start is not None and ")" in text:
            yield from range(start + 1, n + 1)
            start = None
        elif _OPENS.fullmatch(text):
            start = n


def unbroken(text: str, before: str = "") -> str:
    """The text with blanks at which no line ends between what stays together; before: the piece that it follows."""
    pieces = text.split(" ")
    bracketed = set(in_brackets(pieces))
    out, last = pieces[0], pieces[0] or before
    for n, piece in enumerate(pieces[1:], 1):
        out += (UNBROKEN if n in bracketed or _kept(last, piece) else " ") + piece
        last = piece
    return out


def _kept(before: str, after: str) -> bool:
    """As `held`, in a narrow column: sums of numbers are not parted, a chain goes on with its next equality sign."""
    if before in SIGNS:
        return is_number(after.rstrip("°,.;:，。；、"))
    if is_number(before) and after in SIGNS | RELATIONS:
        return after in SIGNS
    return held(before, after)


def is_number(text: str) -> bool:
    """Whether a piece is a number: 5, −76.1, 4.2×10^{−5}."""
    return _NUMBER.fullmatch(text) is not None
