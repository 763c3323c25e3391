"""A page cut by straight lines, across and down, until each piece holds one figure: which boxes the cuts can make.

Figures keep their order of reading: each stands to the right of the one before it, or below it. Of all ways to cut only
those are kept that no other betters in width and in height at once (Stockmeyer's shape curves); with them every row of
figures is found by joining two curves, not by trying all cuts.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from operator import itemgetter

from ...foundation.slotted import replace

Size = tuple[float, float]
Pair = tuple[int, int]
TOUCH = 1e-6  # mm: figures that touch do not overlap


@dataclass(frozen=True, slots=True)
class Cut:
    """Pieces side by side, or one below the other; a piece is a figure's number, or cut again."""

    down: bool
    pieces: tuple[Piece, ...]


Piece = int | Cut
Shape = tuple[float, float, Piece]
Curve = tuple[Shape, ...]  # from the narrowest and tallest to the widest and lowest
Trial = tuple[float, float, bool, Piece, Piece]  # two pieces side by side or stacked, of which no cut is made yet


@dataclass(slots=True)
class Slicing:
    """The shapes of figures in order, on pages no wider and no higher than `room`.

    tied: pairs of neighbours that no cut may part from each other; an interval that holds only one of a pair has no
    shape unless it is that one alone. abreast: the pairs stand side by side, not one below the other. by_rows: only
    what is one row stands to the left of anything, so that figures are read row by row; no column before another.
    """

    sizes: Sequence[Size]
    room: Size
    tied: frozenset[Pair] = frozenset()
    abreast: bool = False
    by_rows: bool = False
    _curves: dict[Pair, Curve] = field(default_factory=dict)
    _read: Slicing | None = None

    @property
    def read(self) -> Slicing:
        """The same row by row."""
        if self._read is None:
            self._read = replace(self, by_rows=True, _curves={})
        return self._read

    def shapes(self, start: int, end: int) -> Curve:
        """Every box that figures start, ..., end − 1 can fill and none betters; none where the page is too small."""
        if (start, end) not in self._curves:
            self._curves[start, end] = self._found(start, end)
        return self._curves[start, end]

    def _found(self, start: int, end: int) -> Curve:
        if end - start == 1:
            (w, h), (width, height) = self.sizes[start], self._most
            return ((w, h, start),) if w <= width and h <= height else ()
        if not self._whole(start, end):
            return ()
        found: list[Trial] = []
        for middle in range(start + 1, end):
            before, after = self.shapes(start, middle), self.shapes(middle, end)
            if before and after:
                found += _side_by_side(self._rows(before), after)
                found += () if self.abreast and (start, end - 1) in self.tied else _stacked(before, after)
        return self._within(found)

    def _rows(self, curve: Curve) -> Curve:
        """Those that may stand to the left of others."""
        return tuple(one for one in curve if is_row(one[2])) if self.by_rows else curve

    def _whole(self, start: int, end: int) -> bool:
        """Whether no pair is torn by the ends."""
        return (start - 1, start) not in self.tied and (end - 1, end) not in self.tied

    @property
    def _most(self) -> Size:
        return self.room[0] + TOUCH, self.room[1] + TOUCH

    def _within(self, trials: list[Trial]) -> Curve:
        """Those that fit the page and that none betters, cut."""
        width, height = self._most
        kept: list[Shape] = []
        for w, h, down, a, b in sorted((one for one in trials if one[0] <= width and one[1] <= height), key=_BOX):
            if not kept or h < kept[-1][1] - TOUCH:
                kept.append((w, h, _cut(down, a, b)))
        return tuple(kept)


_BOX = itemgetter(0, 1)


def _side_by_side(left: Curve, right: Curve) -> list[Trial]:
    """Widths add up, the taller one tells the height."""
    found: list[Trial] = []
    i = j = 0
    while i < len(left) and j < len(right):
        (w, h, a), (v, g, b) = left[i], right[j]
        found.append((w + v, max(h, g), False, a, b))
        i, j = (i + 1 if h >= g else i), (j + 1 if g >= h else j)
    return found


def _stacked(upper: Curve, lower: Curve) -> list[Trial]:
    """Heights add up, the wider one tells the width."""
    found: list[Trial] = []
    i, j = len(upper) - 1, len(lower) - 1
    while i >= 0 and j >= 0:
        (w, h, a), (v, g, b) = upper[i], lower[j]
        found.append((max(w, v), h + g, True, a, b))
        i, j = (i - 1 if w >= v else i), (j - 1 if v >= w else j)
    return found


def _cut(down: bool, a: Piece, b: Piece) -> Cut:
    """Two pieces cut apart; a row beside a piece is a longer row."""
    return Cut(down, (*_pieces(down, a), *_pieces(down, b)))


def is_row(piece: Piece) -> bool:
    """Whether nothing in it stands below anything else."""
    return not isinstance(piece, Cut) or (not piece.down and all(map(is_row, piece.pieces)))


def is_read(piece: Piece) -> bool:
    """Whether its figures are read row by row: no column stands to the left of anything."""
    if not isinstance(piece, Cut):
        return True
    return all(map(is_read, piece.pieces)) and (piece.down or all(map(is_row, piece.pieces[:-1])))


def is_table(piece: Piece) -> bool:
    """Whether it is cut into rows, or columns, of as many figures each."""
    if not isinstance(piece, Cut):
        return False
    parts = [one.pieces if isinstance(one, Cut) else (one,) for one in piece.pieces]
    return len({len(one) for one in parts}) == 1 < len(parts[0]) and depth(piece) == 2


def depth(piece: Piece) -> int:
    """How often a piece is cut within a piece: 1 for a row, 2 for a column of rows."""
    return 1 + max(depth(one) for one in piece.pieces) if isinstance(piece, Cut) else 0


def _pieces(down: bool, piece: Piece) -> tuple[Piece, ...]:
    return piece.pieces if isinstance(piece, Cut) and piece.down is down else (piece,)
