"""Breaks of a whole paragraph: what is not to be parted moves to the next line, and the lines before share its room."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import inf

from ....foundation.slotted import replace
from ..cells import Cell, Gap, Kind, gap


def spaces(cells: Sequence[Cell], em: float) -> list[Gap]:
    """The spaces between the cells; no Chinese character stands alone in the last line."""
    gaps = [gap(a, b, em) for a, b in pairwise(cells)]
    last = max((n for n, cell in enumerate(cells) if cell.kind is Kind.HAN), default=0)
    if last and cells[last - 1].kind is Kind.HAN and all(cell.kind is Kind.CLOSE for cell in cells[last + 1 :]):
        gaps[last - 1] = replace(gaps[last - 1], breakable=False)
    return gaps


def balanced(
    cells: Sequence[Cell], gaps: Sequence[Gap], width: float, em: float, first: float, least: float, floor: float = 0.0
) -> list[int]:
    """The index after the last cell of each line, all of them as evenly stretched as may be; none where the cells
    cannot be set in so narrow a measure without a break in what is not to be parted.
    floor: the least width of the last line (mm)."""
    count = len(cells)
    cost, before = [0.0, *[inf] * count], [0] * (count + 1)
    for start in range(count):
        if cost[start] == inf:
            continue
        room = width - (0.0 if start else first)
        for end, price in _lines_from(cells, gaps, start, room, em, least, floor):
            if cost[start] + price < cost[end]:
                cost[end], before[end] = cost[start] + price, start
    ends, at = list[int](), count
    while at and cost[count] < inf:
        ends.append(at)
        at = before[at]
    return ends[::-1]


def _lines_from(
    cells: Sequence[Cell], gaps: Sequence[Gap], start: int, room: float, em: float, least: float, floor: float
) -> list[tuple[int, float]]:
    """Where a line that begins there may end, and what that costs: the square of how far it is stretched."""
    found, used, shrink, stretch = list[tuple[int, float]](), -cells[start].lead, 0.0, 0.0
    for at in range(start, len(cells)):
        used += cells[at].box.width
        natural = used - cells[at].trail
        if natural - shrink > room + 1e-6:
            break
        if at == len(cells) - 1:
            found += [(at + 1, 0.0)] if natural >= floor else []
            break
        if gaps[at].breakable:
            spare = max(0.0, room - natural)
            found.append((at + 1, (spare / (max(stretch, 0.1) * em)) ** 2))
        used += gaps[at].width
        stretch += gaps[at].stretch
        shrink += gaps[at].width * (1 - least) if gaps[at].stretch > 1.0 else 0.0
    return found
