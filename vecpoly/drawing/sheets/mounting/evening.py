"""Figures of a page drawn together: no nearer to the frame than to each other, as a mounted picture has its margin.

Titles on one line stay on one line, and figures one above the other stay so: all that changes is the white.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import reduce
from itertools import combinations, product
from operator import or_

from ...scene import Rect
from ..slicing import TOUCH, Size

STEPS = tuple(1.0 - 0.02 * n for n in range(16))  # of their distances from the middle of the page
MARGIN, WORTH = 18.0, 1.0  # mm of white beyond which no more is asked; by which it must grow for figures to move
LEAST = 0.6  # of the page that they take together, if they did
ASUNDER, BESIDE = 12.0, 4.0  # mm that figures keep of each other, and of what stands still, if they had it


def evened(boxes: Sequence[Rect], lines: Sequence[float], page: Size, still: Sequence[Rect] = ()) -> list[complex]:
    """By how much each figure moves: first across, then up and down. lines: on which height the titles stand."""
    now, falls = list(boxes), list(lines)
    for across in (True, False):
        keys = [box.centre.real for box in now] if across else falls
        moves = _drawn_together(now, keys, page, still, across)
        now = [box.moved(by) for box, by in zip(now, moves, strict=True)]
        falls = [line + by.imag for line, by in zip(falls, moves, strict=True)]
    return [complex(new.x0 - old.x0, new.y0 - old.y0) for new, old in zip(now, boxes, strict=True)]


def _drawn_together(
    boxes: Sequence[Rect], keys: Sequence[float], page: Size, still: Sequence[Rect], across: bool
) -> list[complex]:
    """The way that leaves most white about the figures, each counted where it has least; of like ones the widest."""
    best, most, least = [0j] * len(boxes), _room(boxes, page, across) + WORTH, _least(boxes, page)
    for moves in _ways(boxes, keys, page, across):
        made = [box.moved(by) for box, by in zip(boxes, moves, strict=True)]
        room = _room(made, page, across)
        if room > most + TOUCH and _taken(made, page) >= least and not _crowds(made, boxes, still):
            best, most = moves, room
    return best


def _ways(boxes: Sequence[Rect], keys: Sequence[float], page: Size, across: bool) -> Iterator[list[complex]]:
    """Closer and closer to the middle, with as much white on either side."""
    unit = 1.0 if across else 1j
    middle = (min(keys) + max(keys)) / 2
    for share in STEPS:
        moves = [unit * (share - 1.0) * (key - middle) for key in keys]
        made = [box.moved(by) for box, by in zip(boxes, moves, strict=True)]
        low, high = _ends(made, page, across)
        yield [by + unit * (high - low) / 2 for by in moves]


def _ends(boxes: Iterable[Rect], page: Size, across: bool) -> tuple[float, float]:
    """The white on the left and right of all, or below and above."""
    sides = [(b.x0, page[0] - b.x1) if across else (b.y0, page[1] - b.y1) for b in boxes]
    return min(low for low, _ in sides), min(high for _, high in sides)


def _room(boxes: Sequence[Rect], page: Size, across: bool) -> float:
    """The white between each figure and the frame or the next beside it, or above or below it; the sum of that."""
    found = [min(_ends([box], page, across)) for box in boxes]
    for (i, a), (k, b) in combinations(enumerate(boxes), 2):
        dx, dy = _apart(a, b)
        if (dy if across else dx) < 0:
            found[i], found[k] = (min(room, dx if across else dy) for room in (found[i], found[k]))
    return sum(min(room, MARGIN) for room in found)


def _least(boxes: Sequence[Rect], page: Size) -> float:
    """What they go on to take of the page, where they are not sparse already."""
    return LEAST if _taken(boxes, page) >= LEAST else 0.0


def _taken(boxes: Sequence[Rect], page: Size) -> float:
    """What the box about all of them takes of the page."""
    whole = reduce(or_, boxes)
    return whole.width * whole.height / (page[0] * page[1])


def _crowds(made: Sequence[Rect], boxes: Sequence[Rect], still: Sequence[Rect]) -> bool:
    """Whether two come too close to each other, or one to what stands still."""
    pairs = combinations(range(len(made)), 2)
    near = any(_white(made[i], made[j]) < min(_white(boxes[i], boxes[j]), ASUNDER) - TOUCH for i, j in pairs)
    every = product(zip(made, boxes, strict=True), still)
    return near or any(_white(new, one) < min(_white(old, one), BESIDE) - TOUCH for (new, old), one in every)


def _white(a: Rect, b: Rect) -> float:
    return max(_apart(a, b))


def _apart(a: Rect, b: Rect) -> tuple[float, float]:
    """How far apart they are across, and up and down; negative where they overlap so."""
    return max(b.x0 - a.x1, a.x0 - b.x1), max(b.y0 - a.y1, a.y0 - b.y1)
