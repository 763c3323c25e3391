"""How places, positions and pairs are written in the data of a synthesis, read."""

from __future__ import annotations

import re
from cmath import exp
from dataclasses import dataclass
from math import asin, degrees, inf
from typing import Annotated, Any

from pydantic import BeforeValidator, WithJsonSchema

from ...errors import FaultError
from ...foundation.patterns import pattern
from ...units.reading import Dim, Quantity, read
from ...words import Words
from ..place import Carried
from .plan import On, Position

_PLACE = r"\(\s*(?P<x>[^,()]+?)\s*,\s*(?P<y>[^,()]+?)\s*\)\s*(?P<unit>[a-zA-Z]+)"
_POINT = pattern(rf"\s*{_PLACE}\s*")
_POSED = pattern(rf"\s*{_PLACE}\s+at\s+(?P<angle>.+?)\s*")
_POLAR = pattern(r"\s*(?P<size>[^()]+?)\s+at\s+(?P<angle>.+?)\s*")
_LEANING = pattern(r"\s*(?P<angle>.+?)\s+(?P<sign>[+−-])\s*asin\(\s*(?P<one>[^/()]+?)\s*/\s*(?P<two>[^/()]+?)\s*\)\s*")
_PAIR = pattern(r"\s*(?P<one>.+?)\s*(?:->|→)\s*(?P<two>.+?)\s*")


@dataclass(frozen=True, slots=True)
class Point:
    """A place (m), and as it was written."""

    at: complex
    text: str

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True, slots=True)
class Posed:
    """A position of a body, and as it was written."""

    position: Position
    text: str

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True, slots=True)
class Pair:
    """An angle of the input link (rad) and what belongs to it: an angle of the output link, or a place of a slider."""

    one: float
    two: float
    slides: bool
    text: str

    def __str__(self) -> str:
        return self.text

    @property
    def told(self) -> tuple[str, str]:
        """Both, as they were written."""
        m = _PAIR.fullmatch(self.text)
        assert m is not None
        return m["one"], m["two"]


def _point(written: Any) -> Point:
    """[30 mm, 5 mm], (30, 5) mm or 30 mm at 40 deg."""
    if isinstance(written, Point):
        return written
    if isinstance(written, list | tuple) and len(written) == 2:
        x, y = (read(part, Dim.LENGTH) for part in written)
        return Point(complex(x.si, y.si), f"({x.text}, {y.text})")
    if isinstance(written, str) and (polar := _POLAR.fullmatch(written)):
        size, angle = read(polar["size"], Dim.LENGTH).si, read(polar["angle"], Dim.ANGLE).si
        return Point(size * exp(1j * angle), written)
    if not (isinstance(written, str) and (m := _POINT.fullmatch(written))):
        raise _unread(written, Words("点", "place"), "(30, 5) mm")
    return Point(_at(m), written)


def _posed(written: Any) -> Posed:
    """(30, 5) mm at 20 deg."""
    if isinstance(written, Posed):
        return written
    if not (isinstance(written, str) and (m := _POSED.fullmatch(written))):
        raise _unread(written, Words("位置", "position"), "(30, 5) mm at 20 deg")
    return Posed(Position(at=_at(m), angle=read(m["angle"], Dim.ANGLE).si), written)


def _pair(written: Any) -> Pair:
    """40 deg -> 30 deg, or 40 deg -> 62 mm."""
    if isinstance(written, Pair):
        return written
    if not (isinstance(written, str) and (m := _PAIR.fullmatch(written))):
        raise _unread(written, Words("对应位置", "pair"), "40 deg -> 30 deg")
    slides = m["two"].rstrip().endswith("m")
    two = read(m["two"], Dim.LENGTH if slides else Dim.ANGLE)
    return Pair(read(m["one"], Dim.ANGLE).si, two.si, slides, written)


def _direction(written: Any) -> Quantity:
    """90 deg, or an angle beside one whose sine is known: 90 deg - asin(30 mm / 100 mm)."""
    if isinstance(written, Quantity):
        return written
    if not (isinstance(written, str) and (m := _LEANING.fullmatch(written))):
        return read(written, Dim.ANGLE)
    sine = read(m["one"], Dim.LENGTH).si / (read(m["two"], Dim.LENGTH).si or inf)
    if not abs(sine) <= 1:
        raise FaultError(
            Words(
                f"“{written}”：正弦 {sine:.6g} 应在 −1 与 1 之间",
                f"'{written}': the sine {sine:.6g} must lie between −1 and 1",
            ),
            code="out-of-range",
        )
    turned = read(m["angle"], Dim.ANGLE).si + (1 if m["sign"] == "+" else -1) * asin(sine)
    return Quantity(turned, written)


def _at(m: re.Match[str]) -> complex:
    x, y = (read(f"{m[part]} {m['unit']}", Dim.LENGTH).si for part in ("x", "y"))
    return complex(x, y)


def _unread(written: object, what: Words, example: str) -> FaultError:
    return FaultError(
        Words(f"“{written}”不是{what.zh}；如写 {example}", f"'{written}' is no {what.en}; write e.g. {example}"),
        code="spelling",
    )


def on(line: Carried) -> On:
    """A written line as one of the plan."""
    return On(through=line.at, along=line.along)


def told_angle(angle: Quantity) -> str:
    """As it is written; what was worked out, 90 deg - asin(30 mm / 100 mm), to a tenth of a degree."""
    return f"{degrees(angle.si):.1f} deg" if "(" in angle.text else angle.text


def said(letter: str, line: Carried) -> tuple[str, str]:
    """The line of a point for 已知: y_A and its value."""
    axis = "y" if line.along.real else "x"
    return f"{axis}_{{{letter}}}", line.text.partition("=")[2].strip()


_TEXT = WithJsonSchema({"type": "string"})
Place = Annotated[Point, BeforeValidator(_point), WithJsonSchema({"type": ["string", "array"]})]
Pose = Annotated[Posed, BeforeValidator(_posed), _TEXT]
Corresponding = Annotated[Pair, BeforeValidator(_pair), _TEXT]
Direction = Annotated[Quantity, BeforeValidator(_direction), _TEXT]
