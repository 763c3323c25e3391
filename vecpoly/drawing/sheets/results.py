"""What came out of a drawing, written on its sheet: a small block along the frame, where nothing else stands."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import ceil

import shapely

from ...algebra.formula import Node
from ...typeset import Box, layout, layout_words
from ...words import Words
from ..scene import Fill, Item, Layer, Rect, Stroke, TextBox
from ..style import NOTE, THIN
from .redbox import BAND
from .sheet import Sheet
from .space import FRAME, STRIP

TITLE = Words("结果", "Results")
PAD, SKIP, BESIDE = 2.0, 1.5, 5.0  # mm: inside the block's frame; between its lines; between its columns
MARGIN, CLEAR = 3.0, 4.0  # mm of white to the frame of the sheet; to whatever stands on it
STEP, MOST = 4.0, 3  # mm by which places along the frame differ; columns
SHARE = 0.3  # of the sheet's area, which no block exceeds


@dataclass(frozen=True, slots=True)
class Block:
    """Lines of type with the lower left ends of their base lines, in a box of this size (mm)."""

    boxes: tuple[tuple[Box, float, float], ...]
    width: float
    height: float


def with_results(sheet: Sheet, attempts: Sequence[Sequence[Node]]) -> Sheet:
    """The sheet with the first of these lists of results for which it has room; as it is where it has room for none."""
    free = _free(sheet)
    title = layout_words(TITLE.of(sheet.lang), NOTE, True)
    for nodes in attempts:
        lines = [layout(node, NOTE) for node in nodes]
        for columns in range(1, min(MOST, len(lines)) + 1):
            block = _block(title, lines, columns)
            if block.width * block.height > SHARE * sheet.room[0] * sheet.room[1]:
                continue
            if (at := next((at for at in _places(sheet, block) if free.clear(at, block)), None)) is not None:
                return replace(sheet, results=_items(block, at, max((item.step for item in sheet.drawn), default=0)))
    return sheet


@dataclass(frozen=True, slots=True)
class _Free:
    """What stands on a sheet."""

    tree: shapely.STRtree

    def clear(self, at: complex, block: Block) -> bool:
        """Whether a block with its lower left corner there keeps clear of everything."""
        x, y = at.real, at.imag
        room = shapely.box(x - CLEAR, y - CLEAR, x + block.width + CLEAR, y + block.height + CLEAR)
        return len(self.tree.query(room, predicate="intersects")) == 0


def _free(sheet: Sheet) -> _Free:
    return _Free(shapely.STRtree([_shape(item) for item in sheet.drawn]))


def _shape(item: Item) -> shapely.Geometry:
    if isinstance(item, TextBox):
        r = item.rect
        return shapely.box(r.x0, r.y0, r.x1, r.y1)
    points = [(z.real, z.imag) for z in item.points]
    if isinstance(item, Fill):
        return shapely.Polygon(points) if len(points) > 2 else shapely.LineString(points)
    return shapely.LineString([*points, points[0]] if item.closed else points)


def _block(title: Box, lines: Sequence[Box], columns: int) -> Block:
    """The lines in columns from the top, under a title."""
    rows = ceil(len(lines) / columns)
    parts = [lines[n : n + rows] for n in range(0, len(lines), rows)]
    wide = [max(box.width for box in part) for part in parts]
    high = [max(part[n].ascent for part in parts if n < len(part)) for n in range(rows)]
    deep = [max(part[n].descent for part in parts if n < len(part)) for n in range(rows)]
    height = 2 * PAD + title.ascent + title.descent + sum(high) + sum(deep) + rows * SKIP
    placed = [(title, PAD, height - PAD - title.ascent)]
    for column, part in enumerate(parts):
        x = PAD + sum(wide[:column]) + column * BESIDE
        y = height - PAD - title.ascent - title.descent
        for n, box in enumerate(part):
            y -= SKIP + high[n]
            placed.append((box, x, y))
            y -= deep[n]
    width = 2 * PAD + max(sum(wide) + (len(parts) - 1) * BESIDE, title.width)
    return Block(tuple(placed), width, height)


def _places(sheet: Sheet, block: Block) -> Iterator[complex]:
    """Lower left corners along the frame: the corners of the sheet first, then its sides."""
    x0, y0 = FRAME + MARGIN, FRAME + STRIP + MARGIN
    top = sheet.size[1] - FRAME - (BAND if sheet.warning is not None else 0.0)
    x1, y1 = sheet.size[0] - FRAME - MARGIN - block.width, top - MARGIN - block.height
    if x1 < x0 or y1 < y0:
        return
    yield from (complex(x, y) for y in (y1, y0) for x in (x1, x0))
    for side in (x1, x0):
        yield from (complex(side, y1 - n * STEP) for n in range(1, int((y1 - y0) / STEP) + 1))
    for level in (y1, y0):
        yield from (complex(x1 - n * STEP, level) for n in range(1, int((x1 - x0) / STEP) + 1))


def _items(block: Block, at: complex, step: int) -> tuple[Item, ...]:
    """The block as it stands there after the last step."""
    r = Rect(at.real, at.imag, at.real + block.width, at.imag + block.height)
    return (
        Stroke(points=r.corners, width=THIN, closed=True, layer=Layer.THIN, step=step),
        *(TextBox(box=box, x=at.real + x, y=at.imag + y, step=step) for box, x, y in block.boxes),
    )
