"""A legend on its sheet: a band over the title strip, for which a plate grows and the figures of a page move up, where
their white allows it; else a block where nothing stands."""

from __future__ import annotations

from collections.abc import Sequence

from ...foundation.slotted import replace
from ...words import Words
from ..scene import Item, Layer, Rect, Stroke, moved
from ..sheets.redbox import BAND
from ..sheets.sheet import Sheet
from ..sheets.space import FRAME, STRIP
from ..style import THIN
from .entry import Entry
from .kinds import FOUND, KNOWN
from .legend import Cell, Grid, band, blocks, cells, entries
from .places import standing

WHITE = 4.0  # mm over and under the figures of a page that keeps a band for its legend
MOST = 0.6  # of the sheet's width that a block may take
ROWS = 4  # of a band on a page: what is higher is a block


def with_legend(sheet: Sheet) -> Sheet:
    """The sheet with what its lines and symbols stand for; without what is plain where it has no room for all; as it is
    where it has no room, or where all is plain."""
    figures = [one.figure for one in sheet.figures if one.figure is not None]
    found = entries(figures, sheet.lang)
    for some in dict.fromkeys((found, _without(found), _without(found, KNOWN.words, FOUND.words))):
        if some and (made := _with(sheet, cells(some, sheet.lang))) is not None:
            return made
    return sheet


def _without(some: Sequence[Entry], *words: Words) -> tuple[Entry, ...]:
    """Without what is plain, and what these words tell."""
    return tuple(one for one in some if not one.plain and one.words not in words)


def _with(sheet: Sheet, some: Sequence[Cell]) -> Sheet | None:
    grid = band(some, sheet.lang, sheet.room[0])
    if sheet.plate:
        wide, high = sheet.room
        grown = replace(_shifted(sheet, 1j * grid.height), room=(wide, high + grid.height))
        return replace(grown, results=_ruled(grid, grown))
    if (made := _over_strip(sheet, grid)) is not None:
        return made
    found = standing(sheet, [*blocks(some, sheet.lang, sheet.room[0] * MOST)])
    return None if found is None else replace(sheet, results=_framed(*found, sheet))


def _over_strip(sheet: Sheet, grid: Grid) -> Sheet | None:
    """With the band, its figures midway between it and the upper edge; None where they would have too little white."""
    low, high = _standing(sheet)
    foot = FRAME + STRIP + grid.height
    head = sheet.size[1] - FRAME - (BAND if sheet.warning is not None else 0.0)
    white = (head - foot - (high - low)) / 2
    if white < WHITE or grid.height > ROWS * 6.0:
        return None
    up = max(foot + white - low, 0.0) if low - FRAME - STRIP < grid.height + white else 0.0
    return replace(_shifted(sheet, 1j * up), results=_ruled(grid, sheet))


def _standing(sheet: Sheet) -> tuple[float, float]:
    """How low and how high its figures reach."""
    boxes: list[Rect] = [one.extents for one in sheet.figures]
    return min(box.y0 for box in boxes), max(box.y1 for box in boxes)


def _shifted(sheet: Sheet, by: complex) -> Sheet:
    """With its figures moved."""
    placed = (replace(one, origin=one.origin + by, extents=one.extents.moved(by)) for one in sheet.figures)
    return replace(sheet, drawn=tuple(moved(item, by) for item in sheet.drawn), figures=tuple(placed))


def _ruled(grid: Grid, sheet: Sheet) -> tuple[Item, ...]:
    """The band where it stands, with the line over it, after the last step."""
    over = 1j * grid.height
    rule = Stroke(points=(over, over + sheet.room[0]), width=THIN, layer=Layer.THIN)
    return _put((rule, *grid.items), complex(FRAME, FRAME + STRIP), sheet)


def _framed(grid: Grid, at: complex, sheet: Sheet) -> tuple[Item, ...]:
    """The block where it stands, in a frame."""
    frame = Stroke(points=Rect(0.0, 0.0, grid.width, grid.height).corners, width=THIN, closed=True, layer=Layer.THIN)
    return _put((frame, *grid.items), at, sheet)


def _put(items: Sequence[Item], at: complex, sheet: Sheet) -> tuple[Item, ...]:
    """There, after the last step."""
    last = max((item.step for item in sheet.drawn), default=0)
    return tuple(replace(moved(item, at), step=last) for item in items)
