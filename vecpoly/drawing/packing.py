"""Where figures stand on a page: all orders in rows and in columns are tried, the one with the most even white wins."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import permutations

from .space import CLEAR

Size = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Layout:
    """Lower left corners of figures on a page of this size, and the least white left between them."""

    page: Size
    corners: tuple[complex, ...]
    white: float


def pack(sizes: Sequence[Size], page: Size) -> Layout | None:
    """The best arrangement of all figures on one page; the first keeps the upper left place. None: they do not fit."""
    found = [layout for shelves in _arrangements(len(sizes))
             for layout in (_rows(sizes, shelves, page), _columns(sizes, shelves, page)) if layout is not None]
    in_order = [layout for layout in found if _reads(sizes, layout)]
    return max(in_order or found, key=lambda layout: round(layout.white, 6), default=None)


def _reads(sizes: Sequence[Size], layout: Layout) -> bool:
    """Whether each figure stands to the right of the one before it, or below it."""
    pairs = zip(range(len(sizes)), range(1, len(sizes)), strict=False)
    c = layout.corners
    return all(c[j].real >= c[i].real + sizes[i][0] or c[j].imag + sizes[j][1] <= c[i].imag for i, j in pairs)


def _arrangements(n: int) -> Iterator[tuple[tuple[int, ...], ...]]:
    """Every way to set figures 0 .. n-1 on shelves, figure 0 first."""
    for rest in permutations(range(1, n)):
        order = (0, *rest)
        for cuts in range(1 << (n - 1)):
            shelves: list[tuple[int, ...]] = [(0,)]
            for i, figure in enumerate(order[1:]):
                if cuts >> i & 1:
                    shelves.append((figure,))
                else:
                    shelves[-1] += (figure,)
            yield tuple(shelves)


def _rows(sizes: Sequence[Size], shelves: tuple[tuple[int, ...], ...], page: Size) -> Layout | None:
    """Shelves from top to bottom; the figures of a shelf stand on one line, so that their titles do."""
    corners = [0j] * len(sizes)
    down, gap_y = _spread([max(sizes[i][1] for i in shelf) for shelf in shelves], page[1])
    white = gap_y
    for shelf, (top, height) in zip(shelves, down, strict=True):
        across, gap_x = _spread([sizes[i][0] for i in shelf], page[0])
        white = min(white, gap_x)
        for i, (left, _) in zip(shelf, across, strict=True):
            corners[i] = complex(left, page[1] - top - height)
    return Layout(page, tuple(corners), white) if white >= CLEAR - 1e-6 else None


def _columns(sizes: Sequence[Size], shelves: tuple[tuple[int, ...], ...], page: Size) -> Layout | None:
    """Shelves from left to right, the figures of each one above the other on its middle line."""
    corners = [0j] * len(sizes)
    across, gap_x = _spread([max(sizes[i][0] for i in shelf) for shelf in shelves], page[0])
    white = gap_x
    for shelf, (left, width) in zip(shelves, across, strict=True):
        down, gap_y = _spread([sizes[i][1] for i in shelf], page[1])
        white = min(white, gap_y)
        for i, (top, height) in zip(shelf, down, strict=True):
            corners[i] = complex(left + (width - sizes[i][0]) / 2, page[1] - top - height)
    return Layout(page, tuple(corners), white) if white >= CLEAR - 1e-6 else None


def _spread(lengths: Sequence[float], room: float) -> tuple[list[tuple[float, float]], float]:
    """(start, length) of pieces spread with equal white before, between and after them; and that white."""
    gap = (room - sum(lengths)) / (len(lengths) + 1)
    starts: list[tuple[float, float]] = []
    at = gap
    for length in lengths:
        starts.append((at, length))
        at += length + gap
    return starts, gap
