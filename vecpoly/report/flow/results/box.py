"""The box that ends a problem: a framed list of what was asked, one under the other in two or three
columns, rows of one height."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import accumulate, groupby

from ....algebra.formula import plain
from ....foundation.slotted import replace
from ....tagging.tag import Role, Tag
from ....tagging.tree import artifact, tree_of
from ....typeset.box import MM
from ....typeset.canvas import Ink
from ....typeset.words import layout_words
from ....words import Lang, Words
from ...answers.line import AnswerLine
from ..base import Block, Tightness
from ..style import CELL
from .grid import GridRow, Told, columns, even, gridded, in_reading_order, laid, sentence

TITLE = Words("答", "Answer")
PAD, _SKIP = 2.6, 1.4  # mm: inside the frame, between rows
AFTER_TITLE = 3.0  # mm
WHOLE = 75.0 * MM  # a box no taller than this is not parted
_LEAST = 3  # rows that a page break leaves together
_FRAME = 0.6  # pt


class AnswerBox(Block):
    """lines: one a quantity; notes on them; said: sentences that are answers of their own."""

    role = Role.DIV
    pieces = True
    airy = 0.8
    clings = True
    compared = False  # whether exact values stand beside others

    def __init__(
        self, lines: Sequence[AnswerLine], said: Sequence[str] = (), lang: Lang = "zh", notes: Sequence[str] = ()
    ) -> None:
        super().__init__(7.0, 8.0)
        self.lines, self.said, self.notes, self.lang = tuple(lines), tuple(said), tuple(notes), lang
        self._em, self._skip = CELL.em, _SKIP
        self._title = layout_words(TITLE.of(lang), self._em, True)
        self._rows: tuple[GridRow, ...] = ()
        self._named = Told(None, after=TITLE.of(lang))
        self._set_in: dict[float, tuple[tuple[GridRow, ...], ...]] = {}  # by width: without the title above, with it
        self._above = False  # whether the title stands above the lines
        self._set = False  # a part of a box keeps the rows that it was given

    @property
    def parted(self) -> bool:
        """Whether it is what a page break left of a box."""
        return self._set

    @property
    def directed(self) -> bool:
        """Whether a direction stands in it as an angle."""
        return any("∠" in plain(line.node) for line in self.lines)

    def tighten(self, degree: Tightness) -> None:
        """Rows closer too."""
        super().tighten(degree)
        self._skip = degree.white * _SKIP

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column: the title in the margin, or above where that takes less height."""
        self.width = width
        if not self._set:
            self._above, self._rows = self._best(width)
        self.height = (self._high(self._rows) + 2 * PAD) * MM
        return width, self.height

    def _best(self, width: float) -> tuple[bool, tuple[GridRow, ...]]:
        """Whether the title stands above, and the rows, in a column of this width (pt)."""
        if width not in self._set_in:
            self._set_in[width] = tuple(self._laid(width / MM - 2 * PAD, above) for above in (False, True))
        beside_it, under = self._set_in[width]
        above = self._high(under) < self._high(beside_it)
        return above, under if above else beside_it

    def _high(self, rows: Sequence[GridRow]) -> float:
        return sum(map(_height, rows)) + self._skip * (len(rows) - 1)

    def _laid(self, width: float, above: bool) -> tuple[GridRow, ...]:
        """The rows in a frame of this width (mm) inside."""
        room = width if above else width - self._title.width - AFTER_TITLE
        title: tuple[GridRow, ...] = (((0.0, self._title, self._named),),) if above else ()
        rows = (*title, *self._grouped(room), *self._sentences(room))
        return tuple(even(rows, self.lines, self._em))

    def _grouped(self, room: float) -> Iterator[GridRow]:
        """The rows of each part of the list, under its heading."""
        parts = [tuple(some) for _, some in groupby(self.lines, key=lambda one: one.heading)]
        edges = columns(parts, self._em, room)
        for lines in parts:
            yield from (*self._heading(lines[0].heading), *laid(lines, edges, self._em, room))

    def _heading(self, text: str) -> Iterator[GridRow]:
        if text:
            yield ((0.0, layout_words(text, self._em, True), Told(None, after=text)),)

    def _sentences(self, room: float) -> Iterator[GridRow]:
        """The notes, and what is said beside."""
        for text in (*self.notes, *self.said):
            told = Told(None, after=text)
            yield from (((0.0, box, told),) for box in sentence(text, self._em, room, self.lang == "zh"))

    def split(self, width: float, height: float) -> list[Block]:
        """Whole answers to each page, of a box too tall to be kept together."""
        if self.wrap(width, height)[1] <= WHOLE:
            return []
        used, count = 2 * PAD, 0
        room = (height - self.getSpaceBefore()) / MM  # the frame may leave that out here and ask for it of the part
        while count < len(self._rows) and used + _height(self._rows[count]) <= room:
            used += _height(self._rows[count]) + self._skip
            count += 1
        count = min(count, len(self._rows) - _LEAST)
        while count > 0 and not self._parts(count):
            count -= 1
        if count < _LEAST:
            return []
        return [self._part(rows, first) for rows, first in zip(self._parted(count), (True, False), strict=True)]

    def _parted(self, count: int) -> tuple[tuple[GridRow, ...], tuple[GridRow, ...]]:
        """So many rows and the others; of quantities that a page break parts, those that come first in the first."""
        other = [n for n, row in enumerate(self._rows) if row[0][2].node is None]
        start = max((n + 1 for n in other if n < count), default=0)
        end = min((n for n in other if n >= count), default=len(self._rows))
        block = self._rows[start:end]
        cells = [(box, told) for _, _, box, told in in_reading_order(block)]
        edges, first = [x for x, _, _ in block[0]] if block else [], sum(map(len, self._rows[start:count]))
        head, tail = (tuple(gridded(some, edges)) if some else () for some in (cells[:first], cells[first:]))
        return (*self._rows[:start], *head), (*tail, *self._rows[end:])

    def _parts(self, count: int) -> bool:
        """Whether a page may end there: not within a sentence, nor under a heading."""
        before, after = self._rows[count - 1][-1][2], self._rows[count][0][2]
        return before is not after and not (before.node is None and after.node is not None)

    def _part(self, rows: tuple[GridRow, ...], first: bool) -> AnswerBox:
        part = AnswerBox((), (), self.lang)
        part._rows, part._skip, part._set, part._above = rows, self._skip, True, self._above
        if not first:
            part._title = replace(self._title, items=())
        return part.made_of(self, first=first)

    def draw(self) -> None:
        """Draw the frame, the title in its margin, and the rows."""
        self._frame_drawn()
        ink = Ink(self.canv)
        margin = 0.0 if self._above else self._title.width + AFTER_TITLE
        if not self._above:
            self._tell(ink, self._named)
            ink.box(self._title, PAD * MM, self._levels(self._rows, PAD)[0] * MM)
        self._written(ink, self._rows, PAD + margin, PAD)
        ink.flush()

    def _frame_drawn(self) -> None:
        with artifact(self.canv):
            self.canv.setLineWidth(_FRAME)
            self.canv.rect(0.0, 0.0, self.width, self.height)

    def _written(self, ink: Ink, rows: Sequence[GridRow], left: float, top: float) -> None:
        """Draw rows that begin so far (mm) from the left and from the top."""
        last, levels = None, self._levels(rows, top)
        for n, x, box, told in in_reading_order(rows):
            if told is not last:
                self._tell(ink, told)
                last = told
            ink.box(box, (left + x) * MM, levels[n] * MM)

    def _levels(self, rows: Sequence[GridRow], top: float) -> tuple[float, ...]:
        """Where the base line of each row is, in mm."""
        tops = accumulate((_height(row) + self._skip for row in rows), initial=top)
        above = (max(box.ascent for _, box, _ in row) for row in rows)
        return tuple(self.height / MM - top - up for top, up in zip(tops, above, strict=False))

    def _tell(self, ink: Ink, told: Told) -> None:
        """What follows is this answer."""
        heard = told.heard(self.lang) if told.node else ""
        tag = Tag(Role.FORMULA if told.node else Role.P, self.tag, heard)
        ink.under(tree_of(self.canv).opener(tag, told.plain))


def _height(row: GridRow) -> float:
    return max(box.ascent for _, box, _ in row) + max(box.descent for _, box, _ in row)
