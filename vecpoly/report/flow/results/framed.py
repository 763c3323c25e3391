"""A table within the frame of the answer: as wide as that, its rows close, ruled under its heads alone."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any, Self

from ....typeset.box import MM
from ....typeset.canvas import Ink
from ..base import Tightness
from ..cells import Cell
from ..table import DataTable
from .decimal import Columns
from .halved import GAP, HalvedTable

_CLOSE, _OPENER = 0.9, 3.0  # pt above and below a row; times as much as other white where a text is set more openly
_LINE = 0.3  # pt: under the heads


class FramedTable(HalvedTable):
    """keys: of the answers that each row tells; over: the names of what is off by more than expected."""

    keys: tuple[tuple[str, ...], ...] = ()
    over: tuple[str, ...] = ()

    def __init__(self, *table: Any, **said: Any) -> None:
        super().__init__(*table, **said)
        self.spaceBefore = self.spaceAfter = 0.0
        self._vertical = _CLOSE

    def copied(self, degree: Tightness) -> Self:
        """A copy, set so."""
        own = copy(self)
        own.tighten(degree)
        return own

    def tighten(self, degree: Tightness) -> None:
        """Its rows closer still."""
        super().tighten(degree)
        self._vertical = _CLOSE * (1.0 + _OPENER * max(0.0, degree.white - 1.0)) * min(1.0, degree.white)
        self._found = {width: self._measured(found) for width, found in self._found.items()}

    def _columns(self, width: float, rows: Sequence[Sequence[Sequence[Cell]]], points: Columns) -> tuple[float, ...]:
        """All of the width, shared alike by what the columns leave."""
        found = super()._columns(width, rows, points)
        more = max(0.0, width - sum(found)) / len(found)
        return found if self.widths else tuple(one + more for one in found)

    def _made(self, *table: Any, **said: Any) -> DataTable:
        return FramedTable(*table, **said)

    def _divided(self, width: float) -> tuple[DataTable, DataTable] | None:
        halves = super()._divided(width)
        if halves is None:
            return None
        wide = (width / MM - GAP) / 2
        for half in halves:
            assert half.widths is not None
            more = (wide - sum(half.widths)) / len(half.widths)
            half.widths = tuple(one + more for one in half.widths)
        return halves

    def _rule(self, ink: Ink, x: float, y: float, width: float, weight: float) -> float:
        """Under the heads and between groups; the frame closes it above and below."""
        if weight < 0.8:
            ink.rule(x, y - _LINE, width, _LINE)
        return y - weight
