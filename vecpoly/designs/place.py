"""A given line that carries a point which is to be found: `on y = -20 mm`, `on x = 35 mm`."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import BeforeValidator, WithJsonSchema

from ..errors import FaultError
from ..units.reading import Dim, read
from ..words import Words

_LINE = re.compile(r"\s*on\s+(?P<axis>[xy])\s*=\s*(?P<value>.+?)\s*")


@dataclass(frozen=True, slots=True)
class OnLine:
    """A line through `at` (m) in the direction of the unit vector `along`, and as it was written."""

    at: complex
    along: complex
    text: str


def _line(text: Any) -> OnLine:
    if isinstance(text, OnLine):
        return text
    if not (isinstance(text, str) and (m := _LINE.fullmatch(text))):
        raise FaultError(
            Words(
                f"“{text}”不是给定的直线；如写 on y = -20 mm 或 on x = 35 mm",
                f"'{text}' is no given line; write e.g. on y = -20 mm, or on x = 35 mm",
            ),
            code="spelling",
        )
    value = read(m["value"], Dim.LENGTH).si
    at, along = (1j * value, 1 + 0j) if m["axis"] == "y" else (complex(value), 1j)
    return OnLine(at, along, text)


def carried(letter: str, line: OnLine, *, primed: bool = False) -> Words:
    """A 在直线 y = y_A 上; primed: in the coordinates of a body."""
    axis = "y" if line.along.real else "x"
    mark = "′" if primed else ""
    symbol = f"${axis}{mark}$ = ${axis}{mark}_{{{letter}}}$"
    return Words(f"${letter}$ 在直线 {symbol} 上", f"${letter}$ lies on the line {symbol}")


Carried = Annotated[OnLine, BeforeValidator(_line), WithJsonSchema({"type": "string", "pattern": _LINE.pattern})]


_SPOT = re.compile(r"\s*[(（]\s*(?P<x>[^,，()]+?)\s*[,，]\s*(?P<y>[^,，()]+?)\s*[)）]\s*(?P<unit>\S*)\s*")


@dataclass(frozen=True, slots=True)
class Spot:
    """A given point (m), and as it was written."""

    at: complex
    text: str


def _spot(text: Any) -> Spot:
    if isinstance(text, Spot):
        return text
    if not (isinstance(text, str) and (m := _SPOT.fullmatch(text))):
        raise FaultError(
            Words(f"“{text}”不是给定的点；如写 (35, 11) mm", f"'{text}' is no given point; write e.g. (35, 11) mm"),
            code="spelling",
        )
    x, y = (read(f"{m[axis]} {m['unit']}".strip(), Dim.LENGTH).si for axis in "xy")
    return Spot(complex(x, y), text)


Fixed = Annotated[Spot, BeforeValidator(_spot), WithJsonSchema({"type": "string", "pattern": _SPOT.pattern})]
