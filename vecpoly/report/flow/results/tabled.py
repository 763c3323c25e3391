"""The frame of an answer of which something was read: its title with what holds of all, its tables, what has no row
there, the notes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Self

from ....foundation.slotted import replace
from ....tagging.tag import Tag
from ....tagging.tree import artifact
from ....typeset.box import MM
from ....typeset.canvas import Ink
from ....typeset.words import layout_words
from ....words import Lang
from ...answers.line import AnswerLine
from ..base import Block, Tightness
from .box import AFTER_TITLE, PAD, WHOLE, AnswerBox
from .framed import FramedTable
from .grid import GridRow, Told, even, sentence

_APART, _END = 2.4, 1.3  # mm between a table and what stands above or below it; below the last table of a frame
_LEAST = 0.7  # of that, where the text is set more tightly
_RULE = 0.45  # pt


class TabledAnswers(AnswerBox):
    """head: the scales, and what the columns mean, beside the title; tables: of values and of places; lines: what is
    no number that was read."""

    compared = True

    def __init__(
        self,
        tables: Sequence[FramedTable],
        lines: Sequence[AnswerLine] = (),
        said: Sequence[str] = (),
        lang: Lang = "zh",
        notes: Sequence[str] = (),
        head: str = "",
    ) -> None:
        super().__init__(lines, said, lang, notes)
        self.tables, self.head = tuple(tables), head
        self._entitled: tuple[GridRow, ...] = ()  # the title and the lines beside it
        self._apart = _APART
        self.put_within(self.tag)

    def put_within(self, outer: Tag) -> None:
        """Its tables are parts of it."""
        if outer is not self.tag:
            super().put_within(outer)
        for table in self.tables:
            table.tag = Tag(table.role, self.tag)

    def tighten(self, degree: Tightness) -> None:
        """Its tables too."""
        super().tighten(degree)
        self.tables = tuple(table.copied(degree) for table in self.tables)
        self._apart = max(_LEAST, degree.white) * _APART

    @property
    def directed(self) -> bool:
        """Whether a direction stands in it as an angle."""
        cells = (cell for table in self.tables for row in table.rows for cell in row)
        return super().directed or any(cell.startswith("∠") for cell in cells)

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column."""
        self.width, inner = width, width / MM - 2 * PAD
        if not self._set:
            self._entitled = tuple(self._begun(inner))
            self._rows = tuple(even((*self._grouped(inner), *self._sentences(inner)), self.lines, self._em))
        self.height = (self._top + sum(self._tall(width)) + self._foot) * MM
        return width, self.height

    def _begun(self, inner: float) -> Iterator[GridRow]:
        """The title, and beside it what holds of all values."""
        left = self._title.width + AFTER_TITLE
        told = Told(None, after=self.head)
        lines = [*sentence(self.head, self._em, inner - left, self.lang == "zh")] if self.head else []
        named = (0.0, self._title, self._named)
        rows: list[GridRow] = [((left, line, told),) for line in lines]
        yield from ((named, *rows[0]), *rows[1:]) if rows else ((named,),)

    @property
    def _top(self) -> float:
        """How far the first table is below the upper edge (mm)."""
        return PAD + (self._high(self._entitled) + self._apart if self._entitled else -_END)

    @property
    def _foot(self) -> float:
        """What stands below the tables (mm)."""
        return self._apart + self._high(self._rows) + PAD if self._rows else _END

    def _tall(self, width: float) -> list[float]:
        """How high each table is with the white above it (mm)."""
        inner = width - 2 * PAD * MM
        return [table.wrap(inner, 0.0)[1] / MM + self._apart * (n > 0) for n, table in enumerate(self.tables)]

    def split(self, width: float, height: float) -> list[Block]:
        """Whole rows to each page, of an answer too tall to be kept together; what stands below its tables keeps some
        rows of the last with it."""
        if self.wrap(width, height)[1] <= WHOLE:
            return []
        room = (height - self.getSpaceBefore()) / MM - self._top - _END
        tall, count = self._tall(width), 0
        while count < len(tall) - 1 and sum(tall[: count + 1]) <= room:
            count += 1
        left = room - sum(tall[:count]) - self._apart * (count > 0)
        parts = self.tables[count].split(width - 2 * PAD * MM, min(left, tall[count] - 2.0) * MM) if left > 0 else []
        halves = [part for part in parts if isinstance(part, FramedTable)]
        if len(halves) == 2:
            head, tail = halves
            return [
                self._cut((*self.tables[:count], head), first=True),
                self._cut((tail, *self.tables[count + 1 :]), first=False),
            ]
        if not count:
            return []
        return [self._cut(self.tables[:count], first=True), self._cut(self.tables[count:], first=False)]

    def _cut(self, tables: Sequence[FramedTable], *, first: bool) -> Self:
        """A part of it with these tables."""
        part = type(self)((), (), (), self.lang)
        part.tables, part._skip, part._apart, part._set = tuple(tables), self._skip, self._apart, True
        part._entitled, part._rows = (self._entitled, ()) if first else ((), self._rows)
        if not first:
            part._title = replace(layout_words("", self._em, True), items=())
        return part.made_of(self, first=first)

    def draw(self) -> None:
        """Draw the frame, the title with what stands beside it, the tables under a rule, and the rest."""
        self._frame_drawn()
        ink, top = Ink(self.canv), self._top
        if self._entitled:
            self._written(ink, self._entitled, PAD, PAD)
            ink.flush()
            self._ruled(top - 0.3 * self._apart)
        for n, (table, tall) in enumerate(zip(self.tables, self._tall(self.width), strict=True)):
            if n:
                self._ruled(top + 0.4 * self._apart)
            top += tall
            table.drawOn(self.canv, PAD * MM, self.height - top * MM)
        if self._rows:
            self._ruled(top + 0.4 * self._apart)
            self._written(rest := Ink(self.canv), self._rows, PAD, top + self._apart)
            rest.flush()

    def _ruled(self, down: float) -> None:
        """A line across the frame so far (mm) from its upper edge."""
        with artifact(self.canv):
            self.canv.setLineWidth(_RULE)
            self.canv.line(0.0, self.height - down * MM, self.width, self.height - down * MM)
