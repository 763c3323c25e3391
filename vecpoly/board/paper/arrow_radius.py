"""How far from its centre a curved arrow stands."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

from .bodies import GearMark
from .marks import Arc, Disc, Mark, TurnArrow

STEP, STEPS = 3.0, 4  # mm, and how often it is tried farther out
OF_CIRCLE, OF_ARROW = 1.5, 2.5  # mm to a circle about the centre, to another curved arrow
NEAR = 1e-6  # mm


def clear_radius(marks: Sequence[Mark], at: complex, least: float) -> float:
    """The least radius (mm), not below `least`, of an arrow about a point that lies on no circle and no other curved
    arrow about it; `least` where there is none."""
    taken = [(mark.radius, OF_ARROW) for mark in marks if isinstance(mark, TurnArrow) and abs(mark.at - at) < NEAR]
    taken += [(size, OF_CIRCLE) for mark in marks if (size := _circle(mark, at)) is not None]
    tried = (least + STEP * n for n in range(STEPS + 1))
    return next((size for size in tried if all(abs(size - other) >= room for other, room in taken)), least)


def _circle(mark: Mark, about: complex) -> float | None:
    """The radius of a circle about this point: of an arc, of a wheel, of a disc."""
    match mark:
        case Arc(sweep=sweep) if abs(sweep) <= pi:
            return None
        case Arc() | GearMark() | Disc():
            return mark.radius if abs(mark.centre - about) < NEAR else None
        case _:
            return None
