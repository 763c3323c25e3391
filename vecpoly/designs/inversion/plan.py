"""What is known of a linkage that must go through given positions, and the pins that are sought, one after another.

A bar joins a known pin P of one body to the sought pin Q of another; in the eyes of Q's body, P goes round Q. All the
textbook's tasks are chains of this one step: positions of a coupler (Q on the frame, or on the coupler), pairs of
angles (Q on the rocker), a rocker and a slider, six-bars. Lengths in m, angles in rad, x right and y up.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum

from ...words import Words
from .loops import Loop, sides

FRAME = ""  # the name of the body that stands still


@dataclass(frozen=True, slots=True, kw_only=True)
class Position:
    """Where the origin of a body lies, and how far the body is turned."""

    at: complex = 0j
    angle: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Body:
    """A link in its positions; pivot: the fixed pin that it turns about, where it has one.

    Its name is the letters of its ray (AB: from A, along the angle of its position), or the letter of a plane (S).
    symbol: of its directions where they are not told as φ_AB, φ_CD.
    """

    name: str
    positions: tuple[Position, ...]
    pivot: str = ""
    symbol: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Pin:
    """A point of a body, in the coordinates of this body; on the frame: a fixed pivot."""

    letter: str
    on: str
    at: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Slide:
    """A pin that is known by its places, all on a straight guide: the pin of a slider."""

    letter: str
    places: tuple[complex, ...]
    along: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class On:
    """A line of a body, in its coordinates; of a body that is a ray: its own line."""

    through: complex = 0j
    along: complex = 1 + 0j


@dataclass(frozen=True, slots=True, kw_only=True)
class Through:
    """The line through two pins as they lie in the position that is kept."""

    one: str
    two: str


Lies = On | Through


@dataclass(frozen=True, slots=True, kw_only=True)
class Find:
    """Seek the pin of a body that a bar joins to a known pin; of two positions, on a line.

    kept: in which position (from 0) the body stands still, and the others are laid onto it.
    """

    pin: str
    on: str
    known: str
    lies: Lies | None = None
    kept: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class Assemble:
    """A pin at given distances from two known ones, to the left (side 1) or right (−1) of the ray between them."""

    pin: str
    one: str
    to_one: float
    two: str
    to_two: float
    side: int


class Limit(Enum):
    """Which limit of a rocker is given, as one sees it."""

    LEFT = (-1, Words("左", "left"))
    RIGHT = (1, Words("右", "right"))

    @property
    def sense(self) -> int:
        """−1: the other limit lies to the right."""
        return int(self.value[0])

    @property
    def label(self) -> Words:
        """左 or right."""
        return self.value[1]


@dataclass(frozen=True, slots=True, kw_only=True)
class Limits:
    """The other limit of the pin of a rocker, whose crank turns 180° + θ in one stroke and 180° − θ in the other.

    of: the name of the rocker's body, which is known from here on; crank: the pin of the crank, about its pivot.
    """

    pin: str
    of: str
    pivot: str
    crank: str
    about: str
    theta: float
    first: complex
    limit: Limit


@dataclass(frozen=True, slots=True, kw_only=True)
class CentrePoints:
    """Of four positions: two bars (fixed pin, moving pin), whose fixed pins lie on given lines of the frame."""

    on: str
    one: tuple[str, str]
    two: tuple[str, str]
    lies: tuple[On, On]


Stage = Find | Assemble | Limits | CentrePoints


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """All that is given, the stages in their order, and the loops that come of it.

    either: whether the last link of a four-bar may drive it as well as the first.
    """

    count: int
    either: bool = False
    bodies: tuple[Body, ...] = ()
    pins: tuple[Pin, ...] = ()
    slides: tuple[Slide, ...] = ()
    stages: tuple[Stage, ...]
    loops: tuple[Loop, ...]

    def body(self, name: str) -> Body:
        """The body of this name; the frame stands still."""
        still = Body(name=FRAME, positions=(Position(),) * self.count)
        return next((body for body in self.bodies if body.name == name), still)

    def turns(self, name: str) -> bool:
        """Whether a link turns about a pivot of the frame."""
        limits = any(isinstance(stage, Limits) and stage.of == name for stage in self.stages)
        return limits or self.body(name).pivot != ""

    @property
    def extent(self) -> float:
        """How far what is given reaches (m)."""
        places = [one.at for one in self.pins if one.on == FRAME]
        places += [at for slide in self.slides for at in slide.places]
        places += [position.at for body in self.bodies for position in body.positions]
        places += [stage.first for stage in self.stages if isinstance(stage, Limits)]
        arms = [abs(one.at) for one in self.pins if one.on != FRAME]
        return max(1e-3, *(abs(at - places[0]) for at in places), *arms)

    @property
    def sought(self) -> tuple[str, ...]:
        """The letters of all pins that are found."""
        return tuple(letter for stage in self.stages for letter in _sought(stage))

    @property
    def known(self) -> tuple[str, ...]:
        """The letters of all pins that are given."""
        return (*(pin.letter for pin in self.pins), *(slide.letter for slide in self.slides))

    @property
    def given_bars(self) -> Mapping[frozenset[str], float]:
        """The lengths that are known beforehand (m): between two pins of one body, and of links to be joined."""
        ends = [*self.pins, *(Pin(letter=body.pivot, on=body.name, at=0j) for body in self.bodies if body.pivot)]
        known = {
            frozenset((one.letter, two.letter)): abs(one.at - two.at)
            for one in ends
            for two in ends
            if one.on == two.on and one.letter != two.letter
        }
        joined = (stage for stage in self.stages if isinstance(stage, Assemble))
        for stage in joined:
            known[frozenset((stage.pin, stage.one))] = stage.to_one
            known[frozenset((stage.pin, stage.two))] = stage.to_two
        return known

    def bars(self) -> Iterator[tuple[str, str]]:
        """The letters of the links whose lengths are found, loop by loop, each once."""
        seen: set[frozenset[str]] = set()
        for loop in self.loops:
            for one, two in sides(loop):
                if frozenset((one, two)) not in seen:
                    seen.add(frozenset((one, two)))
                    yield one, two


def _sought(stage: Stage) -> tuple[str, ...]:
    match stage:
        case CentrePoints():
            return (*stage.one, *stage.two)
        case Limits():
            return stage.pin, stage.crank
        case _:
            return (stage.pin,)
