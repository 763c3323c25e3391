"""What a reader of a page marks down in how its figures stand, as shares of a page: white in one piece, titles on a
line of their own, more than one row, middles that all but agree, margins that differ, cuts within cuts, an order that
goes back up."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, pairwise

from ...rect import Rect
from ..packing import Layout
from ..pages import CROWDED
from ..slicing import Size

SAME, NEAR = 0.6, 14.0  # mm: lines that are one to the eye; middles that differ by less look as if they were to agree
MOST = 0.5  # of the smaller of two figures, by which they stand side by side, or one above the other
_TITLE, _MIDDLE, _NESTED, _BACK, _ROW = 0.04, 0.01, 0.03, 0.04, 0.06  # for each
_MARGIN, _TIGHT = 0.1, 0.01  # by their difference; for each mm of white that lacks
APART = 0.5  # what each pair is worth that stands together


def standing_cost(boxes: Sequence[Rect], lines: Sequence[float], layout: Layout) -> float:
    """All but the white. lines: on which height the titles stand."""
    pairs = [*combinations(range(len(boxes)), 2)]
    uneven = sum(_off_line(n, boxes, lines) for n in range(len(boxes)))
    askew = sum(_askew(boxes[i], boxes[k]) for i, k in pairs)
    back = sum(after.y0 > before.y1 for before, after in pairwise(boxes))
    lacking = max(0.0, CROWDED - max(layout.white, 0.0))
    rows = sum(high - low > SAME for low, high in pairwise(sorted(lines)))  # but the first: one row is read most easily
    looks = _TITLE * uneven + _MIDDLE * askew + _BACK * back + _ROW * rows + _MARGIN * _margins(boxes, layout.page)
    return looks + _NESTED * (layout.nested - layout.table) + _TIGHT * lacking - APART * layout.together


def _off_line(n: int, boxes: Sequence[Rect], lines: Sequence[float]) -> bool:
    """Whether a figure stands beside others and its title on a line with none of them."""
    beside = [k for k, box in enumerate(boxes) if k != n and _beside(boxes[n], box)]
    return bool(beside) and all(abs(lines[n] - lines[k]) > SAME for k in beside)


def _beside(a: Rect, b: Rect) -> bool:
    return min(a.y1, b.y1) - max(a.y0, b.y0) > MOST * min(a.height, b.height)


def _askew(a: Rect, b: Rect) -> bool:
    """Whether of two figures, one above the other, the middles all but agree."""
    above = min(a.y1, b.y1) - max(a.y0, b.y0) < 0 < min(a.x1, b.x1) - max(a.x0, b.x0) - MOST * min(a.width, b.width)
    return above and SAME < abs(a.centre.real - b.centre.real) < NEAR


def _margins(boxes: Sequence[Rect], page: Size) -> float:
    """How unlike the margins to the left and right are, and those above and below."""
    left, right = min(box.x0 for box in boxes), page[0] - max(box.x1 for box in boxes)
    low, high = min(box.y0 for box in boxes), page[1] - max(box.y1 for box in boxes)
    return abs(left - right) / page[0] + abs(low - high) / page[1]
