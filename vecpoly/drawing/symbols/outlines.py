"""The lines of links and bodies, as ends: what arcs and supports keep clear of."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise

from ...board.paper.marks import Block, Mark, Outline, Plate, Role, Segment, Slot
from .bodies import BLOCK_HEIGHT, block_corners
from .shapes import NEAR


def outlines(marks: Iterable[Mark]) -> Iterator[tuple[complex, complex]]:
    """Bars, the edges of plates and bodies, the sides of blocks, and of slots, which hide what is under them."""
    for mark in marks:
        match mark:
            case Segment(a=a, b=b, role=Role.LINK) if abs(b - a) > NEAR:
                yield a, b
            case Plate(points=points) | Outline(points=points) if len(points) > 2:
                yield from pairwise((*points, points[0]))
            case Block():
                corners = block_corners(mark)
                yield from pairwise((*corners, corners[0]))
            case Slot(a=a, b=b) if abs(b - a) > NEAR:
                side = 0.5j * BLOCK_HEIGHT * (b - a) / abs(b - a)
                yield from ((a + by, b + by) for by in (side, 0j, -side))
            case _:
                pass
