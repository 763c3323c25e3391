"""Acts that find, read and compute; what they give is used, and leaves no ink."""

from __future__ import annotations

from enum import StrEnum
from typing import ClassVar

from ...foundation.slotted import dataclass
from ...words import Words
from ..otherwise.slip import Chance
from .base import Done

FOUND_ON = "construction"  # owner of a point that is found by a construction on the diagram, as a centre is


@dataclass(frozen=True, slots=True, kw_only=True)
class Locate(Done):
    """A point has been found, and has its letter (key) from now on."""

    verb: ClassVar[Words | None] = Words("定点", "point")
    at: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Turn(Done):
    """Carry a direction to another place with the set square: the unit vector `along`."""

    along: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Invert(Done):
    """Turn a figure back with its link until the link covers the position that is kept: the point `at` of it."""

    verb: ClassVar[Words | None] = Words("反转", "turn back")
    at: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Parallel(Done):
    """Rule a line through a point parallel, or perpendicular, to a drawn direction."""

    verb: ClassVar[Words | None] = Words("作方向线", "direction of")
    at: complex
    along: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Ray(Done):
    """Set out a line through a point at an angle from a drawn direction, by protractor; known: by an angle of
    friction, or one that a diagram tells, which nobody takes for its complement."""

    verb: ClassVar[Words | None] = Words("作射线", "ray")
    at: complex
    along: complex
    known: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class LayOff(Done):
    """Lay off a length (mm) from a point in a direction."""

    verb: ClassVar[Words | None] = Words("截取", "lay off")
    start: complex
    at: complex
    mm: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Follow(Done):
    """Go along a vector (key) that stands on the polygon already."""

    verb: ClassVar[Words | None] = Words("沿已有矢量", "go along")
    by: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Transfer(Done):
    """Carry a length, or a whole vector, to another place with the dividers."""

    verb: ClassVar[Words | None] = Words("移画", "transfer")
    by: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Meet(Done):
    """Where two lines, a line and an arc, or two arcs meet; other: the second meeting, which was not taken.

    angle: at which an arc crosses the other arc, or the line (rad, to a right angle).
    """

    verb: ClassVar[Words | None] = Words("求交点", "meet")
    at: complex
    other: complex | None = None
    angle: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Touch(Done):
    """A line of action (key: its force) that touches one friction circle, or two;
    free: there is no circle, the radius is zero."""

    verb: ClassVar[Words | None] = Words("作切线", "tangent")
    along: complex
    free: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Image(Done):
    """The third corner of a similar figure with the same letter order; other: with the reversed order, None where the
    three are in line."""

    verb: ClassVar[Words | None] = Words("作影像", "image")
    at: complex
    other: complex | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Measure(Done):
    """Read a length (key: its letters) off the rule."""

    verb: ClassVar[Words | None] = Words("量得", "measure")
    a: complex
    b: complex
    mm: float


class Way(StrEnum):
    """How an area is measured: by counting the squares of millimetre paper, or with a planimeter."""

    SQUARES = "squares"
    PLANIMETER = "planimeter"


@dataclass(frozen=True, slots=True, kw_only=True)
class Area(Done):
    """Measure an area (key) on paper: so many mm², never less than nothing; outline: its corners, round it once."""

    verb: ClassVar[Words | None] = Words("量面积", "area")
    outline: tuple[complex, ...]
    way: Way
    mm2: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Judge(Done):
    """Judge whether two lines cross at a point (key) or only touch there, so that what lies between has one sign."""

    verb: ClassVar[Words | None] = Words("判别相交", "crossing")
    crosses: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Gauge(Done):
    """Read a direction off the protractor (rad)."""

    angle: float


def is_reading(act: Done) -> bool:
    """Whether something is read off the paper: with rule, protractor or planimeter."""
    return isinstance(act, Measure | Area | Gauge)


@dataclass(frozen=True, slots=True, kw_only=True)
class Compute(Done):
    """Symbol = formula = numbers = result.

    chances: what may be done wrongly with it.
    """

    verb: ClassVar[Words | None] = Words("计算", "compute")
    value: float
    unit: str
    chances: tuple[Chance, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Answer(Done):
    """Write down what was found of a quantity (key): the value in SI units, of a vector x + iy."""

    verb: ClassVar[Words | None] = Words("结果", "answer")
    value: complex
    unit: str
