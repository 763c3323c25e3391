"""Supports of fixed pivots stand on the side to which no link leaves: a rocker that hangs has its support above."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import shapely

from ..board.paper.marks import AngleMark, Dot, FixedGuide, Ground, Mark, Point
from ..foundation.slotted import replace
from .symbols.bodies import FOOT_HEIGHT, GROUND_HALF
from .symbols.outlines import outlines
from .symbols.shapes import NEAR

WAYS = (-1j, 1j, -1 + 0j, 1 + 0j)  # below first: elsewhere only where that covers less
PIN = 1.8  # mm about the pivot where every link of it begins
HATCHED = 1.2  # mm under the foot
POINT = 4.0  # mm of a link that a point counts under a support
BESIDE = 0.8  # cosine of the angle between a support and a ray of an angle that is clear of it
DEAR = 1.5  # mm of a link that a support may cover before it is turned


def hung(marks: tuple[Mark, ...], held: Sequence[Ground] = ()) -> tuple[Mark, ...]:
    """The marks of a figure, the supports among them clear of links where they can be.

    held: as they stand already in another position of the mechanism, one for each of these.
    """
    grounds = [mark for mark in marks if isinstance(mark, Ground)]
    if len(held) == len(grounds):
        found = {id(ground): replace(ground, down=other.down) for ground, other in zip(grounds, held, strict=True)}
    else:
        lines = _lines(marks)
        found = {id(ground): _turned(ground, lines, marks) for ground in grounds}
    return tuple(found.get(id(mark), mark) for mark in marks) if found else marks


def _turned(ground: Ground, lines: Any, marks: Iterable[Mark]) -> Ground:
    """The support on the first side that covers least; where it was drawn on purpose it stays."""
    near = shapely.intersection(lines, shapely.Point(ground.at.real, ground.at.imag).buffer(2 * FOOT_HEIGHT))
    if ground.down != WAYS[0] or near.is_empty:
        return ground
    rays = [
        ray for mark in marks if isinstance(mark, AngleMark) and abs(mark.at - ground.at) < NEAR for ray in _rays(mark)
    ]
    points = [mark.at for mark in marks if isinstance(mark, Point) and mark.dot is not Dot.NONE]
    free = [way for way in WAYS if way.imag or all((way.conjugate() * ray).real < BESIDE for ray in rays)]
    costs = {way: _covered(ground.at, way, near, points) for way in free}
    least = min(costs.values())
    return ground if costs[WAYS[0]] < least + DEAR else replace(ground, down=min(costs, key=lambda way: costs[way]))


def _rays(angle: AngleMark) -> tuple[complex, complex]:
    """The directions between which an angle is marked."""
    return cmath.rect(1.0, angle.start), cmath.rect(1.0, angle.start + angle.sweep)


def _covered(at: complex, down: complex, lines: Any, points: Sequence[complex]) -> float:
    """The length (mm) of all that a support on this side would cover; a point counts as much as a line there."""
    side, foot = 1j * GROUND_HALF * down, at + (FOOT_HEIGHT + HATCHED) * down
    top = at + PIN * down
    body = shapely.Polygon([(z.real, z.imag) for z in (top - side / 4, top + side / 4, foot + side, foot - side)])
    under = shapely.contains_xy(body, [z.real for z in points], [z.imag for z in points]).sum()
    return float(shapely.intersection(lines, body).length) + POINT * float(under)


def _lines(marks: Sequence[Mark]) -> Any:
    """Links, bodies and guides as lines."""
    guides = [(mark.a, mark.b) for mark in marks if isinstance(mark, FixedGuide) and abs(mark.b - mark.a) > NEAR]
    ends = np.array([*outlines(marks), *guides], dtype=complex).reshape(-1, 2)
    return shapely.union_all(shapely.linestrings(np.stack([ends.real, ends.imag], axis=-1)))
