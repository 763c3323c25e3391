"""Tables as books rule them: a heavy line above and below, a fine one under the header, nothing upright."""

from __future__ import annotations

from collections.abc import Sequence

from reportlab.platypus.doctemplate import FrameBreak
from reportlab.platypus.flowables import Flowable

from ...tagging.pieces import Marks
from ...tagging.references import goal_of
from ...tagging.tag import Role, Tag
from ...tagging.tag import cell as cell_tag
from ...tagging.tree import tree_of
from ...typeset.box import MM
from ...typeset.canvas import Ink
from ...words import Lang
from .base import Block
from .cells import cells, joined
from .lines import Line, break_lines, draw_line
from .style import CAPTION, CELL, Style

_PAD = 1.5  # mm at either side of a cell
_VERTICAL = 1.6  # pt above and below a row
_HEAVY, _FINE = 0.9, 0.45  # pt
_ALIGN = {"l": "left", "c": "centre", "r": "right"}

_Row = tuple[tuple[Line, ...], ...]

_MANY_ROWS = 10
_LEAST_ROWS = 4  # rows that a page break leaves together, before and after it


class DataTable(Block):
    """header, rows: words with inline formulas; widths in mm (None: by content); align: l, c, r each."""

    role = Role.TABLE
    pieces = True

    def __init__(
        self,
        header: Sequence[str],
        rows: Sequence[Sequence[str]],
        widths: Sequence[float] | None = None,
        align: str = "",
        *,
        lang: Lang = "zh",
        caption: str = "",
        style: Style = CELL,
    ) -> None:
        super().__init__(6.0, 8.0)
        self.goal = goal_of(caption)
        self.header, self.rows = tuple(header), tuple(tuple(row) for row in rows)
        self.lang, self.caption, self.style = lang, caption, style
        self.widths = tuple(widths) if widths is not None else None
        self.whole = False  # rather goes to the next page than leaves only a few rows here
        self.align = (align + "c" * len(self.header))[: len(self.header)]
        self._measured: float | None = None
        self._set_widths: tuple[float, ...] = ()
        self._head: _Row = ()
        self._body: tuple[_Row, ...] = ()
        self._continued = False  # from the page before: its heading has been read

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column; for the same width it was found before."""
        if self._measured == width:
            return width, self.height
        self._measured = self.width = width
        self._set_widths = self._columns(width / MM)
        self._head = self._break(self.header, True)
        self._body = tuple(self._break(row, False) for row in self.rows)
        self.height = self._top() + sum(map(self._height, self._body)) + _HEAVY
        return width, self.height

    def _top(self) -> float:
        caption = CAPTION.leading + 2.0 if self.caption else 0.0
        return caption + _HEAVY + self._height(self._head) + _FINE

    def _natural(self, column: int) -> float:
        texts = [(self.header[column], True), *((row[column], False) for row in self.rows)]
        em, chinese = self.style.em, self.lang == "zh"
        return max(joined(cells(text, em, chinese, bold), em).width for text, bold in texts) + 2 * _PAD

    def _columns(self, width: float) -> tuple[float, ...]:
        wanted = self.widths or tuple(self._natural(i) for i in range(len(self.header)))
        total = sum(wanted)
        if total <= width:
            return tuple(wanted)
        fair = width / len(wanted)  # narrow columns keep their width, the wide ones share what is left
        narrow = sum(w for w in wanted if w <= fair)
        share = (width - narrow) / sum(w for w in wanted if w > fair)
        return tuple(w if w <= fair else w * share for w in wanted)

    def _break(self, row: Sequence[str], bold: bool) -> _Row:
        em, chinese = self.style.em, self.lang == "zh"
        parts = (cells(text, em, chinese, bold) for text in row)
        rooms = (width - 2 * _PAD + 1e-3 for width in self._set_widths)
        return tuple(tuple(break_lines(p, room, em)) for p, room in zip(parts, rooms, strict=True))

    def _height(self, row: _Row) -> float:
        tallest = max((sum(map(self._advance, cell)) for cell in row), default=0.0)
        return max(tallest, self.style.leading) + 2 * _VERTICAL

    def _advance(self, line: Line) -> float:
        return max(self.style.leading, line.ascent * MM + line.descent * MM + 2.0)

    def split(self, width: float, height: float) -> list[Flowable]:
        """Whole rows to each page, the header on both."""
        self.wrap(width, height)
        used, count = self._top() + _HEAVY, 0
        while count < len(self.rows) and used + self._height(self._body[count]) <= height:
            used += self._height(self._body[count])
            count += 1
        least = _MANY_ROWS if self.whole else _LEAST_ROWS
        count = min(count, len(self.rows) - least)
        if count < min(least, len(self.rows)):
            return []
        head, tail = self._part(0, count), self._part(count, len(self.rows))
        head.spaceBefore, head.spaceAfter = self.spaceBefore, 0.0
        tail.spaceBefore, tail.spaceAfter = 0.0, self.spaceAfter
        return [head, FrameBreak(), tail]  # the rest is not split once more on this page

    def _part(self, start: int, end: int) -> DataTable:
        caption = self.caption if start == 0 else ""
        rows = self.rows[start:end]
        widths = self._set_widths
        part = DataTable(self.header, rows, widths, self.align, lang=self.lang, caption=caption, style=self.style)
        part.tag, part._continued = self.tag, self._continued or start > 0
        return part

    def draw(self) -> None:
        """Draw caption, header, rows and rules, centred in the column."""
        ink = Ink(self.canv)
        width = sum(self._set_widths) * MM
        left, y = (self.width - width) / 2, self.height
        if self.caption:
            em = CAPTION.em
            title = joined(cells(self.caption, em, self.lang == "zh", True), em)
            ink.under(tree_of(self.canv).opener(Tag(Role.CAPTION, self.tag)))
            ink.box(title, (self.width - title.width * MM) / 2, y - CAPTION.size)
            y -= CAPTION.leading + 2.0
        y = self._rule(ink, left, y, width, _HEAVY)
        y = self._row(ink, self._head, left, y, "c" * len(self.header), header=True)
        y = self._rule(ink, left, y, width, _FINE)
        for row in self._body:
            y = self._row(ink, row, left, y, self.align)
        self._rule(ink, left, y, width, _HEAVY)
        ink.flush()

    def _rule(self, ink: Ink, x: float, y: float, width: float, weight: float) -> float:
        ink.rule(x, y - weight, width, weight)
        return y - weight

    def _row(self, ink: Ink, row: _Row, left: float, top: float, align: str, header: bool = False) -> float:
        height, tag = self._height(row), Tag(Role.ROW, self.tag)
        x = left
        for cell, width, side in zip(row, self._set_widths, align, strict=True):
            marks = self._marks(tag, header)
            y = top - (height - sum(map(self._advance, cell))) / 2
            for line in cell:
                advance = self._advance(line)
                rise = (advance - self.style.size) / 2 + 0.86 * self.style.size
                rise = max(rise, line.ascent * MM + 1.0)
                draw_line(ink, line, x + _PAD * MM, y - rise, width - 2 * _PAD, _ALIGN[side], marks)
                y -= advance
            marks.finish()
            x += width * MM
        return top - height

    def _marks(self, row: Tag, header: bool) -> Marks:
        """The element of a cell; a header that is repeated has been read."""
        if header and self._continued:
            return Marks(self.canv, None)
        tag = cell_tag(row, header)
        tree_of(self.canv).element(tag)  # an empty cell is one too
        return Marks(self.canv, tag)
