"""Whether a linkage found by positions really goes through them: circuit, branch and order.

A driver at the angle φ from an axis closes its loop while lower ≤ cos φ ≤ upper: a four-bar by |b − c| ≤ BD ≤ b + c, a
slider-crank by |height over the guide| ≤ b. Where neither bound is in [−1, 1] it turns fully, and the side on which the
loop is closed never changes: two circuits. With one bound the range is one arc, at whose ends the sides join: one
circuit. With both it is two arcs: two circuits, told by the sign of φ.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import pairwise
from math import tau

import numpy as np

_DEAD = 1e-9  # of the size of the loop: nearer to a dead point, either side is as good
_BACK = 1e-12  # rad or m: what counts as standing still


class Defect(Enum):
    """Why a linkage that closes in every position is no solution, under the names of its `Verdict`."""

    CIRCUIT = "circuit"  # it would have to be taken apart
    BRANCH = "branch"  # the driver stops at a dead point on the way
    ORDER = "order"  # it comes through the positions in another order


@dataclass(frozen=True, slots=True, kw_only=True)
class Driven:
    """A driver in the positions: where it stands (rad from an axis; m of a slider), on which side its loop is closed
    (±1; 0: at a dead point), and in what range it moves."""

    places: tuple[float, ...]
    sides: tuple[int, ...]
    full: bool = False
    parted: bool = False

    @property
    def defect(self) -> Defect | None:
        """The first of circuit, branch, order that fails."""
        pieces = self.sides if self.full else _signs(self.places) if self.parted else ()
        if not _alike(pieces):
            return Defect.CIRCUIT
        if not _alike(self.sides):
            return Defect.BRANCH
        return None if self._in_order() else Defect.ORDER

    def _in_order(self) -> bool:
        steps = [b - a for a, b in pairwise(self.places)]
        if not self.full:
            return all(step > -_BACK for step in steps) or all(step < _BACK for step in steps)
        turns = [sum((sense * step) % tau for step in steps) for sense in (1, -1)]
        return min(turns) < tau + _BACK


def fourbar(a: complex, d: complex, b: Sequence[complex], c: Sequence[complex]) -> Driven:
    """The link AB as the driver of a four-bar in its positions; A and D change places for the link CD."""
    crank, rod, rocker, frame = abs(b[0] - a), abs(c[0] - b[0]), abs(c[0] - d), abs(d - a)
    span, twice = crank**2 + frame**2, 2 * crank * frame
    lower, upper = (span - (rod + rocker) ** 2) / twice, (span - (rod - rocker) ** 2) / twice
    sides = tuple(_side((d - at).conjugate() * (pin - at)) for at, pin in zip(b, c, strict=True))
    return _driven(tuple((at - a) / (d - a) for at in b), sides, lower, upper)


def slider_crank(a: complex, along: complex, b: Sequence[complex], c: Sequence[complex]) -> Driven:
    """The link AB as the driver of a slider C that goes in the direction `along` in its positions."""
    crank, rod = abs(b[0] - a), abs(c[0] - b[0])
    height = ((c[0] - a) / along).imag
    ahead = tuple(_side(1j * (pin - at) / along * rod) for at, pin in zip(b, c, strict=True))
    rays = tuple((at - a) / (1j * along) for at in b)
    return _driven(rays, ahead, (height - rod) / crank, (height + rod) / crank)


def crank_slider(a: complex, along: complex, b: Sequence[complex], c: Sequence[complex]) -> Driven:
    """The slider C as the driver of the link AB in its positions: |AC| between |a − b| and a + b."""
    crank, rod = abs(b[0] - a), abs(c[0] - b[0])
    apart = abs(crank - rod) > abs(((c[0] - a) / along).imag)
    sides = tuple(_side((pin - a).conjugate() * (at - a)) for at, pin in zip(b, c, strict=True))
    return Driven(places=tuple(((pin - a) / along).real for pin in c), sides=sides, parted=apart)


def _driven(rays: tuple[complex, ...], sides: tuple[int, ...], lower: float, upper: float) -> Driven:
    """lower ≤ cos φ ≤ upper; the angles are counted from the middle of the range."""
    stops, opens = upper < 1, lower > -1
    if stops and not opens:
        rays = tuple(-ray for ray in rays)
    angles = tuple(float(np.angle(ray)) for ray in rays)
    return Driven(places=angles, sides=sides, full=not stops and not opens, parted=stops and opens)


def _side(across: complex) -> int:
    """The sign of the imaginary part; none at a dead point."""
    return 0 if abs(across.imag) <= _DEAD * abs(across) else 1 if across.imag > 0 else -1


def _signs(values: Sequence[float]) -> tuple[int, ...]:
    return tuple(1 if value > 0 else -1 for value in values)


def _alike(signs: Sequence[int]) -> bool:
    return not {1, -1} <= set(signs)
