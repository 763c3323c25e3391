"""What no line break parts: a number and its unit, the sides of a short equation, a word and the number after it."""

from __future__ import annotations

import re

from ....typeset.atoms import is_unit

_RELATIONS = frozenset("=≈≙≤≥<>≠")
_NUMBER = re.compile(r"[(（]?[+−-]?\d[\d.,:]*(?:×10\^\{?[−-]?\d+\}?)?")
_BEFORE_NUMBERS = frozenset(
    ("link", "links", "step", "steps", "Step", "problem", "Problem", "figure", "Figure", "table", "Table")
)
_BEFORE_NUMBERS |= {"chapter", "Chapter", "sheet", "Sheet", "body", "gear", "group", "point"}
_HAN_BEFORE_NUMBERS = frozenset("件第题图表步")


def held(before: str, after: str) -> bool:
    """Whether two neighbouring pieces of text stay on one line; a formula is ``$``."""
    if is_number(before) and is_unit(after.rstrip(",.;:!?，。；：、)）")):
        return True
    if before in _RELATIONS:
        return is_number(after.rstrip("°,.;:，。；、"))
    if after in _RELATIONS:
        return before == "$" or is_number(before)
    return (before in _BEFORE_NUMBERS or before in _HAN_BEFORE_NUMBERS) and after[:1].isdigit()


def is_relation(text: str) -> bool:
    """Whether a piece is a sign between two sides: =, ≤."""
    return text in _RELATIONS


def is_number(text: str) -> bool:
    """Whether a piece is a number: 5, −76.1, 4.2×10^{−5}."""
    return _NUMBER.fullmatch(text) is not None
