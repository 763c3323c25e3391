"""Where figures stand on a page: in the order of reading, spread over it;
the arrangement with the most even white wins."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from ...foundation.slotted import dataclass
from .mounting.spreading import spread
from .slicing import Pair, Piece, Shape, Size, Slicing, depth, is_read, is_table
from .space import HIGHEST, PLATE

TIGHT = 2.5  # mm of white between figures, and to the frame, at least: what is planned leaves more
AROUND = 8.0  # mm of white about the figures of a plate, on both sides together
NEARLY = 5.5  # mm of white less that figures may have for being read row by row
LITTLE = 0.06  # of a plate that may be left white for it
AMPLE = 11.0  # mm of white that leaves nothing to be wished: then the plainest arrangement is the best


@dataclass(frozen=True, slots=True)
class Layout:
    """Lower left corners of figures on a page of this size,
    the least white left between them, how many pairs stand side by side or one above the other, how much deeper
    the page is cut than into rows, or columns, and whether it is a table of rows with as many figures each."""

    page: Size
    corners: tuple[complex, ...]
    white: float
    together: int = 0
    nested: int = 0
    table: bool = False

    def share(self, sizes: Sequence[Size]) -> float:
        """What the box about all figures takes of the page's area."""
        lefts, feet = [c.real for c in self.corners], [c.imag for c in self.corners]
        wide = max(x + w for x, (w, _) in zip(lefts, sizes, strict=True)) - min(lefts)
        high = max(y + h for y, (_, h) in zip(feet, sizes, strict=True)) - min(feet)
        return wide * high / (self.page[0] * self.page[1])


def padded(sizes: Sequence[Size], clear: float = TIGHT) -> list[Size]:
    """With the white that belongs to each figure; the page loses as much at its edges."""
    return [(w + clear, h + clear) for w, h in sizes]


def inner(page: Size, clear: float = TIGHT) -> Size:
    """What a page offers to figures with their white."""
    return page[0] - clear, page[1] - clear


def pack(sizes: Sequence[Size], page: Size, pairs: Sequence[Pair] = ()) -> Layout | None:
    """The best arrangement of all figures on one page; the first keeps the upper left place. None: they do not fit.

    pairs: neighbours that belong side by side; they are parted only where they fit in no other way.
    """
    for slicing in slicings(sizes, page, frozenset(pairs)):
        if (found := packed(slicing, 0, len(sizes), sizes, page)) is not None:
            return found
    return None


def slicings(sizes: Sequence[Size], page: Size, pairs: frozenset[Pair]) -> tuple[Slicing, ...]:
    """The ways to cut a page, the better first: pairs side by side, pairs together, pairs parted."""
    around, within = padded(sizes), inner(page)
    apart = Slicing(around, within)
    return (Slicing(around, within, pairs, True), Slicing(around, within, pairs), apart) if pairs else (apart,)


def packed(slicing: Slicing, start: int, end: int, sizes: Sequence[Size], page: Size) -> Layout | None:
    """The best arrangement of some figures of a slicing on a page, read row by row where that is nearly as good;
    None: they do not fit."""
    free, in_order = _best(slicing, start, end, sizes, page)
    if free is None or in_order:
        return free
    rows, _ = _best(slicing.read, start, end, sizes, page)
    return free if rows is None or rows.white < min(free.white, AMPLE) - NEARLY else rows


def _best(slicing: Slicing, start: int, end: int, sizes: Sequence[Size], page: Size) -> tuple[Layout | None, bool]:
    """The arrangement with most white, of like ones the plainest, and whether it is read row by row."""
    together = sum(start <= i and j < end for i, j in slicing.tied)
    pieces = [piece for _, _, piece in slicing.shapes(start, end)]
    made = [(_layout(piece, (start, end), sizes, slicing.sizes, page, together), piece) for piece in pieces]
    found = max(made, key=lambda one: (min(one[0].white, AMPLE), -depth(one[1]), one[0].white), default=None)
    return (None, True) if found is None else (found[0], is_read(found[1]))


def layouts(sizes: Sequence[Size], page: Size, pairs: frozenset[Pair]) -> Iterator[Layout]:
    """All figures on one page, in every arrangement that none betters, and in those that are read row by row; pairs
    are parted only where they fit in no other way."""
    for slicing in slicings(sizes, page, pairs):
        shapes = dict.fromkeys((*slicing.shapes(0, len(sizes)), *slicing.read.shapes(0, len(sizes))))
        for _, _, piece in shapes:
            yield _layout(piece, (0, len(sizes)), sizes, slicing.sizes, page, len(slicing.tied))
        if shapes:
            return


def flat(
    sizes: Sequence[Size], pairs: frozenset[Pair] = frozenset(), most: Size = (PLATE, HIGHEST), *, in_rows: bool = False
) -> Layout | None:
    """The figures on a plate no larger than they need; None where it would be wider or higher than this.

    in_rows: one that is read row by row, or none.
    """
    for slicing in slicings(sizes, most, pairs):
        made = _plates(slicing.read if in_rows else slicing, sizes, most[0])
        if made:
            least = max(layout.share(sizes) for layout in made) - LITTLE
            wide = [layout for layout in _plates(slicing.read, sizes, most[0]) if layout.share(sizes) >= least]
            return max(wide or made, key=lambda layout: layout.share(sizes))
    return None


def _plates(slicing: Slicing, sizes: Sequence[Size], widest: float) -> list[Layout]:
    """All figures on a plate, in every shape."""
    return [_plate(shape, sizes, len(slicing.tied), widest) for shape in slicing.shapes(0, len(sizes))]


def _plate(shape: Shape, sizes: Sequence[Size], together: int, widest: float) -> Layout:
    _, high, piece = shape
    page = (widest, high + AROUND)
    return _layout(piece, (0, len(sizes)), sizes, padded(sizes), page, together)


def _layout(
    piece: Piece, which: Pair, sizes: Sequence[Size], around: Sequence[Size], page: Size, together: int
) -> Layout:
    """Some of these figures, from one to before another; around: their sizes with their white."""
    start, end = which
    corners = spread(piece, around, inner(page))
    placed = tuple([at + complex(TIGHT, TIGHT) for at in corners[start:end]])
    return Layout(
        page, placed, _white(placed, sizes[start:end], page), together, max(0, depth(piece) - 2), is_table(piece)
    )


def _white(corners: Sequence[complex], sizes: Sequence[Size], page: Size) -> float:
    """The least white between two figures, or twice that to an edge: pages are spread so that both are alike."""
    boxes = [(c.real, c.imag, c.real + w, c.imag + h) for c, (w, h) in zip(corners, sizes, strict=True)]
    edges = 2 * min(min(x0, y0, page[0] - x1, page[1] - y1) for x0, y0, x1, y1 in boxes)
    between = [max(x0 - u1, u0 - x1, y0 - v1, v0 - y1) for (x0, y0, x1, y1), (u0, v0, u1, v1) in combinations(boxes, 2)]
    return min(edges, *between) if between else edges
