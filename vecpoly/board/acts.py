"""What a hand does at a board: a closed list of acts, each done at once and remembered for ever.

An act knows its number on the sheet, the step that it belongs to, the acts that it needed (`inputs`), the figure it was
done on (`place`), what it stands for (`key`: a letter, the letters of a measured length, or the key of a quantity) and
whose it is (`owner`: a link, a joint).
Points, directions and lengths are those of the nominal sheet, in mm on the figure (x right, y up).
"""

from __future__ import annotations

from dataclasses import dataclass

from .paper.marks import Dot, Mark, Role
from .place import Place, called, named


@dataclass(frozen=True, slots=True, kw_only=True)
class Head:
    """What every act knows of itself."""

    number: int
    step: int
    inputs: tuple[int, ...] = ()
    place: Place | None = None
    key: str = ""
    owner: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Done:
    """An act: what it is and what it gave is told by its kind."""

    head: Head

    @property
    def number(self) -> int:
        """Its number on the sheet."""
        return self.head.number

    @property
    def key(self) -> str:
        """What it stands for."""
        return self.head.key

    @property
    def figure(self) -> str:
        """The figure it was done on: ``velocity``, ``force 23``."""
        return "" if self.head.place is None else called(self.head.place)

    @property
    def names(self) -> tuple[str, ...]:
        """Its key with the figure before it, ``velocity:bc``, and alone; none where it stands for nothing."""
        return named(self.head.place, self.key) if self.key else ()

    @property
    def inputs(self) -> tuple[int, ...]:
        """The numbers of the acts that it needed."""
        return self.head.inputs


@dataclass(frozen=True, slots=True, kw_only=True)
class Locate(Done):
    """A point has been found, and has its letter (key) from now on."""

    at: complex


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

    a: complex
    b: complex
    role: Role
    label: str = ""
    shown: bool = True  # a vector whose ends coincide, or which stands there already, leaves no ink


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
class Rule(Done):
    """Leave a direction line on the paper, from a to b, with its direction in letters at b."""

    a: complex
    b: complex
    label: str = ""


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
class Swing(Done):
    """Leave a compass arc: from angle `start` over `sweep` (rad, 2π: a whole circle)."""

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
class Meet(Done):
    """Where two lines, a line and an arc, or two arcs meet; other: the second meeting, which was not taken."""

    at: complex
    other: complex | None = None


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
class Corner(Done):
    """Mark a right angle between the directions u and v."""

    at: complex
    u: complex
    v: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Tint(Done):
    """Tint the image of a link."""

    points: tuple[complex, ...]


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


@dataclass(frozen=True, slots=True, kw_only=True)
class Depict(Done):
    """Draw the symbols of links, joints, loads, bodies."""

    marks: tuple[Mark, ...]


Leaving = Plot | Join | Arrow | Rule | Swing | Curve | Corner | Tint | Depict  # ink
Inkless = (
    Locate | Turn | Parallel | LayOff | Follow | Transfer | Meet | Touch | Image | Measure | Gauge | Compute | Answer
)
Act = Leaving | Inkless
