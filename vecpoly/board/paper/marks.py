"""What a hand leaves on the paper:
a closed list of marks, in mm on the figure (x right, y up, origin where the figure has it).

Marks follow from acts (`ink`). Drawing code reads marks and nothing else.
"""

from __future__ import annotations

from math import radians

from ...foundation.slotted import dataclass
from ...words import Words
from .bodies import Block as Block
from .bodies import Body as Body
from .bodies import FixedGuide as FixedGuide
from .bodies import GearMark as GearMark
from .bodies import Ground as Ground
from .bodies import Passing as Passing
from .bodies import Plate as Plate
from .bodies import RackMark as RackMark
from .bodies import Slot as Slot
from .bodies import Weld as Weld
from .known import Ink as Ink
from .roles import Dot as Dot
from .roles import Lump as Lump
from .roles import Role as Role


@dataclass(frozen=True, slots=True, kw_only=True)
class Segment(Ink):
    """A straight line."""

    a: complex
    b: complex
    role: Role


@dataclass(frozen=True, slots=True, kw_only=True)
class Vector(Ink):
    """A line with an arrowhead at b, and the symbol of what it stands for (empty: no label)."""

    a: complex
    b: complex
    role: Role
    label: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Arc(Ink):
    """A compass stroke: from angle `start` over `sweep` (rad, 2π: a full circle)."""

    centre: complex
    radius: float
    start: float
    sweep: float
    role: Role


@dataclass(frozen=True, slots=True, kw_only=True)
class Curve(Ink):
    """A smooth curve, by points so close that their chords look round."""

    points: tuple[complex, ...]
    role: Role


@dataclass(frozen=True, slots=True, kw_only=True)
class Point(Ink):
    """A lettered point; said: what stands there in words, where there are no letters for it."""

    at: complex
    label: str
    dot: Dot
    said: Words | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class RightAngle(Ink):
    """The square in a right angle at `at` between the directions u and v (unit complex numbers)."""

    at: complex
    u: complex
    v: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class ImageOf(Ink):
    """The image of a link in a polygon, lightly tinted."""

    points: tuple[complex, ...]


TURN = radians(105)  # sweep of a curved arrow


@dataclass(frozen=True, slots=True, kw_only=True)
class TurnArrow(Ink):
    """A curved arrow about `at` with a symbol: the driving arrow with ω, or the sense found for a link."""

    at: complex
    radius: float
    start: float
    ccw: bool
    label: str


@dataclass(frozen=True, slots=True, kw_only=True)
class AngleMark(Ink):
    """An angle at `at` from `start` over `sweep` (rad) with its symbol."""

    at: complex
    radius: float
    start: float
    sweep: float
    label: str


@dataclass(frozen=True, slots=True, kw_only=True)
class LinkNumber(Ink):
    """The number of a link, set beside the line from a to b (or beside the point a = b)."""

    a: complex
    b: complex
    number: str


@dataclass(frozen=True, slots=True, kw_only=True)
class FrictionCircle(Ink):
    """The friction circle of a pin, dashed, radius ρ/μ_l in mm; `enlarged` > 1 where it is drawn larger to be seen."""

    centre: complex
    radius: float
    label: str = ""
    enlarged: float = 1.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Disc(Ink):
    """A round cam, eccentric or tip: its profile, full line, lightly tinted; or a mass at its centre."""

    centre: complex
    radius: float
    lump: Lump = Lump.NONE


@dataclass(frozen=True, slots=True, kw_only=True)
class Outline(Ink):
    """The outline of a solid body (a wedge, a slide, a nut); `fixed` bodies are hatched."""

    points: tuple[complex, ...]
    fixed: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Hatched(Ink):
    """An area between lines that are drawn already, hatched: rising to the right, or falling."""

    points: tuple[complex, ...]
    rising: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Cell(Ink):
    """A box of a block diagram (a machine of a train) with words in it."""

    at: complex
    width: float
    height: float
    words: Words


@dataclass(frozen=True, slots=True, kw_only=True)
class Note(Ink):
    """A short note in small lettering beside a point; side: on which it stands, of a number on an axis (0: any)."""

    at: complex
    words: Words
    side: complex = 0j


Trace = Segment | Vector | Arc | Curve
Solid = FrictionCircle | Disc | Outline | Hatched | Cell
Mark = Trace | Point | RightAngle | ImageOf | Body | TurnArrow | AngleMark | LinkNumber | Solid | Note


def words_of(mark: Mark) -> Words | None:
    """What stands there in words, if anything does."""
    match mark:
        case Note() | Cell():
            return mark.words
        case Point():
            return mark.said
        case _:
            return None
