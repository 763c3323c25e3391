"""Where the figures of a sheet stand: in rows, the mechanism first, the arrangement that leaves the most even white."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

from .space import CLEAR, usable

Size = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Arrangement:
    """Lower left corners of the figures inside the usable field (mm), on portrait or landscape paper."""

    corners: tuple[complex, ...]
    landscape: bool
    tightness: float  # the smallest white strip left (mm); larger is better balanced


def arrange(sizes: Sequence[Size], landscape: bool | None = None) -> Arrangement | None:
    """The best arrangement of these figures on one page, or None where none fits."""
    found = [
        fit for wide in ((landscape,) if landscape is not None else (False, True))
        for rows in _row_splits(len(sizes)) for transposed in (False, True)
        if (fit := _fit(sizes, rows, wide, transposed)) is not None
    ]
    return max(found, key=lambda fit: (fit.tightness, not fit.landscape), default=None)


def _row_splits(n: int) -> Iterator[tuple[tuple[int, ...], ...]]:
    """All ways to cut 0 ... n-1 into consecutive rows."""
    for k in range(n):
        for cuts in combinations(range(1, n), k):
            edges = (0, *cuts, n)
            yield tuple(tuple(range(a, b)) for a, b in zip(edges, edges[1:], strict=False))


def _fit(sizes: Sequence[Size], rows: Sequence[Sequence[int]], wide: bool, transposed: bool) -> Arrangement | None:
    """Rows from the top with equal white above, between and below them; within a row equal white between figures.

    transposed: columns instead of rows.
    """
    width, height = usable(wide)
    if transposed:
        width, height = height, width
        sizes = [(h, w) for w, h in sizes]
    deep = [max(sizes[i][1] for i in row) for row in rows]
    down = (height - sum(deep)) / (len(rows) + 1)
    gaps = [(width - sum(sizes[i][0] for i in row)) / (len(row) + 1) for row in rows]
    tight = min(down, *gaps)
    if tight < 0 or any(g < CLEAR / 2 for g, row in zip(gaps, rows, strict=True) if len(row) > 1) or (len(rows) > 1 and down < CLEAR / 2):
        return None
    corners: dict[int, complex] = {}
    top = height
    for row, depth, gap in zip(rows, deep, gaps, strict=True):
        top -= down
        x = gap
        for i in row:
            corners[i] = complex(x, top - depth + (depth - sizes[i][1]) / 2)
            x += sizes[i][0] + gap
        top -= depth
    places = [corners[i] for i in range(len(sizes))]
    if transposed:
        places = [complex(z.imag, width - z.real - sizes[i][0]) for i, z in enumerate(places)]
    return Arrangement(tuple(places), wide, tight)
