"""How much paper marks take: their bounding box in mm."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import assert_never

import numpy as np

from .marks import (
    AngleMark,
    Arc,
    Block,
    Cell,
    Curve,
    Disc,
    Dot,
    FixedGuide,
    FrictionCircle,
    GearMark,
    Ground,
    Hatched,
    ImageOf,
    LinkNumber,
    Mark,
    Note,
    Outline,
    Passing,
    Plate,
    Point,
    RackMark,
    RightAngle,
    Role,
    Segment,
    Slot,
    TurnArrow,
    Vector,
    Weld,
)


def bounds(marks: Iterable[Mark]) -> tuple[complex, complex]:
    """Lower left and upper right corner (mm) of the box round the marks' points."""
    return box_of([p for m in marks for p in corners(m)] or [0j])


def box_of(points: Sequence[complex]) -> tuple[complex, complex]:
    """Lower left and upper right corner of the box round points, of which there is one at least."""
    at = np.array(points)
    return complex(at.real.min(), at.imag.min()), complex(at.real.max(), at.imag.max())


def extent(marks: Iterable[Mark]) -> tuple[float, float]:
    """Width and height (mm) of that box."""
    low, high = bounds(marks)
    return high.real - low.real, high.imag - low.imag


def figured(marks: Iterable[Mark]) -> tuple[Mark, ...]:
    """The marks that grow with the scale: without ruled directions,
    which run on by so many mm, and letters at their ends."""
    return tuple(
        m
        for m in marks
        if not (isinstance(m, Segment) and m.role is Role.DIRECTION)
        and not (isinstance(m, Point) and m.dot is Dot.NONE)
    )


def lasting(marks: Iterable[Mark]) -> tuple[Mark, ...]:
    """The marks for which a scale is chosen:
    without the dashed construction, and its letters, that take what room there is."""
    return tuple(
        m
        for m in marks
        if not (isinstance(m, Segment) and m.role is Role.IDEAL) and not (isinstance(m, Point) and m.key.endswith("_0"))
    )


def corners(mark: Mark) -> Iterator[complex]:
    """Points that span the mark."""
    match mark:  # the usual marks first
        case Point() | Ground() | Block() | Note() | TurnArrow() | AngleMark() | RightAngle():
            yield mark.at
        case Segment() | Vector() | FixedGuide() | Slot() | RackMark() | LinkNumber():
            yield from (mark.a, mark.b)
        case Arc(centre=c, radius=r, start=start, sweep=sweep):
            for t in np.linspace(start, start + sweep, 9):
                yield complex(c + r * np.exp(1j * t))
        case ImageOf(points=points) | Plate(points=points) | Outline(points=points) | Curve(points=points):
            yield from points
        case Hatched(points=points):
            yield from points
        case GearMark(centre=c, radius=r) | Disc(centre=c, radius=r) | FrictionCircle(centre=c, radius=r):
            yield from (c + r * turn for turn in (1, 1j, -1, -1j))
        case Cell(at=at, width=w, height=h):
            yield from (at + complex(x * w, y * h) / 2 for x in (-1, 1) for y in (-1, 1))
        case Passing() | Weld():
            yield mark.at
        case _:
            assert_never(mark)
