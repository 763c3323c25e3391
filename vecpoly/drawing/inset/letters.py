"""Letters of a small figure: each where nothing is near, outward of the polygon if it can be; all of them, or none."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Sequence
from itertools import pairwise, product
from math import tau

import numpy as np
from numpy.typing import NDArray

from ...foundation.slotted import dataclass
from ..figure import Bare
from ..labels.want import Thing, Want
from ..scene import Fill, Item, Rect, Stroke
from ..weighing.placed import Placed

CLEAR, ROOMS = 0.6, (1.0, 1.6)  # mm of the sheet that a letter keeps of every line, and that it would rather have
APART = 1.5  # mm between two letters, and to a corner that it does not name
WAYS, GAPS = 16, (0.5, 1.4, 2.6)  # about a corner; mm beside it
NARROW, OUTWARD, FARTHER, OFF_MIDDLE = 1.0, 0.7, 0.6, 0.15  # what a place costs, and what it gains
SEARCHED = 500  # places that are tried where letters are in each other's way
_ROUND, _SOME = 8, 4  # of a circle so many points will do
_SOFT = 1.6  # how soon a letter stands square beside its corner

Boxes = NDArray[np.float64]  # a row each: left, foot, right, head


@dataclass(frozen=True, slots=True)
class _Spot:
    """A place that a letter may take."""

    want: Want
    centre: complex
    cost: float

    @property
    def placed(self) -> Placed:
        """The letter there."""
        return Placed(self.want, self.centre, 0.0)


def lettered(bare: Bare, corners: Sequence[complex]) -> tuple[Placed, ...] | None:
    """All letters of the figure in places where they touch nothing; None where one of them finds none."""
    lines, wide = _lines(bare.items)
    options = [_free(want, lines, wide, corners) for want in bare.wanted]
    ordered = sorted((sorted(some, key=lambda spot: spot.cost) for some in options), key=len)
    return _in_turn(ordered) or _searched(ordered)


def _in_turn(options: Sequence[Sequence[_Spot]]) -> tuple[Placed, ...] | None:
    """Each letter in its best place that those before leave free."""
    placed: list[Placed] = []
    for some in options:
        free = (one.placed for one in some)
        found = next((one for one in free if _stands_alone(one.rect, placed)), None)
        if found is None:
            return None
        placed.append(found)
    return tuple(placed)


def _searched(options: Sequence[Sequence[_Spot]]) -> tuple[Placed, ...] | None:
    """Where that leaves none for a later one: always the letter with the fewest places next, and back to one before
    where another has none left."""
    spots, owner = [one for some in options for one in some], _owners(options)
    boxes = np.array([(r.x0, r.y0, r.x1, r.y1) for r in (one.placed.rect for one in spots)]).reshape(-1, 4)
    met = _overlap(boxes) | (owner[:, None] == owner)
    steps = iter(range(SEARCHED))

    def rest(free: NDArray[np.bool_], left: frozenset[int]) -> tuple[int, ...] | None:
        if not left:
            return ()
        counts = {letter: int(free[owner == letter].sum()) for letter in left}
        letter = min(left, key=lambda one: (counts[one], one))
        for spot in np.flatnonzero(free & (owner == letter)).tolist() if counts[letter] else ():
            if next(steps, None) is None:
                return None
            found = rest(free & ~met[spot], left - {letter})
            if found is not None:
                return (spot, *found)
        return None

    chosen = rest(np.ones(len(spots), dtype=bool), frozenset(range(len(options))))
    return None if chosen is None else tuple(spots[spot].placed for spot in chosen)


def _owners(options: Sequence[Sequence[_Spot]]) -> NDArray[np.int64]:
    """Of each place the number of its letter."""
    return np.repeat(np.arange(len(options)), [len(some) for some in options])


def _overlap(boxes: Boxes) -> NDArray[np.bool_]:
    """Which letters stand too near to which others."""
    low, high = boxes[:, None, :2] - APART, boxes[:, None, 2:] + APART
    met: NDArray[np.bool_] = np.all((low < boxes[:, 2:]) & (boxes[:, :2] < high), axis=2)
    return met


def _stands_alone(rect: Rect, others: Iterable[Placed]) -> bool:
    return not any(rect.grown(APART).overlaps(other.rect) for other in others)


def _lines(items: Iterable[Item]) -> tuple[NDArray[np.complex128], NDArray[np.float64]]:
    """Every edge that is inked, by its ends, and half its width."""
    edges: list[tuple[complex, complex]] = []
    wide: list[float] = []
    for item in items:
        if not isinstance(item, Stroke | Fill):
            continue
        points = item.points[:: max(1, len(item.points) // _SOME)] if len(item.points) > _ROUND else item.points
        closed = isinstance(item, Fill) or item.closed
        ends = [*pairwise((*points, points[0]) if closed else points)]
        edges += ends
        wide += [item.width / 2 if isinstance(item, Stroke) else 0.0] * len(ends)
    return np.array(edges, dtype=complex).reshape(-1, 2), np.array(wide)


def _free(
    want: Want, lines: NDArray[np.complex128], wide: NDArray[np.float64], corners: Sequence[complex]
) -> list[_Spot]:
    """Where the letter touches no line and stands at no other corner."""
    middle = sum(corners) / len(corners)
    spots = [*_about(want, middle)] if want.thing is Thing.POINT else [*_along(want, middle)]
    half = np.array([-want.width, -want.height, want.width, want.height]) / 2
    boxes = np.array([(z.real, z.imag, z.real, z.imag) for z, _ in spots]) + half
    others = np.array([[z, z] for z in corners if abs(z - want.own[0]) > APART and abs(z - want.own[1]) > APART])
    taken = _near(boxes, lines, wide + CLEAR)
    if len(others):
        taken |= _near(boxes, others, np.full(len(others), APART + CLEAR))
    narrow = np.sum([_near(boxes, lines, wide + room) for room in ROOMS], axis=0)
    costs = [cost + NARROW * less for (_, cost), less in zip(spots, narrow.tolist(), strict=True)]
    return [_Spot(want, z, cost) for (z, _), cost, on in zip(spots, costs, taken.tolist(), strict=True) if not on]


def _near(boxes: Boxes, lines: NDArray[np.complex128], by: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Whether each box, grown by so much, meets a line."""
    first, last = np.zeros((len(boxes), len(lines))), np.ones((len(boxes), len(lines)))
    for part, low, high in ((lines.real, 0, 2), (lines.imag, 1, 3)):
        start, way = part[:, 0], part[:, 1] - part[:, 0]
        way = np.where(abs(way) < 1e-9, 1e-9, way)
        one = (boxes[:, low, None] - by - start) / way
        two = (boxes[:, high, None] + by - start) / way
        first, last = np.maximum(first, np.minimum(one, two)), np.minimum(last, np.maximum(one, two))
    result: NDArray[np.bool_] = np.any(first <= last, axis=1)
    return result


