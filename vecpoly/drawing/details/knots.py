"""Where a figure is to be drawn apart: letters that crowd together, vectors and friction circles that are too small."""

from __future__ import annotations

import re
from cmath import phase
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from math import pi

import numpy as np

from ...board.construction import Figure, View
from ...board.paper.extent import extent, figured
from ...board.paper.marks import Dot, FrictionCircle, ImageOf, Point, Role, Segment, Vector
from ...board.ruler import READABLE
from ...foundation.slotted import dataclass, replace
from .knot import Knot, Trouble, about_image
from .nest import Nest

CROWDED = 6.0  # mm: three letters that lie no farther apart than this crowd together
PAIR, ABOUT = (1.6, 8.0), 7.0  # mm between two letters that lines may hide; about their middle
LINES, OTHERS = 12, 1  # that end there, at least; details that there are already, at most
TWINS = 0.3, 1.6  # mm: two letters so near to each other, and no nearer, can be told apart in a detail alone
SLIGHT = 8.0  # so many times the longest side of an image its polygon measures, if it is drawn apart
FAINT = 4.5  # mm: a vector that is found and read is drawn apart if it is shorter
SPECK = 0.15  # mm: a vector shorter than this is none at 20:1 either
ROUND = 4.0  # mm: on which side a line of action touches a friction circle that is less across is hardly seen
APART = 0.05  # mm: letters at one place share a label
_LETTER = re.compile(r"[A-Za-z][′'^{}]*")
RIM = 0.2  # mm from a rim that a line is drawn that touches it
MOST = 3  # knots of a figure


@dataclass(frozen=True, slots=True)
class Crowd:
    """What of a figure may be too near: where its letters belong, the ends of its vectors, how far it is across, mm;
    circles: the ends of a diameter of each friction circle, and touched: how many lines of action touch it; images: the
    corners of each image of a link; ends: of all lines of a polygon; found: the ends of vectors that are read; own:
    places of letters that are of no numbered series, where the neighbours would tell which is which."""

    places: tuple[complex, ...]
    vectors: tuple[tuple[complex, complex], ...]
    across: float
    circles: tuple[tuple[complex, complex], ...] = ()
    own: tuple[complex, ...] = ()
    images: tuple[tuple[complex, ...], ...] = ()
    ends: tuple[complex, ...] = ()
    found: tuple[tuple[complex, complex], ...] = ()
    touched: tuple[int, ...] = ()

    @classmethod
    def of(cls, figure: Figure) -> Crowd:
        """Of a figure; nothing on diagrams with axes and free bodies, whose arrows have no length."""
        polygon = not figure.view.bodies
        if figure.view.across is not None or not (polygon or figure.view is View.MECHANISM):
            return cls((), (), 0.0)
        lettered = [m for m in figure.marks if isinstance(m, Point) and m.label and m.dot is not Dot.NONE]
        own = _distinct(m.at for m in lettered if _LETTER.fullmatch(m.label))
        vectors = [m for m in figure.marks if isinstance(m, Vector) and polygon]
        read = figure.view.images or figure.view is View.FORCE
        ends, found = _ends_of(vectors), _ends_of(m for m in vectors if read and m.role is Role.RESULT)
        across = max(extent(figured(figure.marks)))
        places = _distinct(m.at for m in lettered)
        images = dict.fromkeys(m.points for m in figure.marks if isinstance(m, ImageOf) and len(m.points) > 2)
        lines, circles = _ends(figure), _circles(figure)
        touched = tuple(_touching(figure, *circle) for circle in circles)
        return cls(tuple(places), ends, across, circles, tuple(own), tuple(images), lines, found, touched)

    def times(self, factor: float) -> Crowd:
        """As many times larger."""
        pairs = (self.vectors, self.circles, self.found)
        ends, circles, found = (tuple((a * factor, b * factor) for a, b in some) for some in pairs)
        places, own, lines = (tuple(at * factor for at in some) for some in (self.places, self.own, self.ends))
        images = tuple(tuple(at * factor for at in corners) for corners in self.images)
        return Crowd(places, ends, self.across * factor, circles, own, images, lines, found, self.touched)

    @property
    def knots(self) -> tuple[Knot, ...]:
        """The places that are to be drawn apart, the worst first: circles none of which overlap."""
        faint = [one for one in _short(self.found, FAINT) if abs(one.b - one.a) >= READABLE]
        small = (*_short(self.vectors, READABLE), *faint, *self._small_circles())
        left, found = _snapped([*_crowds(self.places), *_twins(self.own), *small]), list[Knot]()
        while left and len(found) < MOST:
            best = Nest.of(left).best(self.across, found)
            if best is None:
                break
            found.append(best)
            left = [one for one in left if not (best.holds(one.a) and best.holds(one.b))]
        if len(found) <= OTHERS:
            found += self._hidden(found)
        return (*found, *_of_images(self.images, self.across, found))[:MOST]

    def _small_circles(self) -> Iterator[Trouble]:
        """Those on which one does not see on which side a line touches, worth the more the more lines touch them."""
        most = dict[frozenset[complex], int]()
        for ends, count in zip(self.circles, self.touched, strict=True):
            most[frozenset(ends)] = max(count, most.get(frozenset(ends), 0))
        for one in _short(self.circles, ROUND, rim=True):
            yield replace(one, touched=most[frozenset((one.a, one.b))])

    def _hidden(self, found: Sequence[Knot]) -> Iterator[Knot]:
        """Where most lines hide letters."""
        crossed = [one for one in _crossed(self.places, self.ends) if not any(k.holds(one.a) for k in found)]
        best = Nest.of(crossed).best(self.across, found) if crossed else None
        if best is not None:
            yield best


