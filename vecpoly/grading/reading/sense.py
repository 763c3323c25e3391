"""The sense of turning that stands beside a number: 顺, 逆时针, cw, ↻."""

from __future__ import annotations

import re

from .characters import plain

_TURNING = r"(?:方向)?(?:(?:转动|旋转|回转|转)(?![/每]))?(?:方向)?"  # 逆时针转动, and no unit of 转/分
_CCW = (
    rf"(?:[逆反][时時][针針]?|逆){_TURNING}|"
    r"(?:counter|anti)[-\s]?clock[-\s]?(?:wise)?|c\.?\s?c\.?\s?w\.?|a\.?\s?c\.?\s?w\.?|↺|⟲|⭯"
)
_CW = rf"[顺順](?:[时時][针針]?)?{_TURNING}|clock[-\s]?wise|c\.?\s?w\.?|↻|⟳|⭮"
_WORD = re.compile(
    rf"[\s,;(\[]*(?:方向|转向|sense|dir(?:ection)?)?\s*[:=]?\s*(?:(?P<ccw>{_CCW})|(?P<cw>{_CW}))[\s)\].]*", re.I
)


_SIGNED = {"+": "ccw", "+1": "ccw", "正": "ccw", "-": "cw", "-1": "cw", "负": "cw"}  # of a column for senses alone


def as_sense(cell: str) -> str:
    """What stands in a column for senses, as it would stand behind a number: + counts counter-clockwise."""
    return _SIGNED.get(plain(cell).strip("() "), cell.strip())


def split_sense(text: str) -> tuple[str, tuple[int, ...]]:
    """The text without words of sense, and each sense that was said: 1 counter-clockwise, −1 clockwise."""
    said: list[int] = []

    def found(word: re.Match[str]) -> str:
        said.append(1 if word["ccw"] else -1)
        return " "

    return _WORD.sub(found, text).strip(), tuple(said)
