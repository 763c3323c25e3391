"""An angle has two rays: where no line runs from its vertex to an end of its arc, a centre line is drawn."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator
from itertools import pairwise

from ..board.construction import View
from ..board.paper.marks import AngleMark, Mark, Outline, Plate, Role, Segment, Vector
from .symbols.shapes import NEAR

BESIDE, SHORT = 0.4, 1.0  # mm beside the end of an arc, and short of it, that a line may run
ALONG = 0.05  # rad between a ray and a line that stands for it
BEYOND = 3.5  # mm from the arc to the end of its ray


def rayed(view: View, marks: tuple[Mark, ...]) -> tuple[Mark, ...]:
    """The marks of a figure with the rays that its angles lack; about a body friction angles lean on its normals."""
    angles = [mark for mark in marks if isinstance(mark, AngleMark) and mark.radius > SHORT]
    if view is View.BODY or not angles:
        return marks
    lines = [*_lines(marks)]
    return (*marks, *(ray for angle in angles for ray in _missing(angle, lines)))


def _missing(angle: AngleMark, lines: list[tuple[complex, complex]]) -> Iterator[Segment]:
    for way in (angle.start, angle.start + angle.sweep):
        end = angle.at + cmath.rect(angle.radius, way)
        if not any(_runs_to(end, way, a, b) for a, b in lines):
            tip = angle.at + cmath.rect(angle.radius + BEYOND, way)
            yield Segment(a=angle.at, b=tip, role=Role.CENTRE, step=angle.step)


def _runs_to(spot: complex, way: float, a: complex, b: complex) -> bool:
    """Whether a line of this direction runs by a place, or ends just short of it; what only crosses there is no ray."""
    turned = (b - a) / abs(b - a) * cmath.rect(1.0, -way)
    off = (spot - a) * ((b - a) / abs(b - a)).conjugate()
    return abs(turned.imag) < ALONG and abs(off.imag) < BESIDE and -SHORT < off.real < abs(b - a) + SHORT


def _lines(marks: Iterable[Mark]) -> Iterator[tuple[complex, complex]]:
    for mark in marks:
        match mark:
            case Segment(a=a, b=b) | Vector(a=a, b=b) if abs(b - a) > NEAR:
                yield a, b
            case Plate(points=points) | Outline(points=points) if len(points) > 1:
                yield from ((a, b) for a, b in pairwise((*points, points[0])) if abs(b - a) > NEAR)
            case _:
                pass
