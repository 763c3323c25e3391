"""What came out of a drawing, written on its sheet: a block in its lower right corner, where nothing else stands."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import compress, islice
from math import ceil

import numpy as np
import shapely
from numpy.typing import NDArray

from ....algebra.formula import Node
from ....foundation.slotted import dataclass, replace
from ....typeset import Box, layout, layout_words
from ....words import Words
from ...scene import Fill, Item, Layer, Rect, Stroke, TextBox
from ...style import NOTE, THIN
from ..packing import Layout, pack
from ..pages import pairs_of
from ..paging import Drawn, even, lined
from ..sheet import Sheet, placed
from ..slicing import Size
from ..space import FRAME, STRIP
from .redbox import BAND

TITLE = Words("结果", "Results")
PAD, SKIP, BESIDE = 2.0, 1.5, 5.0  # mm: inside the block's frame; between its lines; between its columns
MARGINS, CLEAR = (4.2, 3.0), 4.0  # mm of white to the frame of the sheet, and at least; to whatever stands on it
STEP, MOST = 4.0, 4  # mm by which places along the frame differ; columns
SIZES = (3.8, NOTE)  # em: of the type, where there is room, and else
AMONG, ASIDE = 4.0, 2.0  # mm of white among figures moved together; beside the block, beyond what they have
SHARE = 0.3  # of the sheet's area, which no block exceeds


@dataclass(frozen=True, slots=True)
class Block:
    """Lines of type with the lower left ends of their base lines, in a box of this size (mm)."""

    boxes: tuple[tuple[Box, float, float], ...]
    width: float
    height: float


@dataclass(frozen=True, slots=True)
class Listed:
    """Results that stand together; heading: over them, "" of a list that has none. said: below them, the lines of a
    sentence in type of this size."""

    heading: str
    nodes: tuple[Node, ...]
    said: Callable[[float], tuple[Box, ...]] = lambda em: ()


def with_results(sheet: Sheet, attempts: Sequence[Sequence[Listed]]) -> Sheet:
    """The sheet with the first of these lists of results for which it has room: over the right end of the title strip,
    the figures moved together for it where they must; else anywhere along its frame; as it is where it has room for
    none."""
    made = (_with_results(sheet, attempts, margin) for margin in MARGINS)
    return next((one for one in made if one is not None), sheet)


def _with_results(sheet: Sheet, attempts: Sequence[Sequence[Listed]], margin: float) -> Sheet | None:
    """With so much white to the frame; None where it has no room."""
    room, found = _Room.on(sheet, margin), list[Block]()
    for parts in attempts:
        for em in SIZES:
            blocks = [*_blocks(sheet, parts, em)]
            made = (way(block) for way in (room.in_corner, room.moved) for block in blocks)
            if (done := next((one for one in made if one is not None), None)) is not None:
                return done
            found += blocks
    rooms = [room, *([wider] if (wider := room.spread()) is not None else [])]
    made = (one.along(block) for one in rooms for block in found)
    return next((one for one in made if one is not None), None)


def _blocks(sheet: Sheet, parts: Sequence[Listed], em: float) -> Iterator[Block]:
    """The results in one to four columns, none of which takes too much of the sheet."""
    title = layout_words(TITLE.of(sheet.lang), em, True)
    for lines in _columns(parts, em):
        block = _block(title, lines)
        if block.width * block.height <= SHARE * sheet.room[0] * sheet.room[1]:
            yield block


def _columns(parts: Sequence[Listed], em: float) -> Iterator[list[list[Box]]]:
    """The lines from the top of one column to the next; of parts with headings, each in one piece."""
    set_ = [[*_heading(part, em), *(layout(node, em) for node in part.nodes), *part.said(em)] for part in parts]
    if any(part.heading for part in parts):
        yield [[box for part in set_ for box in part]]
        yield from [set_] if 1 < len(set_) <= MOST else []
        return
    lines = [box for part in set_ for box in part]
    for columns in range(1, min(MOST, len(lines)) + 1):
        rows = ceil(len(lines) / columns)
        yield [lines[n : n + rows] for n in range(0, len(lines), rows)]


def _heading(part: Listed, em: float) -> Iterator[Box]:
    if part.heading:
        yield layout_words(part.heading, em, True)


@dataclass(frozen=True, slots=True)
class _Room:
    """The room of a sheet: its figures, which can be moved, and what stands on it."""

    sheet: Sheet
    group: tuple[Drawn, ...]
    sizes: tuple[Size, ...]
    free: _Free
    margin: float

    @classmethod
    def on(cls, sheet: Sheet, margin: float) -> _Room:
        """Of a sheet as it is."""
        group = sheet.groups
        return cls(sheet, group, tuple(one.size for one in group), _free(sheet), margin)

    def in_corner(self, block: Block) -> Sheet | None:
        """The sheet with the block in its corner, where nothing stands there."""
        return self._at(list(islice(_places(self.sheet, block, self.margin), 1)), block)

    def along(self, block: Block) -> Sheet | None:
        """With the block along the frame, where there is room."""
        return self._at(list(_places(self.sheet, block, self.margin)), block)

    def _at(self, places: Sequence[complex], block: Block) -> Sheet | None:
        """With the block at the first of these places where nothing stands."""
        at = next(compress(places, self.free.clear(places, block)), None)
        return None if at is None else _with(self.sheet, block, at)

    def spread(self) -> _Room | None:
        """With the figures spread over the sheet, which may leave room at its frame."""
        layout = self._layout(self.sizes)
        if layout is None:
            return None
        hung = lined(self.group, layout)
        made = placed(self.group, hung, self.sheet.strip, self.sheet.lang, self.sheet.warning)
        return _Room.on(made, self.margin)

    def moved(self, block: Block) -> Sheet | None:
        """With the block in its corner and the figures closer together, in their order, the block being the last."""
        layout = self._layout((*self.sizes, (block.width + ASIDE, block.height + ASIDE)))
        if layout is None or layout.white < AMONG:
            return None
        low, foot = layout.page[0] - self.margin - block.width, self.margin
        stands = Rect(low, foot, low + block.width, foot + block.height)
        hung = lined(self.group, replace(layout, corners=layout.corners[:-1]), (stands,))
        hung = even(self.group, hung, (stands,)) if self.sheet.warning is None else hung
        moved = placed(self.group, hung, self.sheet.strip, self.sheet.lang, self.sheet.warning)
        return _with(moved, block, complex(low + FRAME, foot + FRAME + STRIP))

    def _layout(self, sizes: Sequence[Size]) -> Layout | None:
        """No pair parted, on a sheet that stays as large as it is."""
        pairs, boxed = pairs_of(self.group), self.sheet.warning is not None
        wide, high = self.sheet.room[0], self.sheet.room[1] - (BAND if boxed else 0.0)
        found = pack(sizes, (wide, high), tuple(pairs)) if sum(w * h for w, h in sizes) < wide * high else None
        return None if found is None or found.together < len(pairs) else found


def _with(sheet: Sheet, block: Block, at: complex) -> Sheet:
    return replace(sheet, results=_items(block, at, max((item.step for item in sheet.drawn), default=0)))


@dataclass(frozen=True, slots=True)
class _Free:
    """What stands on a sheet."""

    tree: shapely.STRtree

    def clear(self, at: Sequence[complex], block: Block) -> NDArray[np.bool_]:
        """Whether a block with its lower left corner there keeps clear of everything, place by place."""
        x, y = np.real(at), np.imag(at)
        rooms = shapely.box(x - CLEAR, y - CLEAR, x + block.width + CLEAR, y + block.height + CLEAR)
        taken, _ = self.tree.query(rooms, predicate="intersects")
        free = np.ones(len(at), dtype=bool)
        free[taken] = False
        return free


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


def _block(title: Box, parts: Sequence[Sequence[Box]]) -> Block:
    """The columns of lines from the top, all rows of one height, under a title."""
    rows, every = max(map(len, parts)), [box for part in parts for box in part]
    wide = [max(box.width for box in part) for part in parts]
    up, down = max(box.ascent for box in every), max(box.descent for box in every)
    pitch = SKIP + up + down
    height = 2 * PAD + title.height + rows * pitch
    placed = [(title, PAD, height - PAD - title.ascent)]
    for column, part in enumerate(parts):
        x = PAD + sum(wide[:column]) + column * BESIDE
        first = height - PAD - title.height - SKIP - up
        placed += [(box, x, first - n * pitch) for n, box in enumerate(part)]
    width = 2 * PAD + max(sum(wide) + (len(parts) - 1) * BESIDE, title.width)
    return Block(tuple(placed), width, height)


def _places(sheet: Sheet, block: Block, margin: float) -> Iterator[complex]:
    """Lower left corners along the frame: the lower right corner of the sheet first, the others, then its sides."""
    x0, y0 = FRAME + margin, FRAME + STRIP + margin
    top = sheet.size[1] - FRAME - (BAND if sheet.warning is not None else 0.0)
    x1, y1 = sheet.size[0] - FRAME - margin - block.width, top - margin - block.height
    if x1 < x0 or y1 < y0:
        return
    yield from (complex(x, y) for y in (y0, y1) for x in (x1, x0))
    for side in (x1, x0):
        yield from (complex(side, y0 + n * STEP) for n in range(1, int((y1 - y0) / STEP) + 1))
    for level in (y0, y1):
        yield from (complex(x1 - n * STEP, level) for n in range(1, int((x1 - x0) / STEP) + 1))


def _items(block: Block, at: complex, step: int) -> tuple[Item, ...]:
    """The block as it stands there after the last step."""
    r = Rect(at.real, at.imag, at.real + block.width, at.imag + block.height)
    return (
        Stroke(points=r.corners, width=THIN, closed=True, layer=Layer.THIN, step=step),
        *(TextBox(box=box, x=at.real + x, y=at.imag + y, step=step) for box, x, y in block.boxes),
    )