@lru_cache(maxsize=256)
def knots(figure: Figure) -> tuple[Knot, ...]:
    """The places of a figure that are to be drawn apart, the worst first."""
    return Crowd.of(figure).knots


def _of_images(images: Iterable[tuple[complex, ...]], across: float, found: Sequence[Knot]) -> Iterator[Knot]:
    """Circles about images of links that are small beside the vectors to their corners, clear of those found."""
    for corners in images:
        if across < SLIGHT * max(abs(a - b) for a in corners for b in corners):
            continue
        knot = about_image(corners)
        if knot is not None and not any(map(knot.meets, found)):
            found = [*found, knot]
            yield knot


def _snapped(troubles: Sequence[Trouble]) -> list[Trouble]:
    """The same between places that are one or apart."""
    ends = dict.fromkeys(end for one in troubles for end in (one.a, one.b))
    places = np.array(_distinct(ends) or [0j])
    at = {end: complex(places[np.argmin(abs(places - end))]) for end in ends}
    return [replace(one, a=at[one.a], b=at[one.b]) for one in troubles]


def _short(vectors: Sequence[tuple[complex, complex]], least: float, *, rim: bool = False) -> list[Trouble]:
    """Those that are too short to be seen, or measured, each once; least: that are not (mm); rim: diameters."""
    found: dict[frozenset[complex], Trouble] = {}
    for a, b in vectors:
        if SPECK <= abs(b - a) < least:
            ends = frozenset(complex(round(z.real, 2), round(z.imag, 2)) for z in (a, b))
            found.setdefault(ends, Trouble(a, b, True, rim=rim))
    return list(found.values())


def _ends_of(vectors: Iterable[Vector]) -> tuple[tuple[complex, complex], ...]:
    return tuple((one.a, one.b) for one in vectors)


def _circles(figure: Figure) -> tuple[tuple[complex, complex], ...]:
    """A diameter of each friction circle."""
    circles = (mark for mark in figure.marks if isinstance(mark, FrictionCircle))
    return tuple((mark.centre - mark.radius, mark.centre + mark.radius) for mark in circles)


def _touching(figure: Figure, a: complex, b: complex) -> int:
    """How many lines of action pass a friction circle, given by a diameter, at its rim."""
    centre, radius = (a + b) / 2, abs(b - a) / 2
    lines = (mark for mark in figure.marks if isinstance(mark, Segment) and mark.role is Role.DIRECTION and mark.key)
    return len({round(_turn(line), 2) for line in lines if abs(_away(line, centre) - radius) < RIM})


def _turn(line: Segment) -> float:
    """In which direction a line runs, to and fro."""
    return phase(line.b - line.a) % pi


def _away(line: Segment, at: complex) -> float:
    """How far a point lies from a line, as far as it is drawn."""
    along = line.b - line.a
    part = ((at - line.a) * along.conjugate()).real / abs(along) ** 2 if along else 0.0
    return abs(at - line.a - min(max(part, 0.0), 1.0) * along)


def _crowds(places: Sequence[complex]) -> list[Trouble]:
    """Every two of three letters that crowd together."""
    at = np.array(places, np.complex128)
    near = (abs(at[:, None] - at) <= CROWDED) & ~np.eye(len(at), dtype=np.bool_)
    thirds = near.astype(np.int64) @ near  # how many letters are near to both
    return [Trouble(places[i], places[j], False) for i, j in np.argwhere(np.triu(near & (thirds > 0))).tolist()]


def _ends(figure: Figure) -> tuple[complex, ...]:
    """Where the lines of a polygon end."""
    lines = (mark for mark in figure.marks if isinstance(mark, Segment | Vector) and figure.view.is_polygon)
    return tuple(end for mark in lines for end in (mark.a, mark.b))


def _crossed(places: Sequence[complex], ends: Sequence[complex]) -> list[Trouble]:
    """Every two letters not far from each other about which so many lines end that they hide each other."""
    at, (least, most) = np.array(ends, np.complex128), PAIR
    pairs = ((a, b) for n, a in enumerate(places) for b in places[:n] if ends and least <= abs(a - b) <= most)
    return [Trouble(a, b, False, True) for a, b in pairs if (abs(at - (a + b) / 2) <= ABOUT).sum() >= LINES]


def _twins(places: Sequence[complex]) -> list[Trouble]:
    """Every two letters that all but coincide: as much trouble as a vector that is too short."""
    least, most = TWINS
    pairs = ((a, b) for n, a in enumerate(places) for b in places[:n])
    return [Trouble(a, b, True) for a, b in pairs if least <= abs(a - b) <= most]


def _distinct(places: Iterable[complex]) -> list[complex]:
    found: list[complex] = []
    for at in places:
        if all(abs(at - other) > APART for other in found):
            found.append(at)
    return found
