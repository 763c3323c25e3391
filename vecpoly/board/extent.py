"""How much paper marks take: their bounding box in mm."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from .marks import AngleMark, Arc, GearMark, ImageOf, Mark, Plate, RightAngle, TurnArrow


def extent(marks: Iterable[Mark]) -> tuple[float, float]:
    """Width and height (mm) of the box round the marks' points."""
    points = np.array([p for m in marks for p in corners(m)] or [0j])
    return float(np.ptp(points.real)), float(np.ptp(points.imag))


def corners(mark: Mark) -> Iterator[complex]:
    """Points that span the mark."""
    match mark:
        case ImageOf(points=points) | Plate(points=points):
            yield from points
        case Arc(centre=c, radius=r, start=start, sweep=sweep):
            for t in np.linspace(start, start + sweep, 9):
                yield complex(c + r * np.exp(1j * t))
        case GearMark(centre=c, radius=r):
            yield from (c + r * turn for turn in (1, 1j, -1, -1j))
        case TurnArrow(at=at) | AngleMark(at=at) | RightAngle(at=at):
            yield at
        case _:
            for name in ("a", "b", "at"):
                if hasattr(mark, name):
                    yield getattr(mark, name)
