"""Two coordinates as they are written: (15, 26) mm, 15.0,26.0 mm, x = 15 mm; y = 26 mm."""

from __future__ import annotations

import re

Pair = tuple[str, str, str]  # both coordinates, each perhaps with a unit of its own, and a unit behind the bracket
_BRACKETS = re.compile(r"(?:[A-Z]\w*)?\(\s*(.+?)\s*\)\s*(\S*)")
_X, _Y = r"\s*(?:x\s*[=:]\s*)?", r"\s*(?:y\s*[=:]\s*)?"
_PLAIN = r"[+-]?\s*(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_COMMA = r"[+-]?\s*\d+(?:,\d+)?"  # with a decimal comma
_UNIT = r"\s*[A-Za-z米毫厘]*\s*"
_OPEN = re.compile(rf"{_X}({_PLAIN}{_UNIT})[,;\s]{_Y}({_PLAIN}{_UNIT})", re.I)
_OPEN_COMMAS = re.compile(rf"{_X}({_COMMA}{_UNIT});{_Y}({_COMMA}{_UNIT})", re.I)
_DOUBTFUL = re.compile(r"[+-]?\s*\d+[,\s]\d+\D*")  # 1,234 and 1 234: one number, or two


def in_brackets(text: str) -> Pair | None:
    """The coordinates in brackets, parted by a semicolon, or else by the only comma, or by that before a space."""
    found = _BRACKETS.fullmatch(text)
    if found is None:
        return None
    for sign in (";", ",", ", "):
        if found[1].count(sign) == 1:
            x, y = found[1].split(sign)
            return re.sub(rf"^{_X}", "", x), re.sub(rf"^{_Y}", "", y), found[2]
    return None


def without_brackets(text: str) -> Pair | None:
    """The coordinates without brackets, where they can be nothing else: of 31,9 nobody knows."""
    if _DOUBTFUL.fullmatch(text):
        return None
    found = _OPEN.fullmatch(text) or _OPEN_COMMAS.fullmatch(text)
    return None if found is None else (found[1].strip(), found[2].strip(), "")
