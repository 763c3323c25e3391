"""Which dimension of a mechanism is meant: a value that names one length, angle, place or drive."""

from __future__ import annotations

from enum import StrEnum

from ...foundation.slotted import dataclass


class Part(StrEnum):
    """Which number of several that set out one point, lead one guide or tell one drive."""

    DISTANCE = "distance"  # from the base's first letter (m)
    ANGLE = "angle"  # from the base's ray (rad)
    FIRST = "first"  # of two lengths (m), that from the base's first letter
    SECOND = "second"  # and that from its second
    ALONG = "along"  # the base's ray (m)
    LEFT = "left"  # of it (m)
    PLACE = "place"  # of a fixed guide: its x or y (m)
    DIRECTION = "direction"  # of a guide (rad)
    OFFSET = "offset"  # of the pin, to the left of the guide (m)
    TURN = "turn"  # of the block against the guide (rad)
    POSITION = "position"  # of a drive (rad, or m)
    RATE = "rate"  # rad/s, or m/s
    ACCEL = "accel"  # rad/s², or m/s²


ANGLES = (Part.ANGLE, Part.DIRECTION, Part.TURN)


@dataclass(frozen=True, slots=True, kw_only=True)
class Bar:
    """The distance of a link's first two points (m)."""

    link: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Placed:
    """A number that sets out a further point of a link, or several at one foot (`places`: which placements)."""

    link: str
    places: tuple[int, ...]
    part: Part


@dataclass(frozen=True, slots=True, kw_only=True)
class Coordinate:
    """A coordinate of a fixed point (m): axis "x" or "y"."""

    letter: str
    axis: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Led:
    """A number of a sliding pair, told by its place among the joints."""

    joint: int
    part: Part


@dataclass(frozen=True, slots=True, kw_only=True)
class Profile:
    """The radius (m) of a disc that touches, told by its link and the letter of its centre."""

    link: str
    centre: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Driven:
    """Position, rate or acceleration of a drive."""

    part: Part
    drive: int = 0


Dimension = Bar | Placed | Coordinate | Led | Profile | Driven
