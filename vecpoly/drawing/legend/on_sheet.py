"""A legend on its sheet: a band over the title strip, for which a plate grows and the figures of a page move up, where
their white allows it; else a block where nothing stands."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain

from ...foundation.slotted import replace
from ..scene import Item, Layer, Rect, Stroke, moved
from ..sheets.boxes.redbox import BAND
from ..sheets.packing import TIGHT
from ..sheets.sheet import Sheet
from ..sheets.space import FRAME, STRIP
from ..style import THIN
from .legend import Cell, Grid, band, blocks, cells, entries
from .moved_up import over_band
from .places import standing
from .vectors import key_of_vectors

WHITE = 4.0  # mm over and under the figures of a page that keeps a band for its legend
MOST = 0.6  # of the sheet's width that a block may take
LEAST = 3.5  # mm of white between figures that are laid out anew over a band
BLOCKS = 3  # into which a legend is parted at most
ROWS = 4  # of a band on a page: what is higher is a block


def with_legend(sheet: Sheet) -> Sheet:
    """The sheet with what its lines and symbols stand for: on a band; else on one without what is plain; else on these
    with the figures laid out anew, closer together; else, with both, on a block; else on a band, with the figures as
    close as they may stand; else parted on two blocks or three, of the inks of vectors and of the rest where they have
    room so; else as much of it as has room; as it is where all is plain, or nothing has room."""
    figures = [one.figure for one in sheet.figures if one.figure is not None]
    found = entries(figures, sheet.lang)
    told = [one for one in found if not one.plain]
    sets = [cells(some, sheet.lang) for some in (found, told) if some]
    if sheet.plate:
        return _grown(sheet, band(sets[0], sheet.lang, sheet.room[0])) if sets else sheet
    grids = [band(some, sheet.lang, sheet.room[0]) for some in sets]
    bands = (made for way in (_over_strip, _laid_anew) for grid in grids if (made := way(sheet, grid)) is not None)
    if (banded := next(bands, None)) is not None or not sets:
        return banded or sheet
    if (blocked := _with_block(sheet, sets)) is not sheet:
        return blocked
    tight = (_laid_anew(sheet, grid, TIGHT) for grid in grids)
    inks = len([*key_of_vectors(figures, sheet.lang)])
    split = (_parted(sheet, some, inks, most) for most in range(2, BLOCKS + 1) for some in sets)
    return next((one for one in chain(tight, split) if one is not None), None) or _as_many(sheet, sets[-1])


def _parted(sheet: Sheet, some: Sequence[Cell], inks: int, most: int = BLOCKS) -> Sheet | None:
    """All of these on so many blocks at most, of so many inks of vectors and of the rest where they have room so; None
    where they have none."""
    if not some or most < 1:
        return None if some else sheet
    for first in sorted(range(1, len(some) + 1), key=lambda count: abs(count - inks)):
        one = _with_block(sheet, (some[:first],))
        if one is not sheet and (made := _parted(one, some[first:], len(some) - first, most - 1)) is not None:
            return made
    return None


def _as_many(sheet: Sheet, some: Sequence[Cell], most: int = BLOCKS) -> Sheet:
    """As many of these, in order, as have room on so many blocks."""
    for count in range(len(some), 0, -1) if most else ():
        if (one := _with_block(sheet, (some[:count],))) is not sheet:
            return _as_many(one, some[count:], most - 1)
    return sheet


def _grown(plate: Sheet, grid: Grid) -> Sheet:
    """A plate, higher by the band."""
    wide, high = plate.room
    grown = replace(_shifted(plate, 1j * grid.height), room=(wide, high + grid.height))
    return replace(grown, results=_ruled(grid, grown))


def _with_block(sheet: Sheet, sets: Sequence[Sequence[Cell]]) -> Sheet:
    """With the first of these that has room beside the others; as it is where none has."""
    found = standing(sheet, (one for some in sets if some for one in blocks(some, sheet.lang, sheet.room[0] * MOST)))
    return sheet if found is None else replace(sheet, results=(*sheet.results, *_framed(*found, sheet)))


def _over_strip(sheet: Sheet, grid: Grid) -> Sheet | None:
    """With the band, its figures midway between it and the upper edge; None where they would have too little white."""
    low, high = _standing(sheet)
    foot = FRAME + STRIP + grid.height
    head = sheet.size[1] - FRAME - (BAND if sheet.warning is not None else 0.0)
    white = (head - foot - (high - low)) / 2
    if white < WHITE or grid.height > ROWS * 6.0:
        return None
    return replace(_shifted(sheet, 1j * (foot + white - low)), results=_ruled(grid, sheet))


def _laid_anew(sheet: Sheet, grid: Grid, white: float = LEAST) -> Sheet | None:
    """With the band, its figures closer together over it; None where they find no room so."""
    made = over_band(sheet, grid.height, white) if grid.height <= ROWS * 6.0 else None
    return None if made is None else replace(made, results=_ruled(grid, made))


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
