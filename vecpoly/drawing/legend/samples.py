"""How the samples of a legend look."""

from __future__ import annotations

from collections.abc import Callable

from ...board.paper.marks import Dot, ImageOf, Mark, Passing, Point, Role, Segment, Vector, Weld
from .entry import HALF, MIDDLE, WIDE

Marks = tuple[Mark, ...]


def line(mark: Mark) -> Marks:
    """A line drawn as this one."""
    role = getattr(mark, "role", Role.CENTRE)
    return (Segment(a=0j, b=complex(WIDE), role=role, key=mark.key),)


def arrow(role: Role, key: str = "") -> Marks:
    """A vector."""
    return (Vector(a=0j, b=complex(WIDE), role=role, key=key),)


def pinned(dot: Dot) -> Callable[[Mark], Marks]:
    """A point on a bar."""
    return lambda _: (Segment(a=0j, b=complex(WIDE), role=Role.LINK), Point(at=MIDDLE, label="", dot=dot))


def image(_: Mark) -> Marks:
    """A tinted triangle."""
    a, b, c = -1j * HALF, WIDE - 1j * HALF, WIDE * 0.7 + 1j * HALF
    sides = tuple(Segment(a=p, b=q, role=Role.CONSTRUCTION) for p, q in ((a, b), (b, c), (c, a)))
    return (ImageOf(points=(a, b, c)), *sides)


def passing(_: Mark) -> Marks:
    """A bar with a pin beside it."""
    bar = Segment(a=0j, b=complex(WIDE), role=Role.LINK)
    return (bar, Passing(at=MIDDLE, along=1 + 0j), Point(at=MIDDLE, label="", dot=Dot.JOINT))


def welded(_: Mark) -> Marks:
    """Two bars with a filled corner."""
    at, up = MIDDLE - 1j * HALF, 1j * 2 * HALF
    bars = (Segment(a=at - WIDE / 2, b=at + WIDE / 2, role=Role.LINK), Segment(a=at, b=at + up, role=Role.LINK))
    return (*bars, Weld(at=at, u=1 + 0j, v=1j))
