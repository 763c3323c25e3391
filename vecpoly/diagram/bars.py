"""The lines of a rigid link: a bar, a plate where its points are not in line, a welded corner (GB/T 4460)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ..board.paper.marks import Mark, Plate, Role, Segment, Weld


def bar(spots: Sequence[complex]) -> Iterator[Mark]:
    """A bar, or a plate where the points are not in line."""
    base = spots[1] - spots[0]
    off = [abs((np.conj(base) * (s - spots[0])).imag) / abs(base) for s in spots[2:]]
    if len(spots) > 2 and max(off) > 0.5:
        yield Plate(points=hull(spots))
    else:
        order = sorted(spots, key=lambda s: (np.conj(base) * (s - spots[0])).real)
        yield Segment(a=order[0], b=order[-1], role=Role.LINK)


def hull(points: Sequence[complex]) -> tuple[complex, ...]:
    """The corners of the smallest convex polygon round the points, counter-clockwise."""
    ordered = sorted(points, key=lambda p: (p.real, p.imag))
    return tuple(_lower(ordered) + _lower(ordered[::-1]))


def _lower(row: Sequence[complex]) -> list[complex]:
    """The corners on the right of the way from the first to the last, without this."""
    kept: list[complex] = []
    for p in row:
        while len(kept) > 1 and ((kept[-1] - kept[-2]).conjugate() * (p - kept[-1])).imag <= 0:
            kept.pop()
        kept.append(p)
    return kept[:-1]


def weld(corner: complex, u: complex, v: complex) -> Weld:
    """The small filled triangle that shows two bars to be one rigid link."""
    return Weld(at=corner, u=u / abs(u), v=v / abs(v))
