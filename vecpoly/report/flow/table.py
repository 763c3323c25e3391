"""Tables as books rule them: a heavy line above and below, a fine one under the header, nothing upright."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate

from reportlab.platypus.doctemplate import FrameBreak
from reportlab.platypus.flowables import Flowable

from ...foundation.slotted import dataclass, replace
from ...tagging.pieces import Marks
from ...tagging.references import goal_of
from ...tagging.tag import Role, Tag
from ...tagging.tag import cell as cell_tag
from ...tagging.tree import artifact, tree_of
from ...typeset.box import MM
from ...typeset.canvas import Ink
from ...words import Lang
from .base import Block, Tightness
from .cells import Cell, cells, joined
from .lines import draw_line
from .results.banded import LIGHT, Rules
from .results.columns import evened, longest, over, shared
from .results.decimal import BREAKS, Columns, aligned_columns, unbroken
from .style import CAPTION, CELL, Style
from .text.breaks import Line, break_lines
from .text.continued import CONTINUED, continued

PAD, _VERTICAL = 1.5, 1.6  # mm at either side of a cell, pt above and below a row
_APART = 6.0  # mm between the halves of a table
_HEAVY, _FINE = 0.9, 0.45  # pt
_ALIGN = {"l": "left", "c": "centre", "r": "right", "d": "centre", "u": "centre"}

_Row = tuple[tuple[Line, ...], ...]
_MANY_ROWS, _LEAST_ROWS = 4, 3  # that a page break leaves before it of a whole table; of others, and behind it
_PAGE_ROWS = 40  # for which a page has room


@dataclass(frozen=True, slots=True)
class _Set:
    """The table in a column: widths (mm), header and rows in lines; in pt how tall they are, the top, each row."""

    widths: tuple[float, ...]
    head: _Row
    body: tuple[_Row, ...]
    points: Columns
    tall: tuple[float, ...]
    top: float = 0.0
    heights: tuple[float, ...] = ()


class DataTable(Block):
    """header, rows: words with inline formulas; widths in mm (None: by content); align: l, c, r, d, u each. Symbols
    in it are black: colours are for equations and figures.

    d: numbers under each other by their decimal points, u: those of each of the `groups` of rows; others are centred.
    """

    role = Role.TABLE
    pieces = True
    even = False  # as wide as other tables of its page

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
        groups: Sequence[str] = (),
    ) -> None:
        super().__init__(6.0, 8.0)
        self.goal, self.header, self.rows = goal_of(caption), tuple(header), tuple(tuple(row) for row in rows)
        self.lang, self.caption, self.style = lang, caption, style
        self.groups = tuple(groups) or ("",) * len(self.rows)
        self.widths = tuple(widths) if widths is not None else None
        self.whole = False  # rather goes to the next page than leaves only a few rows here
        self.undivided = 0.0  # pt that it rather leaves white, going to the next page, than is parted
        self.align = (align + "c" * len(self.header))[: len(self.header)]
        self._vertical = _VERTICAL
        self._found: dict[float, _Set] = {}  # by width of the column; one for the table and all its copies
        self._continued = False  # from the page before: its heading has been read
        self._before, self._ruling = 0, Rules.of(self.rows)  # rows of it on pages before

    def tighten(self, degree: Tightness) -> None:
        """Its rows closer too, their lines as they are."""
        super().tighten(degree)
        self._vertical = degree.white * _VERTICAL
        self._found = {width: self._measured(found) for width, found in self._found.items()}

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column; for the same width it was found before."""
        found = self.set_in(width)
        self.width, self.height = width, found.top + sum(found.heights) + _HEAVY
        return width, self.height

    def set_in(self, width: float) -> _Set:
        """The lines of its cells in a column of so many points."""
        if width not in self._found:
            self._found[width] = self._broken(width)
        return self._found[width]

    def _broken(self, width: float) -> _Set:
        em, chinese = self.style.em, self.lang == "zh"
        header = [cells(text, em, chinese, True) for text in self.header]
        rows = [[cells(text, em, chinese, False) for text in row] for row in self.rows]
        widths = self._columns(width / MM, (header, *rows), self._points(self.rows))
        head, body = self._lines(header, widths), tuple(self._lines(row, widths) for row in rows)
        tall = tuple(map(self._tall, (head, *body)))
        return self._measured(_Set(widths, head, body, self._points(unbroken(self.rows, body)), tall))

    def _measured(self, found: _Set) -> _Set:
        caption = CAPTION.leading + 2.0 if self.caption or self._continued else 0.0
        head, *rows = map(self._height, (found.head, *found.body), found.tall)
        heights = (row + self._ruling.white(self._before, n) for n, row in enumerate(rows))
        return replace(found, top=caption + _HEAVY + head + _FINE, heights=tuple(heights))

    def _points(self, rows: Sequence[Sequence[str]]) -> Columns:
        return aligned_columns(rows, self.align, self.groups, self.style.em, self.lang == "zh")

    def _columns(self, width: float, rows: Sequence[Sequence[Sequence[Cell]]], points: Columns) -> tuple[float, ...]:
        em = self.style.em
        every = zip(*(self.header, *self.rows), strict=True)
        blank = [0.0 if any(column) else _APART - 2 * PAD for column in every]
        wanted = self.widths or tuple(
            max(*(joined(row[i], em).width for row in rows), *(one.width for one in column or ()), blank[i]) + 2 * PAD
            for i, column in enumerate(points)
        )
        if sum(wanted) <= width:
            return evened(wanted, width) if self.even else tuple(wanted)
        bare = self._points([["" if BREAKS in text else text for text in row] for row in self.rows])
        least = [
            max(*(longest(row[i], em) for row in rows), *(one.width for one in column or ())) + 2 * PAD
            for i, column in enumerate(bare)
        ]
        return shared(wanted, least, width)

    def _lines(self, row: Sequence[Sequence[Cell]], widths: Sequence[float]) -> _Row:
        rooms = (width - 2 * PAD + 1e-3 for width in widths)
        return tuple(tuple(break_lines(p, room, self.style.em)) for p, room in zip(row, rooms, strict=True))

    def _height(self, row: _Row, tall: float) -> float:
        return tall + 2 * self._vertical

    def _tall(self, row: _Row) -> float:
        return max((self.style.leading, *(sum(map(self._advance, cell)) for cell in row)))

    def _advance(self, line: Line) -> float:
        return max(self.style.leading, line.ascent * MM + line.descent * MM + 2.0)

    def split(self, width: float, height: float) -> list[Flowable]:
        """Whole rows to each page, the header on both."""
        if height < self.undivided and len(self.rows) <= _PAGE_ROWS:
            return []
        found = self.set_in(width)
        ends = accumulate(found.heights, initial=found.top + _HEAVY)
        count = max(sum(end <= height for end in ends) - 1, 0)
        count = min(count, len(self.rows) - _LEAST_ROWS)  # no row less than fit, beyond what goes on must have
        count = self._ruling.before(self._before + count, self._before + _LEAST_ROWS) - self._before
        if count < (_MANY_ROWS if self.whole else _LEAST_ROWS):
            return []
        head, tail = (self._part(*ends, width, found) for ends in ((0, count), (count, len(self.rows))))
        return [head, FrameBreak(), tail]  # the rest is not split once more on this page

    def _part(self, start: int, end: int, width: float, found: _Set) -> DataTable:
        """Some of its rows, in lines already in the column of the whole."""
        caption = self.caption if start == 0 else continued(self.caption, self.lang)
        rows, groups = self.rows[start:end], self.groups[start:end]
        part = type(self)(
            self.header, rows, found.widths, self.align,
            lang=self.lang, caption=caption, style=self.style, groups=groups,
        )  # fmt: skip
        part._continued, part._vertical = self._continued or start > 0, self._vertical
        part.goal = self.goal if start == 0 else ""
        part._before, part._ruling = self._before + start, self._ruling
        body, tall = found.body[start:end], (found.tall[0], *found.tall[1:][start:end])
        own = replace(found, body=body, points=part._points(unbroken(rows, body)), tall=tall)
        part._found = {width: part._measured(own)}
        return part.made_of(self, first=start == 0)

    def draw(self) -> None:
        """Draw caption, header, rows and rules, centred in the column."""
        ink, found = Ink(self.canv), self.set_in(self.width)
        width = sum(found.widths) * MM
        left, y = (self.width - width) / 2, self.height
        if self.caption or self._continued:
            self._entitle(ink, left + width, y - CAPTION.size)
            y -= CAPTION.leading + 2.0
        y = self._rule(ink, left, y, width, _HEAVY)
        y = self._row(ink, found.head, found.widths, left, y, over(self.align), header=True)
        y = self._rule(ink, left, y, width, _FINE)
        for n, (row, texts) in enumerate(zip(found.body, self.rows, strict=True)):
            y -= self._ruling.white(self._before, n)
            if n and self._ruling.over(self._before + n, texts):
                self._rule(ink, left, y, width, LIGHT)
            shifts = [
                column[n].indent(text, width - 2 * PAD) if column is not None and len(cell) == 1 else None
                for cell, text, width, column in zip(row, texts, found.widths, found.points, strict=True)
            ]
            y = self._row(ink, row, found.widths, left, y, self.align, shifts)
        self._rule(ink, left, y, width, _HEAVY)
        ink.flush()

    def _entitle(self, ink: Ink, right: float, y: float) -> None:
        """The caption in the middle; over what is left of a table, at its right end, that it goes on."""
        title = joined(cells(self.caption or CONTINUED.of(self.lang), CAPTION.em, self.lang == "zh", True), CAPTION.em)
        if self.caption:
            ink.under(tree_of(self.canv).opener(Tag(Role.CAPTION, self.tag)))
            ink.box(title, (self.width - title.width * MM) / 2, y)
            return
        with artifact(self.canv):
            own = Ink(self.canv)
            own.box(title, right - title.width * MM, y)
            own.flush()

    def _rule(self, ink: Ink, x: float, y: float, width: float, weight: float) -> float:
        ink.rule(x, y - weight, width, weight)
        return y - weight

    def _row(
        self, ink: Ink, row: _Row, widths: Sequence[float], left: float, top: float, align: str,
        shifts: Sequence[float | None] = (), header: bool = False,
    ) -> float:  # fmt: skip
        height, tag = self._height(row, self._tall(row)), Tag(Role.ROW, self.tag)
        x = left
        for cell, width, side, shift in zip(row, widths, align, shifts or (None,) * len(row), strict=True):
            marks = self._marks(tag, header)
            y = top - (height - sum(map(self._advance, cell))) / 2
            for line in cell:
                advance = self._advance(line)
                rise = (advance - self.style.size) / 2 + 0.86 * self.style.size
                rise = max(rise, line.ascent * MM + 1.0)
                begin, way = x + (PAD + (shift or 0.0)) * MM, _ALIGN[side] if shift is None else "left"
                draw_line(ink, line, begin, y - rise, width - 2 * PAD, way, marks)
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
