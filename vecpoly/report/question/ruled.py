"""Tables to write in: every row high enough for handwriting, every cell with a line on all sides."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate

from ...tagging.tree import artifact
from ...typeset.box import MM
from ..flow.lines import Line
from ..flow.style import GREY
from ..flow.table import DataTable

ROW = 8.5 * MM  # least height of a row to be written in
_FINE = 0.4  # pt


class RuledTable(DataTable):
    """A table whose empty cells are filled in by hand; a row with nothing but its first text is the name of a group."""

    def _height(self, row: tuple[tuple[Line, ...], ...]) -> float:
        """As high as a hand needs it; a row of several lines is higher."""
        return max(super()._height(row), ROW)

    def draw(self) -> None:
        """The table, and the lines between its cells."""
        super().draw()
        found = self.set_in(self.width)
        edges = [*accumulate(found.widths, initial=0.0)]
        left = (self.width - edges[-1] * MM) / 2
        bottoms = [self.height - found.top - below for below in accumulate(found.heights)]
        self.colour(GREY)
        self.canv.setLineWidth(_FINE)
        with artifact(self.canv):
            for texts, bottom, high in zip(self.rows, bottoms, found.heights, strict=True):
                self._rules(texts, [left + edge * MM for edge in edges], bottom, high)

    def _rules(self, texts: Sequence[str], edges: Sequence[float], bottom: float, high: float) -> None:
        """The line under a row, and those between its cells."""
        self.canv.line(edges[0], bottom, edges[-1], bottom)
        for n, edge in enumerate(edges[1:-1]):
            if texts[n + 1] or not named(texts, n):
                self.canv.line(edge, bottom, edge, bottom + high)


def named(texts: Sequence[str], n: int) -> bool:
    """Whether this cell belongs to the name of a group, which runs on over the empty ones behind it."""
    last = next((text for text in texts[n::-1] if text), "")
    return last.startswith("**")
