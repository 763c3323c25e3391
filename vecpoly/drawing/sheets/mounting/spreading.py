"""Figures of a page that is cut into pieces spread over it: its white goes evenly to the figures."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import inf

from ...scene import Rect
from ..slicing import TOUCH, Cut, Piece, Size

CLOSE = 18.0  # mm: titles of a row differ by no more; a figure goes down so far even from a line that others share
LOWER = 0.5  # mm by which letters of a scale may reach lower than those of the lowest figure
HANG = 1.5  # mm by which letters of titles on one line hang lower than others

Box = tuple[float, float, float, float]  # left, top (downwards from the upper edge), width, height


def spread(piece: Piece, sizes: Sequence[Size], page: Size) -> list[complex]:
    """Where the lower left corner of each figure stands on a page of this size, whose lower left corner is 0."""
    corners = [0j] * len(sizes)
    _spread(piece, (0.0, 0.0, *page), sizes, corners)
    return [complex(at.real, page[1] - at.imag) for at in corners]


def least(piece: Piece, sizes: Sequence[Size]) -> Size:
    """Width and height without any white."""
    if not isinstance(piece, Cut):
        return sizes[piece]
    parts = [least(one, sizes) for one in piece.pieces]
    wide, high = [w for w, _ in parts], [h for _, h in parts]
    return (max(wide), sum(high)) if piece.down else (sum(wide), max(high))


def _spread(piece: Piece, box: Box, sizes: Sequence[Size], corners: list[complex]) -> None:
    """Corners as complex(left, lower edge from above)."""
    left, top, width, height = box
    if not isinstance(piece, Cut):
        w, h = sizes[piece]
        corners[piece] = complex(left + (width - w) / 2, top + (height + h) / 2)
        return
    cells = _cells(piece, (width, height), sizes)
    table = _columns(piece, width, sizes)
    at = top if piece.down else left
    for part, cell in zip(piece.pieces, cells, strict=True):
        if not piece.down:
            _spread(part, (at, top, cell, height), sizes, corners)
        elif table:
            _in_columns(part, table, (left, at, width, cell), sizes, corners)
        else:
            _spread(part, (left, at, width, cell), sizes, corners)
        at += cell
    if not piece.down:
        _on_one_line(piece, sizes, corners)


def _cells(cut: Cut, room: Size, sizes: Sequence[Size]) -> list[float]:
    """How long each piece is along the cut: what it needs, and its share of the white by its figures in a row."""
    along = 1 if cut.down else 0
    needs = [least(part, sizes)[along] for part in cut.pieces]
    shares = [_deep(part, cut.down) for part in cut.pieces]
    free = room[along] - sum(needs)
    return [need + free * share / sum(shares) for need, share in zip(needs, shares, strict=True)]


def _deep(piece: Piece, down: bool) -> int:
    """How many figures stand one behind the other in this direction."""
    if not isinstance(piece, Cut):
        return 1
    parts = [_deep(one, down) for one in piece.pieces]
    return sum(parts) if piece.down is down else max(parts)


def _columns(cut: Cut, width: float, sizes: Sequence[Size]) -> list[float]:
    """The columns of a table that rows of as many figures make where they fit; none else."""
    rows = [part.pieces for part in cut.pieces if isinstance(part, Cut) and not part.down]
    if not cut.down or len(rows) < len(cut.pieces) or len({len(row) for row in rows}) > 1:
        return []
    if any(isinstance(one, Cut) for row in rows for one in row):
        return []
    columns = [max(sizes[one][0] for one in column) for column in zip(*rows, strict=True)]
    free = (width - sum(columns)) / len(columns)
    return [column + free for column in columns] if free >= -TOUCH else []


def _in_columns(row: Piece, table: Sequence[float], box: Box, sizes: Sequence[Size], corners: list[complex]) -> None:
    """A row of figures, each in its column."""
    assert isinstance(row, Cut)
    left, top, _, height = box
    for part, wide in zip(row.pieces, table, strict=True):
        _spread(part, (left, top, wide, height), sizes, corners)
        left += wide
    _on_one_line(row, sizes, corners)


def _on_one_line(row: Cut, sizes: Sequence[Size], corners: list[complex]) -> None:
    """The figures of a row stand on the line of the tallest, so that their titles do."""
    alone = [one for one in row.pieces if not isinstance(one, Cut)]
    if alone:
        line = max(corners[one].imag for one in alone)
        for one in alone:
            corners[one] = complex(corners[one].real, line)


def sunk(boxes: Sequence[Rect], lines: Sequence[float], still: Sequence[Rect], clear: float) -> list[float]:
    """By how much each figure sinks, so that the titles of those side by side stand on one line.

    A figure goes down to the next lower line of a neighbour where it keeps this clear (mm) of all others and of what
    stands still, and no lower than the lowest; or else up. lines: on which height the titles stand.
    """
    now, at = list(boxes), list(lines)
    floor = min((box.y0 for box in boxes), default=0.0) - LOWER
    for i in sorted(range(len(now)), key=lambda one: lines[one]):
        lower = {at[k] for k in range(len(now)) if k != i and at[k] <= at[i] and now[k].y1 > now[i].y0}
        close = {line for line in lower if TOUCH < at[i] - line < CLOSE}
        ways = (*sorted(close, reverse=True), *sorted(lower - close, reverse=True))
        _hang(now, at, i, ways, still, clear, (floor, inf))
    _rise(now, at, still, clear)
    return [old - new for old, new in zip(lines, at, strict=True)]


def _rise(now: list[Rect], at: list[float], still: Sequence[Rect], clear: float) -> None:
    """A figure whose title stands alone goes up to the next higher line of a neighbour where it keeps clear, and no
    higher than the highest."""
    ceiling = max((box.y1 for box in now), default=0.0) + HANG
    for i, box in enumerate(now):
        others = [k for k in range(len(now)) if k != i]
        if any(abs(at[k] - at[i]) < TOUCH for k in others):
            continue
        beside = [k for k in others if now[k].y0 < box.y1 and box.y0 < now[k].y1]
        _hang(now, at, i, sorted({at[k] for k in beside if at[k] > at[i]}), still, clear, (-inf, ceiling))


def _hang(
    now: list[Rect],
    at: list[float],
    i: int,
    lines: Iterable[float],
    still: Sequence[Rect],
    clear: float,
    within: tuple[float, float],
) -> None:
    """Figure i goes to the first of these lines where it keeps clear of all others, and within these heights."""
    others = [*(box for k, box in enumerate(now) if k != i), *still]
    for line in lines:
        box = now[i].moved(1j * (line - at[i]))
        near = box.grown(clear - TOUCH)
        if within[0] <= box.y0 and box.y1 <= within[1] and not any(near.overlaps(other) for other in others):
            now[i], at[i] = box, line
            return
