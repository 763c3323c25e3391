"""Where a legend has room on a sheet: a block on no ink, in a corner of the frame, along it, or between the figures; a
band under figures that are laid out anew, closer together."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise

import numpy as np

from ...foundation.slotted import replace
from ..details.room import CELL, Room, Spots, filled, spread
from ..scene import Item, Rect, TextBox
from ..sheets.boxes.redbox import BAND
from ..sheets.packing import pack
from ..sheets.pages import pairs_of
from ..sheets.settling.settled import settled
from ..sheets.sheet import Sheet, placed
from ..sheets.space import FRAME, STRIP
from .legend import Grid

MARGIN, CLEAR = 4.0, 3.5  # mm of white to the frame; to whatever stands on the sheet
OVER = 60.0  # mm from a corner that a place beside all figures is worth
LATER = 0.01  # mm for each mm that it stands farther from the lower right corner


def over_band(sheet: Sheet, height: float, white: float) -> Sheet | None:
    """The sheet with its figures in what a band of this height leaves of it, with so much white between them at least
    (mm); None where they find no room."""
    group, (wide, high) = sheet.groups, sheet.room
    rest = wide, high - height - (BAND if sheet.warning is not None else 0.0)
    layout = pack([one.size for one in group], rest, tuple(pairs_of(group)))
    if layout is None or layout.white < white:
        return None
    low = settled(group, layout)
    risen = replace(low, page=sheet.room, corners=tuple(at + 1j * height for at in low.corners))
    return placed(group, risen, sheet.strip, sheet.lang, sheet.warning)


def standing(sheet: Sheet, grids: Iterable[Grid]) -> tuple[Grid, complex] | None:
    """The first of these for which the sheet has room, and its lower left corner."""
    room = _room(sheet)
    for grid in grids:
        if (at := _place(sheet, room, grid)) is not None:
            return grid, at
    return None


def _room(sheet: Sheet) -> Room:
    """What of the sheet is taken, cell by cell."""
    high = sheet.size[1] - FRAME - (BAND if sheet.warning is not None else 0.0)
    inside = Rect(FRAME, FRAME + STRIP, sheet.size[0] - FRAME, high).grown(CLEAR - MARGIN)
    every = (*sheet.drawn, *sheet.results)
    lines = spread(np.array([ends for item in every for ends in _lines(item)], dtype=complex).reshape(-1, 2))
    texts = [filled(item.rect) for item in every if isinstance(item, TextBox)]
    return Room.about(inside, (lines, *texts), 0.0)


def _lines(item: Item) -> Iterator[tuple[complex, complex]]:
    if not isinstance(item, TextBox):
        yield from pairwise((*item.points, item.points[0]) if getattr(item, "closed", True) else item.points)


def _place(sheet: Sheet, room: Room, grid: Grid) -> complex | None:
    """As near to a corner of the frame as it goes, rather to the lower right one; between figures it overlaps none."""
    e = room.extents.grown(-CLEAR)
    found = room.free(grid.width + 2 * CLEAR, grid.height + 2 * CLEAR) + CLEAR * (1 + 1j)
    right, up = e.x1 - grid.width, e.y1 - grid.height
    found = found[(found.real < right + CELL) & (found.imag < up + CELL)]
    across, along = np.minimum(found.real - e.x0, right - found.real), np.minimum(found.imag - e.y0, up - found.imag)
    over = _over(sheet, found, grid)
    good = (np.minimum(across, along) < CELL) | ~over
    if not good.any():
        return None
    cost = across + along + LATER * (right - found.real + found.imag - e.y0) + OVER * over
    at = complex(found[good][np.argmin(cost[good])])
    return complex(_snapped(at.real, e.x0, right), _snapped(at.imag, e.y0, up))


def _over(sheet: Sheet, at: Spots, grid: Grid) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Whether it would stand in the rectangle of a figure, place by place."""
    taken = np.zeros(len(at), dtype=bool)
    for one in sheet.figures:
        r = one.extents
        beside = (at.real > r.x1) | (at.real + grid.width < r.x0)
        taken |= ~(beside | (at.imag > r.y1) | (at.imag + grid.height < r.y0))
    return taken


def _snapped(at: float, low: float, high: float) -> float:
    """On the margin where it is within a cell of it."""
    return low if abs(at - low) < CELL else high if abs(at - high) < CELL else at
