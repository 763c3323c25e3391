"""The circle through the places of a pin, and the point of a line at one distance from two of them.

All by linear equations: |Q − P_i|² is one value, so 2 Re((P_i − P_1)* Q) = |P_i|² − |P_1|².
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

_STRAIGHT = 1e-9  # sine below which three places lie on a line
_PARALLEL = 1e-9  # sine below which a bisector does not meet a line
_ONE = 1e-9  # of the size of the figure: places nearer than this are one


@dataclass(frozen=True, slots=True, kw_only=True)
class Round:
    """The places lie on one circle (m)."""

    centre: complex
    radius: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Straight:
    """The places lie on a straight line: the centre is at infinity."""

    through: complex
    along: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Still:
    """At least two of the places are one place: a circle about any point of a line, or of the plane, goes through."""

    at: complex


Locus = Round | Straight | Still


def locus(places: Sequence[complex]) -> Locus:
    """What three places lie on."""
    one, two, three = places
    sides = (abs(two - one), abs(three - two), abs(one - three))
    if min(sides) <= _ONE * max(*sides, abs(one)):
        return Still(at=one)
    if _sine(one, two, three) < _STRAIGHT:
        return Straight(through=one, along=(three - one) / abs(three - one))
    centre = one + _solved(two - one, three - one)
    return Round(centre=centre, radius=abs(centre - one))


def _sine(one: complex, two: complex, three: complex) -> float:
    """How far the flattest triangle of the three is from a line."""
    u, v = two - one, three - one
    return abs((u.conjugate() * v).imag) / max(abs(u) * abs(v), abs(u) * abs(v - u), abs(v) * abs(v - u))


def _solved(u: complex, v: complex) -> complex:
    """q with 2 Re(u* q) = |u|² and 2 Re(v* q) = |v|²."""
    x, y = np.linalg.solve([[2 * u.real, 2 * u.imag], [2 * v.real, 2 * v.imag]], [abs(u) ** 2, abs(v) ** 2])
    return complex(x, y)


def equidistant(one: complex, two: complex, through: complex, along: complex) -> complex | None:
    """The point through + t along of a line that has one distance from both places:

    t = Re((P2 − P1)* ((P1 + P2)/2 − through)) / Re((P2 − P1)* along); none where the line is parallel to the bisector,
    or where both places are one.
    """
    span = two - one
    slope = (span.conjugate() * along).real
    if abs(slope) <= _PARALLEL * abs(span) * abs(along):
        return None
    return through + along * (span.conjugate() * ((one + two) / 2 - through)).real / slope
