"""A compression or tension spring as a zigzag between two points; a damper as a piston in an open pot."""

from __future__ import annotations

from itertools import pairwise

from ...board.paper.marks import Role, Segment
from ...board.paper.symbols import Symbol
from ...board.strokes import spot
from ...plane import Points

OWNER = "spring"
TEETH, HALF, TOOTH = 8, 2.4, 2.4  # of the zigzag; mm to either side; mm along it, at most
MIDDLE = 0.56  # of the distance of the ends, at most, that the zigzag takes
POT = 2.2  # mm: half the width of a damper's pot


def spring_symbol(a: Points, b: Points) -> Symbol:
    """A zigzag in the middle of the line from a to b."""
    start, end = spot(a), spot(b)
    reach = abs(end - start) or 1e-6
    way = (end - start) / reach
    wide = min(MIDDLE * reach, TOOTH * TEETH)
    first = start + way * (reach - wide) / 2
    tooth = wide / TEETH
    zigzag = [first + way * tooth * (k + 0.5) + 1j * way * HALF * (1 if k % 2 else -1) for k in range(TEETH)]
    points = [start, first, *zigzag, first + way * wide, end]
    return Symbol.of(OWNER, tuple(Segment(a=p, b=q, role=Role.GIVEN) for p, q in pairwise(points)))


def damper(a: Points, b: Points) -> Symbol:
    """A pot on the side of a, open towards b, with a piston in it on a rod from b."""
    start, end = spot(a), spot(b)
    reach = abs(end - start) or 1e-6
    way, side = (end - start) / reach, 1j * POT * (end - start) / reach
    bottom, mouth, head = (start + way * reach * share for share in (0.36, 0.62, 0.5))
    lines = [(start, bottom), (bottom - side, bottom + side), (bottom + side, mouth + side)]
    lines += [(bottom - side, mouth - side), (head - 0.8 * side, head + 0.8 * side), (head, end)]
    return Symbol.of(OWNER, tuple(Segment(a=p, b=q, role=Role.GIVEN) for p, q in lines))
