"""The room about a figure, in which its details may stand."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from enum import Enum
from itertools import pairwise
from math import ceil

import numpy as np
from numpy.typing import NDArray

from ..rect import Rect

CELL = 1.0  # mm: how finely room is looked for
WHITE = 3.5  # mm of white between a figure and its detail
FAR = 0.001  # of the area of the figure that a mm to the place shown is worth

Taken = NDArray[np.bool_]
Spots = NDArray[np.complex128]


class Grow(Enum):
    """In which direction a figure may grow for its details rather than in the other, and what it is worth, as a part of
    its area, that a detail's title stands on one line with its own: nothing, if it grows upwards."""

    LEAST = (1.0, 1.0, 0.03)
    WIDE = (0.2, 1.0, 0.03)
    HIGH = (1.0, 0.2, 0.0)


@dataclass(slots=True)
class Room:
    """The room about a figure, cell by cell: what is taken by ink."""

    extents: Rect  # of the figure with the details that stand
    foot: float  # how high the figure itself stands
    low: complex  # lower left corner of the cells
    taken: Taken = field(repr=False)
    ink: list[Spots] = field(default_factory=list, repr=False)  # all of it, also beyond the cells

    @classmethod
    def about(cls, extents: Rect, ink: Iterable[Spots], reach: float) -> Room:
        """About a figure with ink at these points, and so far beyond it on every side (mm)."""
        around = extents.grown(reach)
        high, wide = ceil(around.height / CELL), ceil(around.width / CELL)
        room = cls(extents, extents.y0, complex(around.x0, around.y0), np.zeros((high, wide), dtype=bool))
        for points in ink:
            room.take(points)
        return room

    def take(self, points: Spots) -> None:
        """Ink at these points."""
        self.ink.append(points)
        self._mark(points)

    def _mark(self, points: Spots) -> None:
        at = (points - self.low) / CELL
        rows, columns = (np.floor(part).astype(int) for part in (at.imag, at.real))
        inside = (rows >= 0) & (columns >= 0) & (rows < self.taken.shape[0]) & (columns < self.taken.shape[1])
        self.taken[rows[inside], columns[inside]] = True

    def widen(self, reach: float) -> None:
        """Cells so much farther out on every side: where lines go on beyond the figure there may be no room nearer."""
        count = ceil(reach / CELL)
        high, wide = self.taken.shape
        self.low -= count * CELL * (1 + 1j)
        self.taken = np.zeros((high + 2 * count, wide + 2 * count), dtype=bool)
        for points in self.ink:
            self._mark(points)

    def free(self, wide: float, high: float) -> Spots:
        """Lower left corners (mm) of boxes of this size on which nothing stands."""
        rows, columns = ceil(high / CELL) + 1, ceil(wide / CELL) + 1
        total = np.pad(self.taken.astype(int).cumsum(0).cumsum(1), ((1, 0), (1, 0)))
        ink = total[rows:, columns:] - total[:-rows, columns:] - total[rows:, :-columns] + total[:-rows, :-columns]
        y, x = np.nonzero(ink == 0)
        return np.asarray(self.low + CELL * (x + 1j * y), dtype=complex)

    def put(self, box: Rect, wanted: complex, grow: Grow) -> Rect:
        """A box where it stands best: the figure grows little, and the place wanted is near. It is taken now."""
        size = complex(box.width, box.height)
        while not len(corners := self.free(size.real + 2 * WHITE, size.imag + 2 * WHITE)):
            self.widen(reach_of([box]))
        corners = corners + complex(WHITE, WHITE)
        e, ends = self.extents, corners + size
        wider = np.maximum(ends.real, e.x1) - np.minimum(corners.real, e.x0) - e.width
        higher = np.maximum(ends.imag, e.y1) - np.minimum(corners.imag, e.y0) - e.height
        along, up, level = grow.value
        cost = along * wider * e.height + up * higher * e.width + wider * higher
        cost += FAR * e.width * e.height * np.abs(corners + size / 2 - wanted)
        cost -= level * e.width * e.height * (np.abs(corners.imag - self.foot) < CELL / 2)
        at = complex(corners[np.argmin(cost)])
        found = Rect(at.real, at.imag, (at + size).real, (at + size).imag)
        self.extents |= found
        self.take(filled(found))
        return found


def reach_of(boxes: Iterable[Rect]) -> float:
    """How far beyond a figure one of these may stand (mm): so that cells lie level with its foot."""
    return ceil(max(max(box.width, box.height) for box in boxes) + 3 * WHITE) + WHITE % CELL


def along(points: Sequence[complex]) -> Spots:
    """Points of a line that leave no cell out."""
    return spread(np.array(list(pairwise(points)) or [(points[0], points[0])], dtype=complex))


def spread(ends: Spots) -> Spots:
    """Points of lines with these ends (lines × 2), as many of each as leave no cell out."""
    a, b = ends[:, 0], ends[:, 1]
    count = np.maximum(2, np.ceil(2 * np.abs(b - a) / CELL)).astype(int)
    number = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    return np.asarray(np.repeat(a, count) + np.repeat((b - a) / (count - 1), count) * number, dtype=complex)


def filled(r: Rect) -> Spots:
    x, y = np.arange(r.x0, r.x1 + CELL / 2, CELL / 2), np.arange(r.y0, r.y1 + CELL / 2, CELL / 2)
    return np.asarray((x[:, None] + 1j * y).ravel(), dtype=complex)
