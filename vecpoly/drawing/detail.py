"""A knot of a polygon drawn apart: circled and numbered Ⅰ where it is, enlarged beside it (局部放大图)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
import shapely

from ..board.construction import Figure
from ..board.paper.extent import extent
from ..board.paper.marks import Arc, Dot, ImageOf, Mark, Point, RightAngle, Role, Segment, Vector
from ..words import Words
from .symbols.shapes import circle

KNOTTED = 4  # letters that make a knot where they stand this close:
CLOSE, WIDEST = 1.0, 8.0  # mm of radius a letter, mm of radius at most
APART = 0.05  # mm: letters at one place share a label
LARGE = 40.0  # mm: a polygon smaller than this is small altogether
ROUND = 2.2  # mm between the knot and the circle about it
FULL = 58.0  # mm across that a detail should be at most
FACTORS = (10.0, 8.0, 5.0, 4.0, 3.0, 2.5)
NAME = "Ⅰ"


@dataclass(frozen=True, slots=True)
class Knot:
    """A circle about crowded points, and how many times it is to be enlarged."""

    centre: complex
    radius: float
    factor: float

    def holds(self, at: complex) -> bool:
        """Whether a point lies within."""
        return abs(at - self.centre) <= self.radius

    def moved(self, at: complex) -> complex:
        """A point as it lies in the detail."""
        return (at - self.centre) * self.factor


def detailed(figure: Figure) -> tuple[Figure, ...]:
    """The figure with its knot circled and left without letters, and the detail that has them;
    the figure alone where it has no knot."""
    knot = find_knot(figure)
    if knot is None:
        return (figure,)
    out = knot.centre + (knot.radius + 0.1) * _outwards(figure, knot)
    marks = [_unlettered(mark, knot) for mark in figure.marks]
    around = (
        Arc(centre=knot.centre, radius=knot.radius, start=0.0, sweep=2 * math.pi, role=Role.CONSTRUCTION),
        Point(at=out, label=NAME, dot=Dot.NONE),
    )
    title = Words(f"局部放大图 {NAME}（{knot.factor:g}:1）", f"Detail {NAME} ({knot.factor:g}:1)")
    ring = Arc(centre=0j, radius=knot.radius * knot.factor, start=0.0, sweep=2 * math.pi, role=Role.CONSTRUCTION)
    inner = tuple(found for mark in figure.marks if (found := _within(mark, knot)) is not None)
    scale = replace(figure.scale, value=figure.scale.value / knot.factor)
    return (
        replace(figure, marks=(*marks, *around)),
        replace(
            figure, title=title, scale=scale, marks=(*inner, ring), name=f"{figure.name} detail".strip(), aside=False
        ),
    )


def find_knot(figure: Figure) -> Knot | None:
    """The smallest circle about the most letters that stand too close in a velocity or acceleration polygon."""
    places = _places(figure)
    if not figure.view.images or len(places) < KNOTTED or max(extent(figure.marks)) < LARGE:
        return None
    best: tuple[int, float, complex] | None = None
    for some in _crowds(places):
        ring = shapely.minimum_bounding_circle(shapely.multipoints(np.array([(z.real, z.imag) for z in some])))
        n, radius = len(some), float(shapely.minimum_bounding_radius(ring))
        if radius <= min(CLOSE * n, WIDEST) and (best is None or (-n, radius) < (-best[0], best[1])):
            best = (n, radius, complex(ring.centroid.x, ring.centroid.y))
    if best is None:
        return None
    radius = best[1] + ROUND
    factor = next((k for k in FACTORS if 2 * radius * k <= FULL), None)
    return None if factor is None else Knot(best[2], radius, factor)


def _crowds(places: list[complex]) -> Iterator[list[complex]]:
    """About each letter the nearest few, where these may lie in a circle as small as a knot is."""
    for at in places:
        order = sorted(places, key=lambda z: abs(z - at))
        for n in range(KNOTTED, len(order) + 1):
            across = abs(order[n - 1] - at)  # no circle that holds both is smaller
            if across > 2 * WIDEST + APART:
                break
            if across <= 2 * CLOSE * n + APART:
                yield order[:n]


def _places(figure: Figure) -> list[complex]:
    found: list[complex] = []
    for mark in figure.marks:
        if (
            isinstance(mark, Point)
            and mark.label
            and mark.dot is not Dot.NONE
            and all(abs(mark.at - z) > APART for z in found)
        ):
            found.append(mark.at)
    return found


def _outwards(figure: Figure, knot: Knot) -> complex:
    """The direction from the knot in which the figure has least."""
    ways = np.exp(2j * np.pi * np.arange(16) / 16)
    seen = [
        complex(z) - knot.centre
        for m in figure.marks
        if isinstance(m, Vector | Segment)
        for z in np.linspace(m.a, m.b, 12)
        if not knot.holds(complex(z))
    ]
    near = [z / abs(z) for z in seen if abs(z) < 4 * knot.radius]
    return complex(max(ways, key=lambda w: min((abs(w - z) for z in near), default=0.0)))


def _unlettered(mark: Mark, knot: Knot) -> Mark:
    """A mark of the figure itself:
    within the knot, and at the ends of its direction lines, the letters stand in the detail."""
    if isinstance(mark, Point) and (
        knot.holds(mark.at) or (mark.dot is Dot.NONE and abs(mark.at - knot.centre) < knot.radius + 2.0)
    ):
        return replace(mark, label="")
    return mark


def _within(mark: Mark, knot: Knot) -> Mark | None:
    """A mark as the detail shows it; none where it lies outside."""
    match mark:
        case Point(at=at):
            if knot.holds(at):
                return replace(mark, at=knot.moved(at))
            reached = mark.dot is Dot.NONE and mark.label and abs(at - knot.centre) < knot.radius + 2.0
            return (
                replace(mark, at=(at - knot.centre) / abs(at - knot.centre) * knot.radius * knot.factor)
                if reached
                else None
            )
        case Segment(a=a, b=b) | Vector(a=a, b=b):
            return _clipped(mark, a, b, knot)
        case RightAngle(at=at):
            return replace(mark, at=knot.moved(at)) if knot.holds(at) else None
        case ImageOf(points=points):
            disc = shapely.Polygon([(z.real, z.imag) for z in circle(knot.centre, knot.radius)])
            part = (
                shapely.Polygon([(z.real, z.imag) for z in points]).buffer(0).intersection(disc)
                if len(points) > 2
                else shapely.Polygon()
            )
            if not isinstance(part, shapely.Polygon) or part.is_empty:
                return None
            return replace(mark, points=tuple(knot.moved(complex(x, y)) for x, y in part.exterior.coords[:-1]))
        case _:
            return None


def _clipped(mark: Segment | Vector, a: complex, b: complex, knot: Knot) -> Mark | None:
    """The part of a line within the circle; an arrow whose tip lies beyond has no head here."""
    d, f = b - a, a - knot.centre
    length = abs(d)
    if length < APART:
        return None
    half = (f * d.conjugate()).real / length
    root = half**2 - abs(f) ** 2 + knot.radius**2
    if root <= 0:
        return None
    low, high = max(0.0, (-half - math.sqrt(root)) / length), min(1.0, (-half + math.sqrt(root)) / length)
    if low >= high:
        return None
    p, q = knot.moved(a + low * d), knot.moved(a + high * d)
    if isinstance(mark, Vector) and high < 1.0:
        return Segment(a=p, b=q, role=mark.role, step=mark.step, key=mark.key)
    return replace(mark, a=p, b=q)
