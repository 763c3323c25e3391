"""What of a mark lies inside the ring of a detail, as many times larger; symbols and letters keep their size."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
import shapely

from ...board.construction import Figure
from ...board.paper.marks import (
    Arc,
    Block,
    Curve,
    Disc,
    Dot,
    FrictionCircle,
    Ground,
    ImageOf,
    Mark,
    Outline,
    Passing,
    Plate,
    Point,
    RightAngle,
    Role,
    Segment,
    Vector,
)
from ...board.paper.tones import key_of
from ...foundation.slotted import replace
from ..symbols.shapes import arc, circle
from .knot import Knot
from .knots import APART

ROOM = 3  # letters beside a ring
REACH = 2.0  # mm from the ring within which the letter at the end of a direction line stands on it
SYMBOL = 6.0  # mm that the symbol of a pivot or a block stands out from its place


def within(mark: Mark, knot: Knot) -> Iterator[Mark]:
    """A mark as the detail shows it; nothing where it lies outside."""
    match mark:
        case Point():
            yield from _point(mark, knot)
        case Segment(a=a, b=b) | Vector(a=a, b=b):
            yield from _line(mark, a, b, knot)
        case RightAngle(at=at) if knot.holds(at):
            yield replace(mark, at=knot.moved(at))
        case Ground(at=at) | Block(at=at) | Passing(at=at) if _clear(at, knot):
            yield replace(mark, at=knot.moved(at))
        case ImageOf(points=points):
            yield from _image(mark, points, knot)
        case Plate(points=points) | Outline(points=points):
            yield from _strokes(mark, (*points, points[0]), Role.LINK, knot)
        case Curve(points=points, role=role):
            yield from _strokes(mark, points, role, knot)
        case Arc(centre=centre, radius=radius, start=start, sweep=sweep, role=role):
            yield from _strokes(mark, arc(centre, radius, start, sweep), role, knot)
        case Disc(centre=centre, radius=radius):
            yield from _strokes(mark, arc(centre, radius, 0.0, 2 * math.pi), Role.LINK, knot)
        case FrictionCircle(centre=centre, radius=radius) if abs(centre - knot.centre) + radius <= knot.radius:
            yield replace(mark, centre=knot.moved(centre), radius=radius * knot.factor)
        case _:
            pass


def unlettered(mark: Mark, knot: Knot) -> Mark:
    """A mark of the figure itself: the letters of what lies in the knot, and at the ends of its direction lines, stand
    in the detail."""
    match mark:
        case Point(at=at, dot=dot) if knot.holds(at) or (dot is Dot.NONE and _reached(at, knot)):
            return replace(mark, label="")
        case Vector(a=a, b=b) if knot.holds(a) and knot.holds(b):
            return replace(mark, label="")
        case FrictionCircle(centre=centre, radius=radius) if abs(centre - knot.centre) + radius <= knot.radius:
            return replace(mark, label="")
        case _:
            return mark


def spoken(figure: Figure, knot: Knot) -> tuple[Point, ...]:
    """The letters of a knot that stay on the figure itself, so that it can be read without the detail: those of joints
    and of the pole first, then those of other points, of feet of normal components last. So many places alone as find
    room."""
    inside = [
        m for m in figure.marks if isinstance(m, Point) and m.label and m.dot is not Dot.NONE and knot.holds(m.at)
    ]
    places: list[complex] = []
    for one in sorted(inside, key=lambda one: (one.dot not in (Dot.JOINT, Dot.POLE), one.label.startswith("n"))):
        if all(abs(one.at - at) > APART for at in places):
            places.append(one.at)
    return tuple(one for one in inside if any(abs(one.at - at) <= APART for at in places[:ROOM]))


def _clear(at: complex, knot: Knot) -> bool:
    """Whether a symbol at this place stands inside the ring."""
    return abs(knot.moved(at)) + SYMBOL <= knot.radius * knot.factor


def _reached(at: complex, knot: Knot) -> bool:
    return abs(at - knot.centre) < knot.radius + REACH


def _point(mark: Point, knot: Knot) -> Iterator[Point]:
    off = mark.at - knot.centre
    if knot.holds(mark.at):
        yield replace(mark, at=knot.moved(mark.at))
    elif mark.dot is Dot.NONE and mark.label and _reached(mark.at, knot):
        yield replace(mark, at=off / abs(off) * knot.radius * knot.factor)


def _line(mark: Segment | Vector, a: complex, b: complex, knot: Knot) -> Iterator[Segment | Vector]:
    """The part of a line within the circle; an arrow whose tip lies beyond has no head here."""
    d, f = b - a, a - knot.centre
    length = abs(d)
    if length < APART:
        return
    half = (f * d.conjugate()).real / length
    root = half**2 - abs(f) ** 2 + knot.radius**2
    if root <= 0:
        return
    low, high = max(0.0, (-half - math.sqrt(root)) / length), min(1.0, (-half + math.sqrt(root)) / length)
    if low >= high:
        return
    p, q = knot.moved(a + low * d), knot.moved(a + high * d)
    if isinstance(mark, Vector) and high < 1.0:
        yield Segment(a=p, b=q, role=mark.role, step=mark.step, key=key_of(mark))
    else:
        yield replace(mark, a=p, b=q)


def _image(mark: ImageOf, points: tuple[complex, ...], knot: Knot) -> Iterator[ImageOf]:
    if len(points) < 3:
        return
    part = shapely.Polygon([(z.real, z.imag) for z in points]).buffer(0).intersection(_disc(knot))
    if isinstance(part, shapely.Polygon) and not part.is_empty:
        yield replace(mark, points=tuple(knot.moved(complex(x, y)) for x, y in part.exterior.coords[:-1]))


def _strokes(mark: Mark, points: tuple[complex, ...], role: Role, knot: Knot) -> Iterator[Curve]:
    """The pieces of a line of many points."""
    line = shapely.LineString([(z.real, z.imag) for z in points])
    for part in shapely.get_parts(line.intersection(_disc(knot))):
        if isinstance(part, shapely.LineString) and part.length > APART:
            at = np.array(part.coords) @ np.array([1, 1j])
            yield Curve(points=tuple(knot.moved(complex(z)) for z in at), role=role, step=mark.step, key=mark.key)


def _disc(knot: Knot) -> shapely.Polygon:
    return shapely.Polygon([(z.real, z.imag) for z in circle(knot.centre, knot.radius)])
