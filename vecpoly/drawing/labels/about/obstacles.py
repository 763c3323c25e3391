"""What lettering must keep clear of, and what it costs to stand on it:
numpy finds the pairs and clips lines, shapely knows areas.

The places for one label lie close together: of the pieces of a figure only those about them are looked at.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from math import inf

import numpy as np
import shapely
from numpy.typing import NDArray

from ....foundation.slotted import dataclass
from ...scene import Fill, Item, Layer, Stroke, TextBox
from ...style import THIN
from ..ground import gives_way, is_ground
from .bounds import Bounds, Complexes, Floats, Groups, Indices
from .clipping import inside

Own = tuple[Complexes, Complexes]  # of each place both ends of the line that its label names

GAP = 0.45  # mm between lettering and a line
ROOM = 1.1  # mm beyond which a neighbour no longer confuses
COARSE = 0.08  # mm sagitta that is fine enough for keeping clear
ON_LINE, PER_MM, NEARBY = 40.0, 6.0, 0.7
PARTED = 24.0  # a line between a label and what it names
TINY = 1e-9  # mm
CLOSE = 0.3  # mm about a letter in which an area is under it
BESIDE = 0.25  # mm off what is named: what lies nearer is part of it
ON_SOLID, ON_TINT = 90.0, 4.0
FINE, BROAD, BROKEN = 1.2, 1.6, 0.22  # what weighs standing on a fine line, a broader one, one that is broken off there
ENDS = 5.0  # mm at the ends of a line in which it is not broken off
CROSSING, OVER_BAR, CROSSING_SOLID = 8.4, 14.0, 30.0  # a leader over a thin line, a thick one, an arrowhead or a joint


@dataclass(frozen=True, slots=True)
class Obstacles:
    """Straight pieces a -> b with half their width and a weight, and polygons, solid or tinted."""

    a: Complexes
    b: Complexes
    half: Floats
    weight: Floats
    yields: NDArray[np.bool_]  # whether a piece may be broken off about a letter
    polygons: NDArray[np.object_]
    solid: NDArray[np.bool_]
    corners: Complexes  # of each polygon two, far apart
    spans: Bounds  # of the pieces
    areas: Bounds  # of the polygons
    way: Complexes  # of the pieces, from end to end
    long: Floats
    solids: Indices  # of the polygons

    @classmethod
    def of(cls, items: tuple[Item, ...]) -> Obstacles:
        """Gathered from the primitives of a figure."""
        strokes = [item for item in items if isinstance(item, Stroke) and not is_ground(item)]
        areas = [item for item in items if not isinstance(item, Stroke)]
        pieces = [
            piece for stroke, points in zip(strokes, _coarse(strokes), strict=True) for piece in _pieces(stroke, points)
        ]
        a, b, half, weight, yields = zip(*pieces, strict=True) if pieces else ((), (), (), (), ())
        ends = np.array(a, dtype=complex), np.array(b, dtype=complex)
        corners = [_corners(item) for item in areas]
        shapes = _polygons(corners)
        shapely.prepare(shapes)
        solid = np.array([is_solid(item) for item in areas], dtype=bool)
        way = ends[1] - ends[0]
        return cls(
            *ends,
            np.array(half, dtype=float),
            np.array(weight, dtype=float),
            np.array(yields, dtype=bool),
            shapes,
            solid,
            np.array([(some[0], some[len(some) // 2]) for some in corners], dtype=complex).reshape(-1, 2).T,
            Bounds.between(*ends),
            Bounds(*shapely.bounds(shapes).reshape(-1, 4).T),
            way,
            np.abs(way),
            np.flatnonzero(solid),
        )

    def cost(self, centre: Complexes, size: Complexes, own: Own, groups: Groups, breaks: NDArray[np.bool_]) -> Floats:
        """What each of many places costs; size: of its label, width and height; own: the line that this names, which
        may be as near as it likes; breaks: whether it may break off a fine line."""
        wide, high = size.real, size.imag
        total = np.zeros(len(centre))
        reach = GAP + ROOM + float(self.half.max(initial=0.0))
        box, piece = Bounds.about(centre, wide, high, reach).over(self.spans, groups)
        if len(box):
            start, d, half = self.a[piece] - centre[box], self.way[piece], self.half[piece]
            w, h = wide[box] / 2 + half, high[box] / 2 + half
            near, close = inside(start, d, w + GAP + ROOM, h + GAP + ROOM)
            price = NEARBY * np.where(self._along(own, box, piece), 0.0, near * self.long[piece])
            within, hit = inside(start[close], d[close], w[close] + GAP, h[close] + GAP)
            weight = np.where(self.yields[piece[close]] & breaks[box[close]], BROKEN, self.weight[piece[close]])
            dear = weight * (ON_LINE + PER_MM * (within * self.long[piece[close]]))
            price[close] += np.where(hit, dear, 0.0)
            np.add.at(total, box, price)
        about = Bounds.about(centre, wide, high, CLOSE)
        box, polygon = about.over(self.areas, groups)
        met = self._touch(about, box, polygon)
        np.add.at(total, box[met], np.where(self.solid[polygon[met]], ON_SOLID, ON_TINT))
        return total

    def _touch(self, about: Bounds, box: Indices, polygon: Indices) -> NDArray[np.bool_]:
        """Which of these boxes meet these polygons; most hold one of two corners."""
        here = about.some(box)
        met = here.hold(self.corners[0, polygon]) | here.hold(self.corners[1, polygon])
        rest, at = np.unique(box[~met], return_inverse=True)
        some = about.some(rest)
        met[~met] = shapely.intersects(
            self.polygons[polygon[~met]], shapely.box(some.x0, some.y0, some.x1, some.y1)[at]
        )
        return met

    def parted(self, root: Complexes, keep: Floats, centre: Complexes, own: Own, groups: Groups) -> Floats:
        """What each of many places costs for the lines between it and what its label names; keep: the radius of what is
        drawn there."""
        start = root + (centre - root) * np.minimum((keep + BESIDE) / np.abs(centre - root), 1.0)
        place, piece = Bounds.between(start, centre).over(self.spans, groups)
        a, b = self.a[piece], self.b[piece]
        met = crossed(start[place], centre[place], a, b) & ~self._along(own, place, piece)
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
            free = self._along(own, leader, piece)
            np.add.at(total, leader, np.where(free, 0.0, np.where(self.half[piece] > THIN / 2, OVER_BAR, CROSSING)))
        leader, solid = spans.over(self.areas.some(self.solids), groups)
        met = self._strikes(start, end, leader, self.solids[solid])
        np.add.at(total, leader[met], CROSSING_SOLID)
        return total

    def _strikes(self, start: Complexes, end: Complexes, leader: Indices, polygon: Indices) -> NDArray[np.bool_]:
        """Which of these leaders, start -> end, meet these polygons; most pass by the rectangle about one."""
        areas = self.areas.some(polygon)
        from_middle, wide, high = start[leader] - areas.middle, areas.x1 - areas.x0, areas.y1 - areas.y0
        met = inside(from_middle, (end - start)[leader], wide / 2 + BESIDE, high / 2 + BESIDE)[1]
        here, at = np.unique(leader[met], return_inverse=True)
        ends = np.stack([np.stack([z.real, z.imag], -1) for z in (start[here], end[here])], axis=1)
        met[met] = shapely.intersects(self.polygons[polygon[met]], shapely.linestrings(ends)[at])
        return met

    def _along(self, own: Own, place: Indices, piece: Indices) -> NDArray[np.bool_]:
        """Which pieces run along the lines that labels name; place: that of each piece. Many places in a row are of one
        label."""
        p, q = own
        first = np.concatenate(([True], (p[1:] != p[:-1]) | (q[1:] != q[:-1]))) if len(p) else np.zeros(0, dtype=bool)
        label = np.cumsum(first) - 1
        along: NDArray[np.bool_] = _along(self.a, self.b, p[first, None], q[first, None])[label[place], piece]
        return along


def _coarse(strokes: Sequence[Stroke]) -> list[tuple[complex, ...]]:
    """The points of each stroke, of a curve as few as are fine enough."""
    found = [stroke.points + stroke.points[:1] if stroke.closed else stroke.points for stroke in strokes]
    curved = [i for i, points in enumerate(found) if len(points) > 12]
    if not curved:
        return found
    xy, which = _joined([found[i] for i in curved])
    simple = shapely.simplify(shapely.linestrings(xy, indices=which), COARSE)
    for i, line in zip(curved, simple, strict=True):
        found[i] = tuple(complex(x, y) for x, y in shapely.get_coordinates(line))
    return found


def _pieces(stroke: Stroke, points: tuple[complex, ...]) -> Iterator[tuple[complex, complex, float, float, bool]]:
    half, weight = stroke.width / 2, FINE if stroke.width <= THIN else BROAD
    if not gives_way(stroke):
        yield from ((a, b, half, weight, False) for a, b in itertools.pairwise(points))
        return
    lengths = [0.0, *itertools.accumulate(abs(b - a) for a, b in itertools.pairwise(points))]
    low, high = (0.0, inf) if stroke.closed else (ENDS, lengths[-1] - ENDS)
    for (a, b), start, end in zip(itertools.pairwise(points), lengths, lengths[1:], strict=False):
        cuts = [start, *(cut for cut in (low, high) if start < cut < end), end]
        at = [a + (b - a) * (cut - start) / max(end - start, TINY) for cut in cuts]
        for p, q, middle in zip(at, at[1:], map(_half_way, cuts, cuts[1:]), strict=False):
            yield p, q, half, weight, low < middle < high


def _half_way(start: float, end: float) -> float:
    return (start + end) / 2


def is_solid(item: Fill | TextBox) -> bool:
    """Whether letters may by no means stand on an area: not tinted, or over what is."""
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


def _along(a: Complexes, b: Complexes, p: Complexes, q: Complexes) -> NDArray[np.bool_]:
    """Whether pieces a -> b run along lines p -> q."""
    length = np.abs(q - p)
    u = ((q - p) / np.maximum(length, 1e-6)).conjugate()
    off_a, off_b = ((a - p) * u).imag, ((b - p) * u).imag
    result: NDArray[np.bool_] = (length >= 1e-6) & (np.abs(off_a) < 0.05) & (np.abs(off_b) < 0.05)
    return result
