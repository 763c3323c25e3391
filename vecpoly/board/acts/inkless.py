"""Acts that find, read and compute; what they give is used, and leaves no ink."""

from __future__ import annotations

from ...foundation.slotted import dataclass
from .base import Done


@dataclass(frozen=True, slots=True, kw_only=True)
class Locate(Done):
    """A point has been found, and has its letter (key) from now on."""

    at: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Turn(Done):
    """Carry a direction to another place with the set square: the unit vector `along`."""

    along: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Parallel(Done):
    """Rule a line through a point parallel, or perpendicular, to a drawn direction."""

    at: complex
    along: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Ray(Done):
    """Set out a line through a point at an angle from a drawn direction, by protractor."""

    at: complex
    along: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class LayOff(Done):
    """Lay off a length (mm) from a point in a direction."""

    start: complex
    at: complex
    mm: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Follow(Done):
    """Go along a vector (key) that stands on the polygon already."""

    by: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Transfer(Done):
    """Carry a length, or a whole vector, to another place with the dividers."""

    by: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Meet(Done):
    """Where two lines, a line and an arc, or two arcs meet; other: the second meeting, which was not taken.

    angle: at which an arc crosses the other arc, or the line (rad, to a right angle).
    """

    at: complex
    other: complex | None = None
    angle: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Touch(Done):
    """A line of action (key: its force) that touches one friction circle, or two;
    free: there is no circle, the radius is zero."""

    along: complex
    free: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Image(Done):
    """The third corner of a similar figure with the same letter order."""

    at: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Measure(Done):
    """Read a length (key: its letters) off the rule."""

    a: complex
    b: complex
    mm: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Gauge(Done):
    """Read a direction off the protractor (rad)."""

    angle: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Compute(Done):
    """Symbol = formula = numbers = result."""

    value: float
    unit: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Answer(Done):
    """Write down what was found of a quantity (key): the value in SI units, of a vector x + iy."""

    value: complex
    unit: str
