"""What lettering must keep clear of, and what it costs to stand on it:
numpy finds the pairs and clips lines, shapely knows areas.

The places for one label lie close together: of the pieces of a figure only those about them are looked at.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from ..scene import Fill, Item, Layer, Stroke, TextBox
from ..style import THIN
from .clipping import clip
from .ground import is_ground

Complexes = NDArray[np.complex128]
Floats = NDArray[np.float64]
Indices = NDArray[np.intp]
Own = tuple[Complexes, Complexes]  # of each place both ends of the line that its label names
Groups = Sequence[slice]  # which places lie close together: those of one label

GAP = 0.45  # mm between lettering and a line
ROOM = 1.1  # mm beyond which a neighbour no longer confuses
COARSE = 0.08  # mm sagitta that is fine enough for keeping clear
ON_LINE, PER_MM, NEARBY = 40.0, 6.0, 0.7
PARTED = 20.0  # a line between a label and what it names
BESIDE = 0.25  # mm off what is named: what lies nearer is part of it
ON_SOLID, ON_TINT = 90.0, 0.8
CROSSING, OVER_BAR, CROSSING_SOLID = 8.4, 14.0, 30.0  # a leader over a thin line, a thick one, an arrowhead or a joint


@dataclass(frozen=True, slots=True)
class Bounds:
    """The upright rectangles about many things."""

    x0: Floats
    y0: Floats
    x1: Floats
    y1: Floats

    @classmethod
    def between(cls, a: Complexes, b: Complexes) -> Bounds:
        """About straight lines a -> b."""
        return cls(
            np.minimum(a.real, b.real),
            np.minimum(a.imag, b.imag),
            np.maximum(a.real, b.real),
            np.maximum(a.imag, b.imag),
        )

    @classmethod
    def about(cls, centre: Complexes, width: Floats, height: Floats, by: float) -> Bounds:
        """About rectangles of one size, and `by` mm further out."""
        x, y, w, h = centre.real, centre.imag, width / 2 + by, height / 2 + by
        return cls(x - w, y - h, x + w, y + h)

    def over(self, other: Bounds, groups: Groups) -> tuple[Indices, Indices]:
        """The pairs (ours, theirs) that overlap; `groups`: which of ours lie close together."""
        found = [self._over(other, some) for some in groups if some.stop > some.start]
        if not found:
            return np.zeros(0, dtype=np.intp), np.zeros(0, dtype=np.intp)
        return np.concatenate([ours for ours, _ in found]), np.concatenate([theirs for _, theirs in found])

    def _over(self, other: Bounds, some: slice) -> tuple[Indices, Indices]:
        """Those of one group: first of all what of theirs lies about the whole of it."""
        x0, y0, x1, y1 = self.x0[some], self.y0[some], self.x1[some], self.y1[some]
        near = np.flatnonzero(
            (other.x0 <= x1.max()) & (other.x1 >= x0.min()) & (other.y0 <= y1.max()) & (other.y1 >= y0.min())
        )
        across = (x0[:, None] <= other.x1[near]) & (x1[:, None] >= other.x0[near])
        across &= y0[:, None] <= other.y1[near]
        across &= y1[:, None] >= other.y0[near]
        ours, theirs = np.nonzero(across)
        return ours + some.start, near[theirs]


@dataclass(frozen=True, slots=True)
class Obstacles:
    """Straight pieces a -> b with half their width and a weight, and polygons, solid or tinted."""

    a: Complexes
    b: Complexes
    half: Floats
    weight: Floats
    polygons: NDArray[np.object_]
    solid: NDArray[np.bool_]
    spans: Bounds  # of the pieces
    areas: Bounds  # of the polygons

    @classmethod
    def of(cls, items: tuple[Item, ...]) -> Obstacles:
        """Gathered from the primitives of a figure."""
        strokes = [item for item in items if isinstance(item, Stroke) and not is_ground(item)]
        areas = [item for item in items if not isinstance(item, Stroke)]
        pieces = [
            piece for stroke, points in zip(strokes, _coarse(strokes), strict=True) for piece in _pieces(stroke, points)
        ]
        a, b, half, weight = zip(*pieces, strict=True) if pieces else ((), (), (), ())
        ends = np.array(a, dtype=complex), np.array(b, dtype=complex)
        shapes = _polygons([_corners(item) for item in areas])
        shapely.prepare(shapes)
        return cls(
            *ends,
            np.array(half, dtype=float),
            np.array(weight, dtype=float),
            shapes,
            np.array([_is_solid(item) for item in areas], dtype=bool),
            Bounds.between(*ends),
            Bounds(*shapely.bounds(shapes).reshape(-1, 4).T),
        )

    def cost(self, centre: Complexes, wide: Floats, high: Floats, own: Own, groups: Groups) -> Floats:
        """What each of many places costs; `own`: the line that its label names, which may be as near as it likes."""
        total = np.zeros(len(centre))
        reach = GAP + ROOM + float(self.half.max(initial=0.0))
        box, piece = Bounds.about(centre, wide, high, reach).over(self.spans, groups)
        if len(box):
            a, b, half = self.a[piece], self.b[piece], self.half[piece]
            near, close = clip(a, b, centre[box], wide[box] / 2 + half + GAP + ROOM, high[box] / 2 + half + GAP + ROOM)
            price = NEARBY * np.where(_along(a, b, own, box), 0.0, near)
            a, b, half = a[close], b[close], half[close]
            inside, hit = clip(
                a, b, centre[box[close]], wide[box[close]] / 2 + half + GAP, high[box[close]] / 2 + half + GAP
            )
            price[close] += np.where(hit, self.weight[piece[close]] * (ON_LINE + PER_MM * inside), 0.0)
            np.add.at(total, box, price)
        box, polygon = Bounds.about(centre, wide, high, 0.3).over(self.areas, groups)
        if len(box):
            here, at = np.unique(box, return_inverse=True)
            met = shapely.intersects(self.polygons[polygon], _boxes(centre[here], wide[here], high[here], 0.3)[at])
            box, polygon = box[met], polygon[met]
        np.add.at(total, box, np.where(self.solid[polygon], ON_SOLID, ON_TINT))
        return total

    def parted(self, root: Complexes, keep: Floats, centre: Complexes, own: Own, groups: Groups) -> Floats:
        """What each of many places costs for the lines between it and what its label names; keep: the radius of what is
        drawn there."""
        start = root + (centre - root) * np.minimum((keep + BESIDE) / np.abs(centre - root), 1.0)
        place, piece = Bounds.between(start, centre).over(self.spans, groups)
        a, b = self.a[piece], self.b[piece]
        met = crossed(start[place], centre[place], a, b) & ~_along(a, b, own, place)
        total = np.zeros(len(centre))
        total[place[met]] = PARTED
        return total

    def crossings(self, foot: Complexes, end: Complexes, own: Own, groups: Groups) -> Floats:
        """What each of many leader lines costs for the lines and solids it crosses."""
        total = np.zeros(len(foot))
        start = foot + 0.05 * (end - foot)
        spans = Bounds.between(start, end)
        leader, piece = spans.over(self.spans, groups)
        met = crossed(start[leader], end[leader], self.a[piece], self.b[piece])
        leader, piece = leader[met], piece[met]
        if len(leader):
            free = _along(self.a[piece], self.b[piece], own, leader)
            np.add.at(total, leader, np.where(free, 0.0, np.where(self.half[piece] > THIN / 2, OVER_BAR, CROSSING)))
        leader, polygon = spans.over(self.areas, groups)
        leader, polygon = leader[self.solid[polygon]], polygon[self.solid[polygon]]
        ends = np.stack([np.stack([start.real, start.imag], -1), np.stack([end.real, end.imag], -1)], axis=1)[leader]
        met = shapely.intersects(self.polygons[polygon], shapely.linestrings(ends))
        np.add.at(total, leader[met], CROSSING_SOLID)
        return total


def _coarse(strokes: Sequence[Stroke]) -> list[tuple[complex, ...]]:
    """The points of each stroke, of a curve as few as are fine enough."""
    found = [stroke.points + stroke.points[:1] if stroke.closed else stroke.points for stroke in strokes]
    curved = [i for i, points in enumerate(found) if len(points) > 12]
    xy, which = _joined([found[i] for i in curved])
    simple = shapely.simplify(shapely.linestrings(xy, indices=which), COARSE)
    for i, line in zip(curved, simple, strict=True):
        found[i] = tuple(complex(x, y) for x, y in shapely.get_coordinates(line))
    return found


def _pieces(stroke: Stroke, points: tuple[complex, ...]) -> list[tuple[complex, complex, float, float]]:
    weight = 1.2 if stroke.width <= THIN else 1.6
    return [(a, b, stroke.width / 2, weight) for a, b in itertools.pairwise(points)]


def _is_solid(item: Fill | TextBox) -> bool:
    return isinstance(item, TextBox) or not item.hue.is_tint or item.layer > Layer.TINT


def _corners(item: Fill | TextBox) -> tuple[complex, ...]:
    if isinstance(item, Fill):
        return item.points
    r = item.rect
    return complex(r.x1, r.y0), complex(r.x1, r.y1), complex(r.x0, r.y1), complex(r.x0, r.y0)


def _polygons(corners: Sequence[tuple[complex, ...]]) -> NDArray[np.object_]:
    xy, which = _joined(corners)
    found: NDArray[np.object_] = shapely.polygons(shapely.linearrings(xy, indices=which))
    return found


def _joined(points: Sequence[tuple[complex, ...]]) -> tuple[Floats, Indices]:
    """The coordinates of many curves in one array, and to which of them each belongs."""
    flat = np.array([z for some in points for z in some], dtype=complex)
    return np.stack([flat.real, flat.imag], axis=1), np.repeat(np.arange(len(points)), [len(some) for some in points])


def crossed(a: Complexes, b: Complexes, p: Complexes, q: Complexes) -> NDArray[np.bool_]:
    """Whether lines a -> b and p -> q cross, if not on one line; they may lie side by side."""
    d, e = (b - a).conjugate(), (q - p).conjugate()
    apart = ((d * (p - a)).imag * (d * (q - a)).imag > 0) | ((e * (a - p)).imag * (e * (b - p)).imag > 0)
    result: NDArray[np.bool_] = ~apart
    return result


def _boxes(centre: Complexes, width: Floats | float, height: Floats | float, by: float) -> Any:
    x, y = centre.real, centre.imag
    return shapely.box(x - width / 2 - by, y - height / 2 - by, x + width / 2 + by, y + height / 2 + by)


def _along(a: Complexes, b: Complexes, own: Own, which: Indices) -> NDArray[np.bool_]:
    """Which pieces run along the line p -> q that a label names; `which`: that of each piece."""
    p, q = own[0][which], own[1][which]
    length = np.abs(q - p)
    u = ((q - p) / np.maximum(length, 1e-6)).conjugate()
    off_a, off_b = ((a - p) * u).imag, ((b - p) * u).imag
    result: NDArray[np.bool_] = (length >= 1e-6) & (np.abs(off_a) < 0.05) & (np.abs(off_b) < 0.05)
    return result
