"""Figures of a page drawn together: no nearer to the frame than to each other, as a mounted picture has its margin.

Titles on one line stay on one line, and figures one above the other stay so: all that changes is the white.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations, product

from ..scene import Rect
from .slicing import TOUCH, Size

STEPS = tuple(1.0 - 0.02 * n for n in range(16))  # of their distances from the middle of the page
MARGIN = 18.0  # mm to the frame beyond which no more is asked
ASUNDER, BESIDE = 12.0, 4.0  # mm that figures keep of each other, and of what stands still, if they had it


def evened(boxes: Sequence[Rect], lines: Sequence[float], page: Size, still: Sequence[Rect] = ()) -> list[complex]:
    """By how much each figure moves: first across, then up and down. lines: on which height the titles stand."""
    now, falls = list(boxes), list(lines)
    for across in (True, False):
        keys = [box.centre.real for box in now] if across else falls
        moves = _drawn_together(now, keys, page, still, across)
        now = [_moved(box, by) for box, by in zip(now, moves, strict=True)]
        falls = [line + by.imag for line, by in zip(falls, moves, strict=True)]
    return [complex(new.x0 - old.x0, new.y0 - old.y0) for new, old in zip(now, boxes, strict=True)]


def _drawn_together(
    boxes: Sequence[Rect], keys: Sequence[float], page: Size, still: Sequence[Rect], across: bool
) -> list[complex]:
    """The first way to draw them together after which the frame is as far off as the next figure, or the last that is
    allowed; none where they stand so already."""
    best = [0j] * len(boxes)
    for moves in _ways(boxes, keys, page, across):
        made = [_moved(box, by) for box, by in zip(boxes, moves, strict=True)]
        if _crowds(made, boxes, still):
            continue
        best = moves
        if _edge(made, page, across) >= min(_gap(made, across), MARGIN) - TOUCH:
            break
    return best


def _ways(boxes: Sequence[Rect], keys: Sequence[float], page: Size, across: bool) -> Iterator[list[complex]]:
    """Closer and closer to the middle, with as much white on either side."""
    unit = 1.0 if across else 1j
    middle = (min(keys) + max(keys)) / 2
    for share in STEPS:
        moves = [unit * (share - 1.0) * (key - middle) for key in keys]
        made = [_moved(box, by) for box, by in zip(boxes, moves, strict=True)]
        low, high = _ends(made, page, across)
        yield [by + unit * (high - low) / 2 for by in moves]


def _ends(boxes: Iterable[Rect], page: Size, across: bool) -> tuple[float, float]:
    """The white on the left and right of all, or below and above."""
    sides = [(b.x0, page[0] - b.x1) if across else (b.y0, page[1] - b.y1) for b in boxes]
    return min(low for low, _ in sides), min(high for _, high in sides)


def _edge(boxes: Sequence[Rect], page: Size, across: bool) -> float:
    return min(_ends(boxes, page, across))


def _gap(boxes: Sequence[Rect], across: bool) -> float:
    """The least white between two that stand side by side, or one above the other."""
    spans = [_apart(a, b) for a, b in combinations(boxes, 2)]
    return min((dx if across else dy for dx, dy in spans if (dy if across else dx) < 0), default=float("inf"))


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


def _moved(box: Rect, by: complex) -> Rect:
    return Rect(box.x0 + by.real, box.y0 + by.imag, box.x1 + by.real, box.y1 + by.imag)
