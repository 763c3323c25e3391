"""How the hand sets out a link's further points: by two lengths, by offsets, by an angle; and on which side."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Side(StrEnum):
    """Where a point lies, in a lecturer's words."""

    LEFT = "left"
    RIGHT = "right"
    ABOVE = "above"
    BELOW = "below"


@dataclass(frozen=True, slots=True, kw_only=True)
class ByLengths:
    """The point is the apex of a triangle on the base: distances from both base points, and the side."""

    point: str
    base: tuple[str, str]
    lengths: tuple[float, float]
    side: Side  # LEFT or RIGHT of the ray base[0] -> base[1]


@dataclass(frozen=True, slots=True, kw_only=True)
class ByOffsets:
    """The point lies `along` the ray base[0] -> base[1] from base[0], then `left` perpendicular to it.

    With a single-letter base (a link with one point and a guide) the ray is the guide's direction.
    """

    point: str
    base: tuple[str, ...]
    along: float
    left: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class ByAngle:
    """The point lies at `distance` from base[0], at `angle` counter-clockwise from base[0] -> base[1] (or the guide)."""

    point: str
    base: tuple[str, ...]
    distance: float
    angle: float


Placement = ByLengths | ByOffsets | ByAngle
