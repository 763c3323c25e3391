"""A long and narrow table: its halves beside each other where the column has room for both."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any, Self

from reportlab.platypus.flowables import Flowable

from ....tagging.tag import Tag
from ....typeset.box import MM
from ..base import Tightness
from ..cells import Cell, cells, joined
from ..table import PAD, DataTable

LONG = 8  # rows that stay in one block
GAP = 8.0  # mm between the halves
_SET = tuple[DataTable, DataTable]


class HalvedTable(DataTable):
    """A table in two halves of the same columns, the heads of which may take two lines."""

    _halves: _SET | None = None
    _tight: tuple[Tightness, ...] = ()

    def __init__(self, *table: Any, **said: Any) -> None:
        super().__init__(*table, **said)
        self._apart: dict[float, _SET | None] = {}  # by width of the column; one for the table and all its copies

    @classmethod
    def of(cls, table: DataTable) -> Self:
        """The same table, set so."""
        return cls(
            table.header, table.rows, table.widths, table.align,
            lang=table.lang, caption=table.caption, groups=table.groups,
        )  # fmt: skip

    def tighten(self, degree: Tightness) -> None:
        """Each half too."""
        super().tighten(degree)
        self._tight = (*self._tight, degree)

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column: that of the first half, which has as many rows, or of the whole where two have no room."""
        self._halves = self._parted(width)
        if self._halves is None:
            return super().wrap(width, height)
        self.width, self.height = width, self._halves[0].wrap(width, height)[1]
        return width, self.height

    def split(self, width: float, height: float) -> list[Flowable]:
        """Halves are low, and go to the next page together."""
        return super().split(width, height) if self._parted(width) is None else []

    def draw(self) -> None:
        """One half after the other, which is how they are read."""
        if self._halves is None:
            super().draw()
            return
        wide = sum(self._halves[0].widths or ()) * MM
        left = (self.width - 2 * wide - GAP * MM) / 2
        for n, half in enumerate(self._halves):
            half.wrap(wide, self.height)
            half.tag = Tag(half.role, self.tag.within)
            half.drawOn(self.canv, left + n * (wide + GAP * MM), self.height - half.height)

    def _parted(self, width: float) -> _SET | None:
        """The halves as they are set now, where both have room."""
        if len(self.rows) <= LONG or self.caption or self._continued:
            return None
        if width not in self._apart:
            self._apart[width] = self._divided(width)
        halves = self._apart[width]
        return None if halves is None else (self._as_tight(halves[0], width), self._as_tight(halves[1], width))

    def _divided(self, width: float) -> _SET | None:
        """The halves as the table was at first, their lines broken."""
        widths = next((some for some in (self.set_in(width).widths, self._narrow(width)) if _fit(some, width)), None)
        if widths is None:
            return None
        middle = (len(self.rows) + 1) // 2
        return self._half(slice(middle), widths), self._half(slice(middle, None), widths)

    def _half(self, rows: slice, widths: tuple[float, ...]) -> DataTable:
        return self._made(
            self.header, self.rows[rows], widths, self.align,
            lang=self.lang, style=self.style, groups=self.groups[rows],
        )  # fmt: skip

    def _made(self, *table: Any, **said: Any) -> DataTable:
        """What its halves are."""
        return DataTable(*table, **said)

    def _as_tight(self, half: DataTable, width: float) -> DataTable:
        """A copy of a half, set as the table is; its lines are broken once for all of them."""
        half.set_in(width)
        own = copy(half)
        for degree in self._tight:
            own.tighten(degree)
        return own

    def _narrow(self, width: float) -> tuple[float, ...]:
        """The widths of the columns (mm), of a head that of its longest word."""
        em, chinese = self.style.em, self.lang == "zh"
        found = []
        for n, (head, wide) in enumerate(zip(self.header, self.set_in(width).widths, strict=True)):
            texts = [row[n] for row in self.rows]
            body = max(joined(cells(text, em, chinese), em).width for text in texts)
            points = max((one.width for one in self.set_in(width).points[n] or ()), default=0.0)
            longest = max(joined(word, em).width for word in _words(cells(head, em, chinese, True)))
            found.append(min(wide, max(body, points, longest) + 2 * PAD))
        return tuple(found)


def even(table: DataTable) -> DataTable:
    """The table, set as wide as others of its page; two halves take what they need."""
    table.even = not isinstance(table, HalvedTable) or len(table.rows) <= LONG
    return table


def _fit(widths: tuple[float, ...], width: float) -> bool:
    """Whether columns so wide (mm) have room twice in that (pt)."""
    return 2 * sum(widths) + GAP <= width / MM


def _words(head: Sequence[Cell]) -> list[list[Cell]]:
    """A head at its blanks."""
    found: list[list[Cell]] = [[]]
    for cell in head:
        if cell.spaced and found[-1]:
            found.append([])
        found[-1].append(cell)
    return found
