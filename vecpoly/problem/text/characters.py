"""Characters that no problem file needs:
control signs, signs that turn the direction of writing, halves of a character.

They would steer the terminal that prints them, or show another text than the file holds;
so they are refused, with their column.
"""

from __future__ import annotations

import unicodedata

from ...errors import ProblemFileError
from ...foundation.patterns import pattern
from ...words import Words

_UNWANTED = pattern(
    "[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\xad\u0600-\u0605\u061c\u06dd\u070f\u180e\u200b-\u200f\u2028-\u202e\u2060-\u206f\ud800-\udfff\ufeff\ufff9-\ufffb\ufdd0-\ufdef\ufffe\uffff\U000e0000-\U000e0fff]"
)


def refuse_unwanted(text: str, name: str, line: int = 1, column: int = 1) -> None:
    """Raise ProblemFileError at the first such character; the text begins at this line and column."""
    m = _UNWANTED.search(text)
    if m is None:
        return
    before = text[: m.start()]
    down = before.count("\n")
    across = len(before) - before.rfind("\n") if down else column + len(before)
    sign = f"U+{ord(m[0]):04X}"
    called = unicodedata.name(m[0], "")
    raise ProblemFileError(
        Words(
            f"{name}，第 {line + down} 行第 {across} 列：不可见的控制字符 "
            f"{sign}{f'（{called}）' if called else ''}；请删去",
            f"{name}, line {line + down}, column {across}: the invisible control character "
            f"{sign}{f' ({called})' if called else ''}; delete it",
        ),
        code="control character",
        numbers={"line": line + down, "column": across},
    )
