"""Points, lines, circles and their meetings, elementwise.

A point is `complex` or a complex array of shape (n,): the same construction by n hands. Nothing here raises for
a meeting that does not exist: it gives NaN, and the board, which knows the letters, says what failed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import atan2, pi
from typing import Any

import numpy as np
import numpy.typing as npt

from .traced import Traced

Points = complex | npt.NDArray[Any]
Reals = float | npt.NDArray[Any]


@dataclass(frozen=True, slots=True)
class Line:
    """An endless line through `at` in the direction of the unit vector `along`."""

    at: Points
    along: Points


def nominal(value: Any) -> Any:
    """The nominal hand's value, alone: element 0 of an array, the number itself otherwise."""
    value = value.value if type(value) is Traced else value
    return value[0] if isinstance(value, np.ndarray) and value.ndim else value


def unit(vector: Points) -> Points:
    """The vector divided by its length."""
    return vector / np.abs(vector)


def dot(u: Points, v: Points) -> Reals:
    """u · v."""
    return (np.conj(u) * v).real


def cross(u: Points, v: Points) -> Reals:
    """u × v, positive when v lies to the left of u."""
    return (np.conj(u) * v).imag


def ahead(p: Points, way: Points, by: Reals) -> Points:
    """The point that lies so far from p in this direction: p + by · way."""
    return p + way * by


def distance(p: Points, q: Points) -> Reals:
    """|q − p|."""
    return np.abs(q - p)


def shoelace(outline: Sequence[Points]) -> Reals:
    """The area of a polygon by its corners, positive where they run counter-clockwise."""
    first, *others = outline
    return 0.5 * sum((cross(a - first, b - first) for a, b in pairwise(others)), 0.0 * distance(first, first))


def around(outline: Sequence[Points]) -> Reals:
    """The length of its perimeter."""
    return sum((distance(a, b) for a, b in pairwise((*outline, outline[0]))), 0.0 * distance(outline[0], outline[0]))


def foot(line: Line, p: Points) -> Points:
    """Foot of the perpendicular from p to the line."""
    return ahead(line.at, line.along, dot(line.along, p - line.at))


def lines_meet(g: Line, h: Line) -> Points:
    """Meeting point of two lines; NaN where they are parallel."""
    sine = cross(g.along, h.along)
    with np.errstate(divide="ignore", invalid="ignore"):
        t = np.divide(cross(h.at - g.at, h.along), sine)
        return ahead(g.at, g.along, t)


def line_circle_meet(line: Line, centre: Points, radius: Reals) -> tuple[Points, Points]:
    """The two meeting points, the one further along the line first; NaN where the circle is not reached."""
    middle = foot(line, centre)
    with np.errstate(invalid="ignore"):
        half = np.sqrt(np.square(radius) - np.square(np.abs(middle - centre)))
    return ahead(middle, line.along, half), ahead(middle, line.along, -half)


def circles_meet(c1: Points, r1: Reals, c2: Points, r2: Reals) -> tuple[Points, Points]:
    """The two meeting points, the one to the left of the ray c1 → c2 first; NaN where the arcs do not meet."""
    span = c2 - c1
    d2 = np.square(np.abs(span))
    with np.errstate(divide="ignore", invalid="ignore"):
        along = np.divide(d2 + np.square(r1) - np.square(r2), 2 * d2)
        across = np.sqrt(np.divide(np.square(r1), d2) - np.square(along))
    return c1 + span * (along + 1j * across), c1 + span * (along - 1j * across)


def similar(a: Points, b: Points, c: Points, a1: Points, b1: Points) -> Points:
    """The point c1 for which a1 b1 c1 is similar to a b c in the same letter order."""
    return a1 + (c - a) / (b - a) * (b1 - a1)


def turned_over(a: Points, b: Points, c: Points, a1: Points, b1: Points) -> Points:
    """The point c1 for which a1 b1 c1 is similar to a b c in the reversed letter order."""
    return a1 + np.conj((c - a) / (b - a)) * (b1 - a1)


def inclined(axis: Points, sine: Reals) -> tuple[Points, Points]:
    """The two unit vectors u that make an angle of this sine with a vector, axis × u = |axis| sine:
    ahead, and behind; else NaN."""
    with np.errstate(invalid="ignore"):
        cosine = np.sqrt(1 - np.square(sine))
    return unit(axis) * (cosine + 1j * sine), unit(axis) * (1j * sine - cosine)


def crossing(one: complex, other: complex) -> float:
    """The angle between two radii, or lines, at which what belongs to them crosses (rad, to a right angle)."""
    turned = one.conjugate() * other
    return atan2(abs(turned.imag), abs(turned.real)) if turned else pi / 2


def nearest_between(a: complex, b: complex, p: complex) -> complex:
    """The place between two points that is nearest to a third."""
    along = b - a
    share = ((p - a) / along).real if along else 0.0
    return a + min(1.0, max(0.0, share)) * along
