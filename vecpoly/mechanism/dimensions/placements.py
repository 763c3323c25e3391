"""How the hand sets out a link's further points: by two lengths, by offsets, by an angle; and on which side."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from enum import StrEnum
from math import nan

from ...foundation.slotted import dataclass


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
    """The point lies at `distance` from base[0],
    at `angle` counter-clockwise from base[0] -> base[1] (or the guide)."""

    point: str
    base: tuple[str, ...]
    distance: float
    angle: float


Placement = ByLengths | ByOffsets | ByAngle


def local(placement: Placement, points: Mapping[str, complex]) -> complex:
    """The placed point as seen along its base's ray (m); NaN where its triangle does not close."""
    match placement:
        case ByAngle():
            return cmath.rect(placement.distance, placement.angle)
        case ByOffsets():
            return complex(placement.along, placement.left)
        case ByLengths(base=(a, b), lengths=(p, q)):
            top = apex(abs(points[b] - points[a]), p, q)
            return top if placement.side is Side.LEFT else top.conjugate()


def apex(c: float, p: float, q: float) -> complex:
    """The apex left of a base of length c, at p and q from its ends, seen along the base; NaN where no triangle closes.

    x = (p² − q² + c²) / 2c, y = √(p² − x²).
    """
    x = (p * p - q * q + c * c) / (2 * c)
    square = p * p - x * x
    return complex(x, max(square, 0.0) ** 0.5) if square >= -1e-12 * c * c else complex(nan, nan)


def along(start: complex, end: complex) -> complex:
    """The unit vector from one point to another."""
    return cmath.exp(1j * cmath.phase(end - start))
