"""Where a figure is to be drawn apart: letters that crowd together, vectors too short to be seen."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from itertools import combinations

import numpy as np

from ...board.construction import Figure, View
from ...board.paper.extent import extent, figured
from ...board.paper.marks import Dot, Point, Vector
from ...board.ruler import READABLE
from ...foundation.slotted import dataclass

CROWDED = 6.0  # mm: three letters that lie no farther apart than this crowd together
SPECK = 0.15  # mm: a vector shorter than this is none at 20:1 either
APART = 0.05  # mm: letters at one place share a label
FACTORS = (2.0, 2.5, 4.0, 5.0, 10.0, 20.0)  # GB/T 14690
FULL = 58.0  # mm across that a detail is at most
EDGE, TIGHT = 9.0, 0.8  # mm between the crowd and the ring about it: in the detail, at least on the figure
SMALLEST = 1.0  # mm: radius of a circle that can be seen
WIDE, LONG = 8.0, 6.0  # mm in the detail: between letters, of a vector, if there is room;
LEGIBLE = 5.0  # mm between letters in the detail, at least
WHOLE = 6.0  # a figure of fewer radii of the knot is small altogether: it needs another scale
SEEN = 3  # what a knot is worth at least: three pairs of letters, or one vector
MOST = 3  # knots of a figure


@dataclass(frozen=True, slots=True)
class Knot:
    """A circle about a crowded place, and how many times it is to be enlarged."""

    centre: complex
    radius: float
    factor: float

    def holds(self, at: complex) -> bool:
        """Whether a point lies within."""
        return abs(at - self.centre) <= self.radius

    def moved(self, at: complex) -> complex:
        """A point as it lies in the detail."""
        return (at - self.centre) * self.factor

    def meets(self, other: Knot) -> bool:
        """Whether the circles overlap."""
        return abs(self.centre - other.centre) < self.radius + other.radius


@dataclass(frozen=True, slots=True)
class Trouble:
    """Two places that are too near: the ends of a short vector, or two letters."""

    a: complex
    b: complex
    vector: bool

    @property
    def length(self) -> float:
        """How far apart they are, mm."""
        return abs(self.b - self.a)

    @property
    def worth(self) -> int:
        """How much it is to draw them apart."""
        return SEEN if self.vector else 1

    def solved(self, factor: float, *, well: bool = False) -> bool:
        """Whether they are far enough apart so many times larger."""
        least = (LONG if well else READABLE) if self.vector else (WIDE if well else LEGIBLE)
        return self.length * factor >= least


@dataclass(frozen=True, slots=True)
class Crowd:
    """What of a figure may be too near: where its letters belong, the ends of its vectors, how far it is across, mm."""

    places: tuple[complex, ...]
    vectors: tuple[tuple[complex, complex], ...]
    across: float

    @classmethod
    def of(cls, figure: Figure) -> Crowd:
        """Of a figure; nothing on diagrams with axes and free bodies, whose arrows have no length."""
        polygon = not figure.view.bodies
        if figure.view.across is not None or not (polygon or figure.view is View.MECHANISM):
            return cls((), (), 0.0)
        lettered = (m.at for m in figure.marks if isinstance(m, Point) and m.label and m.dot is not Dot.NONE)
        ends = ((m.a, m.b) for m in figure.marks if isinstance(m, Vector) and polygon)
        return cls(tuple(_distinct(lettered)), tuple(ends), max(extent(figured(figure.marks))))

    def times(self, factor: float) -> Crowd:
        """As many times larger."""
        ends = tuple((a * factor, b * factor) for a, b in self.vectors)
        return Crowd(tuple(at * factor for at in self.places), ends, self.across * factor)

    @property
    def knots(self) -> tuple[Knot, ...]:
        """The places that are to be drawn apart, the worst first: circles none of which overlap."""
        left, found = _snapped([*_crowds(self.places), *_short(self.vectors)]), list[Knot]()
        while left and len(found) < MOST:
            tried = (one for one in _tried(left) if WHOLE * one[0].radius <= self.across)
            free = (one for one in tried if not any(map(one[0].meets, found)))
            best = max(free, key=lambda one: (one[1], -one[0].radius * one[0].factor), default=None)
            if best is None or best[1] < SEEN:
                break
            found.append(best[0])
            left = [one for one in left if not (best[0].holds(one.a) and best[0].holds(one.b))]
        return tuple(found)


@lru_cache(maxsize=256)
def knots(figure: Figure) -> tuple[Knot, ...]:
    """The places of a figure that are to be drawn apart, the worst first."""
    return Crowd.of(figure).knots


def _snapped(troubles: Sequence[Trouble]) -> list[Trouble]:
    """The same between places that are one or apart."""
    places = np.array(_distinct(end for one in troubles for end in (one.a, one.b)) or [0j])
    ends = [[complex(places[np.argmin(abs(places - end))]) for end in (one.a, one.b)] for one in troubles]
    return [Trouble(a, b, one.vector) for (a, b), one in zip(ends, troubles, strict=True)]


def _tried(troubles: Sequence[Trouble]) -> Iterator[tuple[Knot, int]]:
    """About each place the nearest few, as far as a circle holds them, and what it is worth to enlarge them."""
    places = _distinct(end for one in troubles for end in (one.a, one.b))
    for at in places:
        order = sorted(places, key=lambda z: abs(z - at))
        for n in range(2, len(order) + 1):
            if abs(order[n - 1] - at) > FULL / FACTORS[0]:
                break
            inside = [one for one in troubles if {one.a, one.b} <= set(order[:n])]
            knot = _knot(order[:n], inside)
            if knot is not None:
                yield knot, sum(one.worth for one in inside if one.solved(knot.factor))


def _knot(places: Sequence[complex], inside: Sequence[Trouble]) -> Knot | None:
    """A circle about these, and the least factor that does well; or the largest that finds room."""
    if not inside:
        return None
    import shapely  # heavy: most figures have no crowd

    ring = shapely.minimum_bounding_circle(shapely.multipoints(np.array([(z.real, z.imag) for z in places])))
    bare = float(shapely.minimum_bounding_radius(ring))
    made = []
    for factor in FACTORS:
        radius = max(SMALLEST, bare + max(TIGHT, EDGE / factor))
        if 2 * radius * factor <= FULL:
            made.append(Knot(complex(ring.centroid.x, ring.centroid.y), radius, factor))
    well = (knot for knot in made if all(one.solved(knot.factor, well=True) for one in inside))
    return next(well, made[-1] if made else None)


def _short(vectors: Sequence[tuple[complex, complex]]) -> list[Trouble]:
    """Those that are too short to be seen, or measured, each once."""
    found: dict[frozenset[complex], Trouble] = {}
    for a, b in vectors:
        if SPECK <= abs(b - a) < READABLE:
            ends = frozenset(complex(round(z.real, 2), round(z.imag, 2)) for z in (a, b))
            found.setdefault(ends, Trouble(a, b, True))
    return list(found.values())


def _crowds(places: Sequence[complex]) -> list[Trouble]:
    """Every two of three letters that crowd together."""
    near = {(i, j) for i, j in combinations(range(len(places)), 2) if abs(places[i] - places[j]) <= CROWDED}
    thirds = {pair: [k for k in range(len(places)) if _all_near(near, *pair, k)] for pair in near}
    return [Trouble(places[i], places[j], False) for (i, j), some in sorted(thirds.items()) if some]


def _all_near(near: set[tuple[int, int]], i: int, j: int, k: int) -> bool:
    return (min(i, k), max(i, k)) in near and (min(j, k), max(j, k)) in near


def _distinct(places: Iterable[complex]) -> list[complex]:
    found: list[complex] = []
    for at in places:
        if all(abs(at - other) > APART for other in found):
            found.append(at)
    return found
