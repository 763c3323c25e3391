"""The sense of turning that stands beside a number: 顺, 逆时针, cw, ↻."""

from __future__ import annotations

import re

_CCW = r"逆时针(?:方向)?|反时针(?:方向)?|逆|counter-?\s?clockwise|anti-?\s?clockwise|ccw|acw|↺|⟲|⭯"
_CW = r"顺时针(?:方向)?|顺|clockwise|cw|↻|⟳|⭮"
_WORD = re.compile(
    rf"[\s,;(\[]*(?:方向|转向|sense|dir(?:ection)?)?\s*[:=]?\s*(?:(?P<ccw>{_CCW})|(?P<cw>{_CW}))[\s)\].]*", re.I
)


def split_sense(text: str) -> tuple[str, tuple[int, ...]]:
    """The text without words of sense, and each sense that was said: 1 counter-clockwise, −1 clockwise."""
    said: list[int] = []

    def found(word: re.Match[str]) -> str:
        said.append(1 if word["ccw"] else -1)
        return " "

    return _WORD.sub(found, text).strip(), tuple(said)
