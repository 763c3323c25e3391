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


Carried = Annotated[OnLine, BeforeValidator(_line), WithJsonSchema({"type": "string", "pattern": _LINE.pattern})]
