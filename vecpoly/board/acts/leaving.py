"""Acts that leave ink on a figure."""

from __future__ import annotations

from typing import ClassVar

from ...foundation.slotted import dataclass
from ...words import Words
from ..paper.marks import Dot, Mark, Role
from .base import Done


@dataclass(frozen=True, slots=True, kw_only=True)
class Plot(Done):
    """Letter a point on the figure."""

    at: complex
    label: str
    dot: Dot


@dataclass(frozen=True, slots=True, kw_only=True)
class Join(Done):
    """Rule a line from a to b."""

    a: complex
    b: complex
    role: Role


@dataclass(frozen=True, slots=True, kw_only=True)
class Arrow(Done):
    """Draw the vector (key) from a to b; label: the symbol written beside it,
    where the letters at its ends do not tell it."""

    verb: ClassVar[Words | None] = Words("画矢量", "vector")
    a: complex
    b: complex
    role: Role
    label: str = ""
    shown: bool = True  # a vector whose ends coincide, or which stands there already, leaves no ink


@dataclass(frozen=True, slots=True, kw_only=True)
class Rule(Done):
    """Leave a direction line on the paper, from a to b, with its direction at b, in letters or else in words."""

    a: complex
    b: complex
    label: str = ""
    said: Words | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Swing(Done):
    """Leave a compass arc: from angle `start` over `sweep` (rad; 2π: a whole circle)."""

    centre: complex
    radius: float
    start: float
    sweep: float
    role: Role = Role.CONSTRUCTION


@dataclass(frozen=True, slots=True, kw_only=True)
class Curve(Done):
    """Lead a smooth curve through points with the French curve."""

    points: tuple[complex, ...]
    role: Role


@dataclass(frozen=True, slots=True, kw_only=True)
class Corner(Done):
    """Mark a right angle between the directions u and v."""

    at: complex
    u: complex
    v: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Angle(Done):
    """Mark an angle (key) with its symbol: from the direction `start` over `sweep` (rad)."""

    at: complex
    radius: float
    start: float
    sweep: float
    label: str


@dataclass(frozen=True, slots=True, kw_only=True)
class CurvedArrow(Done):
    """Draw a turning quantity (key), ω or a moment, as a curved arrow about a point; start: direction of its foot."""

    at: complex
    radius: float
    start: float
    ccw: bool
    label: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Annotate(Done):
    """Write a short note beside a point, on any side of it or on this one (0: any)."""

    at: complex
    words: Words
    side: complex = 0j


@dataclass(frozen=True, slots=True, kw_only=True)
class Tint(Done):
    """Tint the image of a link."""

    points: tuple[complex, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Hatch(Done):
    """Hatch an area, rising to the right where it is a surplus, falling where it is a deficit."""

    points: tuple[complex, ...]
    rising: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Depict(Done):
    """Draw the symbol of a link, a joint, a body: its owner's."""

    marks: tuple[Mark, ...]
