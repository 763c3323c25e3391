"""A legend on its sheet: a band over the title strip, for which a plate grows and the figures of a page move up, where
their white allows it; else a block where nothing stands."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from ...board.construction import Figure
from ...foundation.slotted import replace
from ..details.apart import is_detail
from ..scene import Item, Layer, Rect, Stroke, moved
from ..sheets.boxes.redbox import BAND
from ..sheets.packing import TIGHT
from ..sheets.sheet import Sheet
from ..sheets.space import FRAME, STRIP, TALLEST
from ..style import THIN
from .legend import Cell, Grid, band, blocks, cells, entries
from .places import over_band, standing
from .vectors import key_of_vectors

WHITE = 4.0  # mm over and under the figures of a page that keeps a band for its legend
MOST = 0.6  # of the sheet's width that a block may take
LEAST = 3.5  # mm of white between figures that are laid out anew over a band
BLOCKS = 3  # into which a legend is parted at most
ROWS = 4  # of a band on a page: what is higher is a block


def with_legend(sheet: Sheet) -> Sheet:
    """The sheet with what its lines and symbols stand for: on a band; else with the figures laid out anew, closer
    together; else on one with closer rows, or without what is plain, in either way; else with the figures as close as
    they may stand; else, with both, on a block; else parted on two blocks or three, of the inks of vectors and of the
    rest where they have room so; else as much of it as has room; as it is where all is plain, or nothing has room."""
    sets = _sets(sheet)
    if sheet.plate:
        return _on_plate(sheet, sets)
    if (banded := next((made for made, _ in _banded(sheet, sets)), None)) is not None or not sets:
        return banded or sheet
    tight = next((made for made, _ in _tight(sheet, sets)), None)
    return tight or _with_blocks(sheet, sets, _inks(sheet))


def with_legend_under(sheet: Sheet, write: Callable[[Sheet], Sheet]) -> Sheet:
    """The sheet with its legend on a band, and over it what is written there (its results), where both have room; else
    with the legend on a block beside them; else with the legend alone. write: as it is written on a sheet without."""
    sets, written = _sets(sheet), write(sheet)
    if not sets:
        return written
    if sheet.plate:
        return _on_plate(written, sets)
    both = (_written_over(made, grid, write) for made, grid in (*_banded(sheet, sets), *_tight(sheet, sets)))
    if (found := next((one for one in both if one is not None), None)) is not None:
        return found
    blocked = _with_blocks(written, sets, _inks(sheet)) if written.results else written
    return with_legend(sheet) if blocked is written else blocked


def _tight(sheet: Sheet, sets: Sequence[Sequence[Cell]]) -> Iterator[tuple[Sheet, Grid]]:
    """The sheet with a band, its figures as close as they may stand, or the rows of the band, too."""
    grids = (band(some, sheet.lang, sheet.room[0], close=close) for close in (False, True) for some in sets)
    yield from ((made, grid) for grid in grids if (made := _laid_anew(sheet, grid, TIGHT)) is not None)


def _inks(sheet: Sheet) -> int:
    """How many inks of vectors its legend tells."""
    return len([*key_of_vectors(_figures(sheet), sheet.lang)])


def _written_over(made: Sheet, grid: Grid, write: Callable[[Sheet], Sheet]) -> Sheet | None:
    """What is written on the sheet over the band that it has; None where it has no room there."""
    up, (wide, high) = 1j * grid.height, made.room
    done = write(replace(_shifted(made, -up), room=(wide, high - grid.height), results=()))
    if not done.results:
        return None
    return replace(_shifted(done, up), room=made.room, results=(*_ruled(grid, made), *_moved(done.results, up)))


def _figures(sheet: Sheet) -> list[Figure]:
    """Those of the sheet, without their details, which show the same once more, cut at a ring."""
    drawn = [one.figure for one in sheet.figures if one.figure is not None]
    return [one for one in drawn if not any(one.view is of.view and is_detail(one.name, of) for of in drawn)]


def _sets(sheet: Sheet) -> list[list[Cell]]:
    """What its legend tells: all; all but what is plain. Nothing where all is plain."""
    found = entries(_figures(sheet), sheet.lang)
    told = [one for one in found if not one.plain]
    return [cells(some, sheet.lang) for some in (found, told) if some]


def _banded(sheet: Sheet, sets: Sequence[Sequence[Cell]]) -> Iterator[tuple[Sheet, Grid]]:
    """The sheet with a band, in every way in which it has room for one, the best first."""
    grids = [band(some, sheet.lang, sheet.room[0], close=close) for some in sets for close in (False, True)]
    ways = ((way, grid) for grid in grids for way in (_over_strip, _laid_anew))
    yield from ((made, grid) for way, grid in ways if (made := way(sheet, grid)) is not None)


def _with_blocks(sheet: Sheet, sets: Sequence[Sequence[Cell]], inks: int) -> Sheet:
    """On a block, or parted on two or three: of so many inks of vectors, and of the rest; else as much as has room."""
    if (blocked := _with_block(sheet, sets)) is not sheet:
        return blocked
    split = (_parted(sheet, some, inks, most) for most in range(2, BLOCKS + 1) for some in sets)
    return next((one for one in split if one is not None), None) or _as_many(sheet, sets[-1])


def _parted(sheet: Sheet, some: Sequence[Cell], inks: int, most: int, *, more: bool = False) -> Sheet | None:
    """All of these on so many blocks at most, of so many inks of vectors and of the rest where they have room so; None
    where they have none."""
    if not some or most < 1:
        return None if some else sheet
    for first in sorted(range(1, len(some) + 1), key=lambda count: abs(count - inks)):
        one, left = _with_block(sheet, (some[:first],), more=more), len(some) - first
        if one is not sheet and (made := _parted(one, some[first:], left, most - 1, more=True)) is not None:
            return made
    return None


def _as_many(sheet: Sheet, some: Sequence[Cell], most: int = BLOCKS, *, more: bool = False) -> Sheet:
    """As many of these, in order, as have room on so many blocks."""
    for count in range(len(some), 0, -1) if most else ():
        if (one := _with_block(sheet, (some[:count],), more=more)) is not sheet:
            return _as_many(one, some[count:], most - 1, more=True)
    return sheet


def _on_plate(plate: Sheet, sets: Sequence[Sequence[Cell]]) -> Sheet:
    """A plate with its legend on a band, its rows closer, or without what is plain, where it would grow too high for a
    page; else on blocks."""
    grids = (band(some, plate.lang, plate.room[0], close=close) for some in sets for close in (False, True))
    fitting = next((grid for grid in grids if plate.room[1] + grid.height <= TALLEST), None)
    if fitting is not None:
        return _grown(plate, fitting)
    return _with_blocks(plate, sets, _inks(plate)) if sets else plate


def _grown(plate: Sheet, grid: Grid) -> Sheet:
    """A plate, higher by the band, over which stands what is written on it."""
    wide, high = plate.room
    up = 1j * grid.height
    grown = replace(_shifted(plate, up), room=(wide, high + grid.height))
    return replace(grown, results=(*_ruled(grid, grown), *_moved(plate.results, up)))


def _with_block(sheet: Sheet, sets: Sequence[Sequence[Cell]], *, more: bool = False) -> Sheet:
    """With the first of these that has room beside the others; as it is where none has. more: after another block."""
    wide = sheet.room[0] * MOST
    found = standing(sheet, (one for some in sets if some for one in blocks(some, sheet.lang, wide, more=more)))
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
    return replace(sheet, drawn=_moved(sheet.drawn, by), figures=tuple(placed))


def _moved(items: Sequence[Item], by: complex) -> tuple[Item, ...]:
    return tuple(moved(item, by) for item in items)


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
