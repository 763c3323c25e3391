"""Pins in the middle of bars and rigid corners (GB/T 4460): what shows where a link runs on, and where two parts of it
are one."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from math import copysign

from ..board.paper.marks import Block, Mark, Passing, Plate, Role, Segment, Weld
from ..board.paper.walls import HEIGHT, leaves

ENDS = 2.5  # mm: a pin nearer to an end of a bar is pinned there
BESIDE = 0.3  # mm: nearer to a line a pin stands on it
STEEP = 0.77  # cosine: where a bar leaves its block at a smaller angle the corner behind it is filled

Line = tuple[complex, complex]


def lines_of(marks: Iterable[Mark]) -> Iterator[Line]:
    """The straight lines of a link: its bars, the edges of its plates."""
    for mark in marks:
        match mark:
            case Segment(a=a, b=b, role=Role.LINK):
                yield a, b
            case Plate(points=points):
                yield from pairwise((*points, points[0]))
            case _:
                pass


def passing(at: complex, lines: Iterable[Line], others: Sequence[complex]) -> Iterator[Passing]:
    """The joining half about a pin in the middle of one of these lines, away from the other links.

    others: the ways from the pin along the other links, of any length.
    """
    for a, b in lines:
        if min(abs(b - a), abs(a - at), abs(b - at)) < ENDS:
            continue
        along = (b - a) / abs(b - a)
        foot = (at - a) * along.conjugate()
        if abs(foot.imag) < BESIDE and 0 < foot.real < abs(b - a):
            side = sum((along.conjugate() * way).imag / abs(way) for way in others if abs(way) > BESIDE)
            yield Passing(at=at, along=-along if side > BESIDE else along)
            return


def welds(blocks: Iterable[Block], lines: Sequence[Line]) -> Iterator[Weld]:
    """The filled corners where bars leave a block that is one with them."""
    for block in blocks:
        for a, b in lines:
            yield from (weld for tip in (a, b) for weld in _leaving(block, a + b - tip, tip))


def _leaving(block: Block, start: complex, tip: complex) -> Iterator[Weld]:
    """The filled corner where a line comes out of a block on its way to its end."""
    at = leaves(block, start, tip)
    if at is None:
        return
    u = block.along / abs(block.along)
    out, way = (at - block.at) * u.conjugate(), (tip - start) / abs(tip - start) * u.conjugate()
    wall = 1j if block.length / 2 - abs(out.real) < HEIGHT / 2 - abs(out.imag) else 1 + 0j
    lean = (way * wall.conjugate()).real
    side = wall * (copysign(1.0, lean) if abs(lean) < STEEP else -copysign(1.0, lean))
    yield Weld(at=block.at, off=u * out, u=u * way, v=u * side)
