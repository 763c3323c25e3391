"""How a size is drawn on a sketch: a dimension line, a radius, an angle; the letter alone, its value is in the data."""

from __future__ import annotations

import cmath
from collections.abc import Iterator

from ...board.paper.marks import AngleMark, Dot, Mark, Point, Role, Segment, Vector

PAST = 1.5  # mm by which a line runs past a dimension
NARROW = 9.0  # mm: a dimension line that is shorter has its arrowheads outside
OUT = 5.0  # mm: how far these run on
AXIS = 14.0  # mm of a line from which an angle is measured
NEAR = 1e-6  # mm


def span(a: complex, b: complex, symbol: str, off: complex = 0j) -> Iterator[Mark]:
    """The distance of two places on a line beside them, this far away."""
    if abs(b - a) < NEAR:
        return
    way, c, d = (b - a) / abs(b - a), a + off, b + off
    if off:
        beyond = PAST * off / abs(off)
        yield _thin(a, c + beyond)
        yield _thin(b, d + beyond)
    if abs(b - a) >= NARROW:
        yield Vector(a=c, b=d, role=Role.CONSTRUCTION, step=1)
        yield Vector(a=d, b=c, role=Role.CONSTRUCTION, step=1)
        yield letter((c + d) / 2, symbol)
        return
    yield _thin(c, d)
    yield Vector(a=c - OUT * way, b=c, role=Role.CONSTRUCTION, step=1)
    yield Vector(a=d + OUT * way, b=d, role=Role.CONSTRUCTION, step=1)
    yield letter(d + OUT * way, symbol)


def radius(centre: complex, size: float, turn: float, symbol: str) -> Iterator[Mark]:
    """A line from a centre to its circle with an arrowhead there; of a small circle one that comes from outside."""
    rim = centre + cmath.rect(size, turn)
    start = centre if size >= NARROW else rim + cmath.rect(OUT, turn)
    yield Vector(a=start, b=rim, role=Role.CONSTRUCTION, step=1)
    yield letter((start + rim) / 2 if size >= NARROW else start, symbol)


def angle(at: complex, size: float, symbol: str, away: float, start: float = 0.0) -> Iterator[Mark]:
    """An angle from a thin line, by default one to the right; counter-clockwise unless it is negative (rad)."""
    yield _thin(at, at + cmath.rect(away + 4.0, start))
    yield AngleMark(at=at, radius=away, start=start, sweep=size, label=symbol, step=1)


def ray(at: complex, turn: float, length: float) -> Iterator[Mark]:
    """A thin line in a direction that is given."""
    yield _thin(at, at + cmath.rect(length, turn))


def letter(at: complex, symbol: str) -> Mark:
    """A letter beside a place."""
    return Point(at=at, label=symbol, dot=Dot.NONE, step=1)


def _thin(a: complex, b: complex) -> Mark:
    return Segment(a=a, b=b, role=Role.CONSTRUCTION, step=1)
