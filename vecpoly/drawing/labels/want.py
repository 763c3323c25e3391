"""A label before it has a place: its type, what it names, and beside what it may stand."""

from __future__ import annotations

from dataclasses import field
from enum import Enum

from ...foundation.slotted import dataclass, replace
from ...typeset import Box, Glyphs
from ..style import Hue

Spot = tuple[complex, float]  # a place, and the radius of what is drawn there
Line = tuple[complex, complex]  # from end to end


@dataclass(frozen=True, slots=True)
class Piece:
    """Type that belongs to one step, at an offset from the left of its label."""

    box: Box
    dx: float
    hue: Hue
    step: int


class Thing(Enum):
    """What a label can be taken to name when it stands beside it."""

    OTHER, POINT, LINK, VECTOR, END, DIRECTION, ARC, ACTION = range(8)


BREAKING = frozenset(
    (Thing.POINT, Thing.LINK, Thing.ARC)
)  # a name of a line would be taken for that of the one it breaks


@dataclass(frozen=True, slots=True)
class Want:
    """A label to be placed beside points of a curve: each with a normal (0: all directions) and a radius to keep."""

    pieces: tuple[Piece, ...]
    feet: tuple[complex, ...]
    normals: tuple[complex, ...]  # unit vectors to one side; 0j where every direction will do
    radius: float
    own: tuple[complex, complex]  # the line, or the place, that it names
    one_sided: bool = False
    clear: float = 0.0  # mm of white that it keeps beyond the radius, where it needs no leader
    thing: Thing = Thing.OTHER
    farther: bool = False  # whether its leader may be longer than is usual: a crowd leaves it no other place
    level: bool = False  # whether it stands on one line with its like, as the numbers of an axis do
    bow: tuple[complex, ...] = ()  # of an arc's label the arc, by points
    brief: tuple[Piece, ...] = ()  # what it says where it finds no place so long: the symbol without its value

    width: float = field(init=False)  # of the whole label, mm
    ascent: float = field(init=False)  # over the baseline, mm
    height: float = field(init=False)  # of the whole label, mm

    def __post_init__(self) -> None:
        ascent = max(p.box.ascent for p in self.pieces)
        object.__setattr__(self, "width", max(p.dx + p.box.width for p in self.pieces))
        object.__setattr__(self, "ascent", ascent)
        object.__setattr__(self, "height", ascent + max(p.box.descent for p in self.pieces))

    @property
    def in_brief(self) -> Want:
        """The label where it says less."""
        return replace(self, pieces=self.brief, brief=())

    @property
    def is_number(self) -> bool:
        """Whether it is a number, as of a series."""
        return all(isinstance(one, Glyphs) and one.text.isdigit() for piece in self.pieces for one in piece.box.items)

    @property
    def course(self) -> tuple[complex, ...]:
        """The line that it names, by points."""
        return self.bow or self.own


def resized(want: Want, factor: float) -> Want:
    """The label in type of another size, as a screen may want it."""
    if factor == 1.0:
        return want
    pieces = tuple(replace(p, box=_scaled(p.box, factor), dx=p.dx * factor) for p in want.pieces)
    return replace(want, pieces=pieces)


def _scaled(box: Box, k: float) -> Box:
    from ...typeset import Rule

    items: list[Glyphs | Rule] = []
    for item in box.items:
        match item:
            case Glyphs(font, size, x, y, text):
                items.append(Glyphs(font, size * k, x * k, y * k, text))
            case Rule(x, y, width, height):
                items.append(Rule(x * k, y * k, width * k, height * k))
    return Box(box.width * k, box.ascent * k, box.descent * k, tuple(items))
