"""Where figures stand on a page: in rows and in columns, as they are read;
the arrangement with the most even white wins."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import permutations

from .space import CAPTION, CLEAR, LETTERING, room_inside

Size = tuple[float, float]
Pair = tuple[int, int]
FEW = 4  # figures of which all orders are tried
TITLE = 25.0  # mm: no figure is narrower than its title
ENOUGH = 6.5  # mm of white between figures that are not crowded
AMPLE = 9.0  # mm of white that leaves nothing to be wished


@dataclass(frozen=True, slots=True)
class Layout:
    """Lower left corners of figures on a page of this size,
    the least white left between them, and how many pairs share a shelf."""

    page: Size
    corners: tuple[complex, ...]
    white: float
    together: int = 0


def pack(sizes: Sequence[Size], page: Size, pairs: Sequence[Pair] = ()) -> Layout | None:
    """The best arrangement of all figures on one page; the first keeps the upper left place. None: they do not fit.

    pairs: figures that belong side by side.
    Few figures may leave the order of reading where they fit in no other way; many do not.
    """
    if sum((w + CLEAR) * (h + CLEAR) for w, h in sizes) > (page[0] - CLEAR) * (page[1] - CLEAR) + 1e-6:
        return None
    found = list(_layouts(sizes, page, pairs))
    in_order = [layout for layout in found if _reads(sizes, layout)]
    most = (
        AMPLE if pairs else max(page)
    )  # rows come first: with ample white, pairs stand side by side rather than one above the other
    return max(in_order or found, key=lambda layout: (layout.together, round(min(layout.white, most), 6)), default=None)


def fits_sheet(sizes: Sequence[Size], landscape: bool = False) -> bool:
    """Whether figures whose bare lines have these sizes go on one sheet, upright or across, with their lettering and
    titles, and some white to spare."""
    lettered = [(max(w, TITLE) + 2 * LETTERING, h + LETTERING + CAPTION) for w, h in sizes]
    layout = pack(lettered, room_inside(landscape))
    return layout is not None and layout.white >= ENOUGH


def _layouts(sizes: Sequence[Size], page: Size, pairs: Sequence[Pair]) -> Iterator[Layout]:
    rest = range(1, len(sizes))
    orders = permutations(rest) if len(sizes) <= FEW else [tuple(rest)]
    widths, heights = [w for w, _ in sizes], [h for _, h in sizes]
    for order in orders:
        for lengths, room, arrange in ((widths, page[0], _rows), (heights, page[1], _columns)):
            for shelves in _shelves((0, *order), lengths, room):
                together = sum(any(i in shelf and j in shelf for shelf in shelves) for i, j in pairs)
                layout = arrange(sizes, shelves, page, together)
                if layout is not None:
                    yield layout


def _reads(sizes: Sequence[Size], layout: Layout) -> bool:
    """Whether each figure stands to the right of the one before it, or below it."""
    pairs = zip(range(len(sizes)), range(1, len(sizes)), strict=False)
    c = layout.corners
    return all(c[j].real >= c[i].real + sizes[i][0] or c[j].imag + sizes[j][1] <= c[i].imag for i, j in pairs)


Shelves = tuple[tuple[int, ...], ...]


def _shelves(order: tuple[int, ...], lengths: Sequence[float], room: float) -> Iterator[Shelves]:
    """Every way to cut the order into shelves that are no longer than the room."""
    if not order:
        yield ()
    taken = CLEAR - 1e-6
    for count, figure in enumerate(order, start=1):
        taken += lengths[figure] + CLEAR
        if taken > room:
            return
        for rest in _shelves(order[count:], lengths, room):
            yield (order[:count], *rest)


def _rows(sizes: Sequence[Size], shelves: Shelves, page: Size, together: int) -> Layout | None:
    """Shelves from top to bottom; the figures of a shelf stand on one line,
    so that their titles do, and like shelves in columns."""
    corners = [0j] * len(sizes)
    down, gap_y = _spread([max(sizes[i][1] for i in shelf) for shelf in shelves], page[1])
    table, gap_table = _spread([max(sizes[i][0] for i in column) for column in zip(*shelves, strict=False)], page[0])
    aligned = len({len(shelf) for shelf in shelves}) == 1 and gap_table >= CLEAR - 1e-6
    white = gap_y
    for shelf, (top, height) in zip(shelves, down, strict=True):
        across, gap_x = (table, gap_table) if aligned else _spread([sizes[i][0] for i in shelf], page[0])
        white = min(white, gap_x)
        for i, (left, width) in zip(shelf, across, strict=True):
            corners[i] = complex(left + (width - sizes[i][0]) / 2, page[1] - top - height)
    return Layout(page, tuple(corners), white, together) if white >= CLEAR - 1e-6 else None


def _columns(sizes: Sequence[Size], shelves: Shelves, page: Size, together: int) -> Layout | None:
    """Shelves from left to right, the figures of each one above the other on its middle line."""
    corners = [0j] * len(sizes)
    across, gap_x = _spread([max(sizes[i][0] for i in shelf) for shelf in shelves], page[0])
    white = gap_x
    for shelf, (left, width) in zip(shelves, across, strict=True):
        down, gap_y = _spread([sizes[i][1] for i in shelf], page[1])
        white = min(white, gap_y)
        for i, (top, height) in zip(shelf, down, strict=True):
            corners[i] = complex(left + (width - sizes[i][0]) / 2, page[1] - top - height)
    return Layout(page, tuple(corners), white, together) if white >= CLEAR - 1e-6 else None


def _spread(lengths: Sequence[float], room: float) -> tuple[list[tuple[float, float]], float]:
    """(start, length) of pieces spread with equal white before, between and after them; and that white."""
    gap = (room - sum(lengths)) / (len(lengths) + 1)
    starts: list[tuple[float, float]] = []
    at = gap
    for length in lengths:
        starts.append((at, length))
        at += length + gap
    return starts, gap
