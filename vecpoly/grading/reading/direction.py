"""The direction that stands behind the size of a vector: ∠210°, →, 向左, up."""

from __future__ import annotations

import re
from dataclasses import dataclass
from math import degrees

from .characters import plain
from .minutes import in_degrees

_ANGLE = r"([+-]?\d+(?:\.\d+)?)\s*"
_DEGREES = re.compile(rf"[,;]?\s*(?:∠|@|方向(?:角)?\s*[:=]?|at)\s*{_ANGLE}(?:°|deg|度)?\s*$", re.I)
_UNIT = r"(?:(?<=[a-z秒米牛分度])|(?<=[\^sm秒米][2-4]))"  # an angle behind a unit needs no sign
_BEHIND = re.compile(rf"{_UNIT}[\s,;]+{_ANGLE}(?:°|deg|度)\s*$", re.I)
_SIGNS = {  # slanting ones first: 左上 is not 上
    45.0: "↗|⇗|右上|upper right",
    135.0: "↖|⇖|左上|upper left",
    225.0: "↙|⇙|左下|lower left",
    315.0: "↘|⇘|右下|lower right",
    0.0: "→|⇒|右|right",
    90.0: "↑|⇑|上|up(?:wards?)?",
    180.0: "←|⇐|左|left",
    270.0: "↓|⇓|下|down(?:wards?)?",
}
_NAMED = r"[\s,;(]*(?:方向|指向|dir(?:ection)?\.?)?\s*[:=]?\s*"
_LED = r"(?:水平|竖直|铅垂|铅直|horizontally|vertically|to the)?\s*[向朝往]?\s*"
WIND = re.compile(_NAMED + _LED + "(?:" + "|".join(f"({signs})" for signs in _SIGNS.values()) + r")方?[\s).]*$", re.I)
_STRAIGHT, _SLANTING = 22.5, 45.0  # deg: how far → and ↗ reach to either side


@dataclass(frozen=True, slots=True)
class Pointing:
    """degrees: from +x, counter-clockwise. reach: how far to either side the words reach (deg); 0 of a number."""

    degrees: float
    reach: float = 0.0

    def beside(self, degrees: float) -> float:
        """How far from another direction (deg, at most 180)."""
        return abs((self.degrees - degrees + 180.0) % 360.0 - 180.0)


_LEAD = re.compile(r"^(?:[≈~=≅∠@]|约为|约|方向(?:角)?|at|\s|:)+", re.I)
_NUMBER = re.compile(r"([+-]?\d+(?:\.\d+)?(?:e[+-]?\d+)?)\s*(°|deg|度|rad|弧度)?", re.I)
_WITHIN = re.compile(r"±|(?<=.)左右")  # 315 ± 1, 约 315 左右
_COMMA = re.compile(r"([+-]?\d+),(\d+)")


def as_direction(cell: str) -> str:
    """What stands in a column for directions, as it would stand behind a size: ``∠ 315°``; words as they are."""
    bare = in_degrees(_COMMA.sub(r"\1.\2", _LEAD.sub("", _WITHIN.split(plain(cell))[0]))).strip()
    if (found := _NUMBER.fullmatch(bare)) is None:
        return cell.strip() if WIND.fullmatch(plain(cell)) else f"∠ {cell.strip()}"
    turned = float(found[1]) * (degrees(1.0) if (found[2] or "").lower() in ("rad", "弧度") else 1.0)
    return f"∠ {turned:.10g}°"


WINDS = tuple(Pointing(at, _SLANTING if at % 90.0 else _STRAIGHT) for at in _SIGNS)  # a group of WIND each


def split_direction(text: str) -> tuple[str, Pointing | None]:
    """The text before its direction, and the direction; None where it has none."""
    if (told := _DEGREES.search(text) or _BEHIND.search(text)) is not None:
        return text[: told.start()], Pointing(float(told[1]))
    if (wind := WIND.search(text)) is not None and wind.lastindex is not None and wind.start():
        return text[: wind.start()], WINDS[wind.lastindex - 1]
    return text, None
