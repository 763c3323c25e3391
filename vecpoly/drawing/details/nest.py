"""The circle in which an enlargement shows most: about each crowded place the nearest few, as far as one holds.

A figure of many instant centres has tens of thousands of such circles, and thousands of pairs of letters that are too
near. What a circle is worth at most follows from how far apart its places lie; only those are drawn that may be best.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

import numpy as np
from numpy.typing import NDArray

from ...foundation.slotted import dataclass
from .knot import FACTORS, SEEN, SMALLEST, TIGHT, Knot, Trouble, finds_room, largest, ring

WHOLE = 6.0  # a figure of fewer radii of the knot is small altogether: it needs another scale
ROUNDING = 1e-6  # mm by which a circle may be drawn too small

Counts = NDArray[np.int64]
Flags = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class Sets:
    """The nearest one, two, three ... places about one, in this order. By each of these sets: how many troubles lie in
    it; by each factor and set: how many it does not solve well, and what those are worth that it solves."""

    order: tuple[int, ...]
    inside: Counts
    poor: Counts
    worth: Counts

    def factor(self, n: int, bare: float, most: float) -> int | None:
        """The number of the least factor that does well for the nearest n in a circle of this radius, in a detail of so
        many mm at most; else of the least that shows as much as any that finds room."""
        made = [k for k, factor in enumerate(FACTORS) if finds_room(bare, factor, most)]
        well = (k for k in made if not self.poor[k, n - 1])
        return next(well, max(made, key=lambda k: (self.worth[k, n - 1], -k), default=None))


@dataclass(frozen=True, slots=True)
class Nest:
    """Crowded places, how far each is from each (mm), and the troubles between them: the numbers of both ends, what
    each is worth, and by each factor whether it is solved, and well."""

    places: tuple[complex, ...]
    apart: NDArray[np.float64]
    ends: Counts
    worth: Counts
    solved: Flags
    well: Flags

    @classmethod
    def of(cls, troubles: Sequence[Trouble]) -> Nest:
        """Of troubles whose ends are the same place, or apart."""
        number: dict[complex, int] = {}
        ends = [[number.setdefault(at, len(number)) for at in (one.a, one.b)] for one in troubles]
        return cls(
            places=tuple(number),
            apart=np.array([[abs(z - at) for z in number] for at in number]),
            ends=np.array(ends),
            worth=np.array([one.worth for one in troubles]),
            solved=np.array([[one.solved(factor) for one in troubles] for factor in FACTORS]),
            well=np.array([[one.solved(factor, well=True) for one in troubles] for factor in FACTORS]),
        )

    def best(self, across: float, found: Sequence[Knot]) -> Knot | None:
        """Of a figure so many mm across: the knot that shows most, the smallest detail of such, clear of those found.

        None where there is none that is worth a detail.
        """
        about = [self._about(n) for n in range(len(self.places))]
        best, kept = (SEEN, -np.inf, 0, 0), None
        for most, at, n in self._promising(about, across, found):
            if most < best[0]:
                break
            bare, centre = self._circle(about[at].order[:n])
            k = about[at].factor(n, bare, largest(across))
            if k is None:
                continue
            knot = Knot(centre, ring(bare, FACTORS[k]), FACTORS[k])
            rank = (int(about[at].worth[k, n - 1]), -knot.radius * knot.factor, -at, -n)
            if rank > best and WHOLE * knot.radius <= across and not any(map(knot.meets, found)):
                best, kept = rank, knot
        return kept

    def _about(self, at: int) -> Sets:
        """All sets about one place."""
        order = sorted(range(len(self.places)), key=self.apart[at].__getitem__)
        rank = np.argsort(order)[self.ends].max(axis=1)  # of the place with which a trouble has both ends in the set

        def counted(weights: Counts | Flags) -> Counts:
            summed: Counts = np.cumsum(np.bincount(rank, weights, len(order)).astype(np.int64))
            return summed

        return Sets(
            order=tuple(order),
            inside=counted(np.ones_like(self.worth)),
            poor=np.array([counted(~well) for well in self.well]),
            worth=np.array([counted(self.worth * solved) for solved in self.solved]),
        )

    def _promising(self, about: Sequence[Sets], across: float, found: Sequence[Knot]) -> list[tuple[int, int, int]]:
        """What a set is worth at most, about which place it lies and of how many it is: of all sets that may find room
        clear of those found, the most worthy first."""
        some = []
        held = [any(abs(z - one.centre) < one.radius + TIGHT for one in found) for z in self.places]
        open_to = (self.apart <= largest(across) / FACTORS[0]) & ~np.array(held)
        for at, sets in enumerate(about):
            order = list(takewhile(open_to[at].__getitem__, sets.order))
            if not order:
                continue
            widths = np.maximum.accumulate(np.tril(self.apart[np.ix_(order, order)]).max(axis=1))
            for n, width in enumerate(widths[1:], start=2):
                bare = float(width) / 2 - ROUNDING  # about two places that lie so far apart no circle is smaller
                room = sum(finds_room(bare, factor, largest(across)) for factor in FACTORS)
                if not room or WHOLE * max(SMALLEST, bare + TIGHT) > across:
                    break
                if sets.inside[n - 1] and (most := int(sets.worth[room - 1, n - 1])) >= SEEN:
                    some.append((most, at, n))
        return sorted(some, key=lambda one: -one[0])

    def _circle(self, some: Sequence[int]) -> tuple[float, complex]:
        """Radius and centre of the least circle about these places."""
        import shapely  # heavy: most figures have no crowd

        places = np.array([(self.places[n].real, self.places[n].imag) for n in some])
        circle = shapely.minimum_bounding_circle(shapely.multipoints(places))
        middle = circle.centroid
        return float(shapely.minimum_bounding_radius(circle)), complex(middle.x, middle.y)