def _about(want: Want, middle: complex) -> Iterable[tuple[complex, float]]:
    """Places all round a corner, each with what it costs."""
    at, out = want.feet[0], _way(want.feet[0] - middle)
    for gap, n in product(GAPS, range(WAYS)):
        u = cmath.rect(1.0, tau * n / WAYS)
        side = complex(want.width / 2 * _soft(u.real), want.height / 2 * _soft(u.imag))
        yield at + (want.radius + gap + CLEAR) * u + side, _cost(u, out) + FARTHER * GAPS.index(gap)


def _along(want: Want, middle: complex) -> Iterable[tuple[complex, float]]:
    """Places on both sides of a vector that has its own symbol."""
    for n, (foot, normal) in enumerate(zip(want.feet, want.normals, strict=True)):
        out = _way(foot - middle)
        for u, gap in product((normal, -normal), GAPS):
            away = want.radius + gap + CLEAR + (abs(u.real) * want.width + abs(u.imag) * want.height) / 2
            yield foot + away * u, _cost(u, out) + OFF_MIDDLE * n + FARTHER * GAPS.index(gap)


def _cost(way: complex, out: complex) -> float:
    return OUTWARD * (1.0 - (way * out.conjugate()).real)


def _soft(part: float) -> float:
    return min(1.0, max(-1.0, _SOFT * part))


def _way(z: complex) -> complex:
    """Its direction; none of what has no length."""
    return z / abs(z) if abs(z) > CLEAR else 0j
