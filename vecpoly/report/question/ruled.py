"""Tables to write in: every row high enough for handwriting, every cell with a line on all sides."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate
from typing import Any

from ...tagging.tree import artifact
from ...typeset.box import MM, Glyphs
from ...typeset.canvas import Ink
from ...typeset.fonts import Face
from ..flow.cells import Cell
from ..flow.results.banded import Rules
from ..flow.style import GREY
from ..flow.table import DataTable
from ..flow.text.breaks import Line

ROW, NAME = 8.0 * MM, 6.5 * MM  # least height of a row to be written in, and of one that names a group
_BOLD = {Face.BOLD, Face.BOLD_ITALIC, Face.HEI, Face.HEI_BOLD}
_FINE = 0.4  # pt
NONE, FAINT = "—", (0.95, 0.95, 0.95)  # of a cell in which nothing is written, and how it is shaded


class RuledTable(DataTable):
    """A table whose empty cells are filled in by hand; a row with nothing but its first text is the name of a group."""

    def __init__(self, *args: Any, **settings: Any) -> None:
        super().__init__(*args, **settings)
        self._ruling = Rules(False, False, len(self.rows))  # a cell that is left over begins no group

    def _height(self, row: tuple[tuple[Line, ...], ...], tall: float) -> float:
        """As high as a hand needs it; a row of several lines is higher, one that nobody writes in lower."""
        return max(super()._height(row, tall), NAME if is_name(_cells(row)) else ROW)

    def _lines(self, row: Sequence[Sequence[Cell]], widths: Sequence[float]) -> tuple[tuple[Line, ...], ...]:
        """The name of a group runs on over the empty cells behind it; a cell that stays blank has no text."""
        row = [() if _is_blank(some) else some for some in row]
        if not is_name([cell for some in row for cell in some]):
            return super()._lines(row, widths)
        return super()._lines(row, joined(row, widths))

    def _row(
        self, ink: Ink, row: tuple[tuple[Line, ...], ...], widths: Sequence[float], left: float, top: float, align: str,
        shifts: Sequence[float | None] = (), header: bool = False,
    ) -> float:  # fmt: skip
        """A row; the name of a group over all of its cells."""
        wide = joined(row, widths) if is_name(_cells(row)) and not header else widths
        return super()._row(ink, row, wide, left, top, align, shifts, header)

    def draw(self) -> None:
        """The table, and the lines between its cells; those that stay blank are shaded."""
        found = self.set_in(self.width)
        edges = [*accumulate(found.widths, initial=0.0)]
        left = (self.width - edges[-1] * MM) / 2
        bottoms = [self.height - found.top - below for below in accumulate(found.heights)]
        rows = [*zip(self.rows, bottoms, found.heights, strict=True)]
        places = [left + edge * MM for edge in edges]
        self.canv.saveState()
        self.canv.setFillColorRGB(*FAINT)
        with artifact(self.canv):
            for texts, bottom, high in rows:
                self._shades(texts, places, bottom, high)
        self.canv.restoreState()
        super().draw()
        self.colour(GREY)
        self.canv.setLineWidth(_FINE)
        with artifact(self.canv):
            for texts, bottom, high in rows:
                self._rules(texts, places, bottom, high)

    def _shades(self, texts: Sequence[str], edges: Sequence[float], bottom: float, high: float) -> None:
        """The cells of a row in which nothing is to be written."""
        for text, start, end in zip(texts, edges, edges[1:], strict=False):
            if text == NONE:
                self.canv.rect(start, bottom, end - start, high, stroke=0, fill=1)

    def _rules(self, texts: Sequence[str], edges: Sequence[float], bottom: float, high: float) -> None:
        """The line under a row, and those between its cells."""
        self.canv.line(edges[0], bottom, edges[-1], bottom)
        for n, edge in enumerate(edges[1:-1]):
            if texts[n + 1] or not named(texts, n):
                self.canv.line(edge, bottom, edge, bottom + high)


def joined(row: Sequence[Sequence[object]], widths: Sequence[float]) -> tuple[float, ...]:
    """The widths of cells that run on over the empty ones behind them."""
    starts = [n for n, some in enumerate(row) if some]
    ends = dict(zip(starts, [*starts[1:], len(row)], strict=True))
    return tuple(sum(widths[n : ends.get(n, n)]) for n in range(len(row)))


def _is_blank(cells: Sequence[Cell]) -> bool:
    """Whether it says that nothing is to be written there."""
    return [item.text for cell in cells for item in cell.box.items if isinstance(item, Glyphs)] == [NONE]


def _cells(row: Sequence[Sequence[Line]]) -> list[Cell]:
    return [cell for lines in row for line in lines for cell in line.cells]


def is_name(cells: Sequence[Cell]) -> bool:
    """Whether there is nothing but names of groups, which are bold."""
    glyphs = [item for cell in cells for item in cell.box.items if isinstance(item, Glyphs) and item.text.strip()]
    return any(item.font in _BOLD for item in glyphs) and all(
        item.font in _BOLD or not item.text.isalpha() for item in glyphs
    )


def named(texts: Sequence[str], n: int) -> bool:
    """Whether this cell belongs to the name of a group, which runs on over the empty ones behind it."""
    last = next((text for text in texts[n::-1] if text), "")
    return last.startswith("**")
