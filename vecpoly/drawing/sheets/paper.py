"""The paper on which a construction is to be drawn, as the board's planner sees it: how much room there is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ...board.construction import View
from .packing import fits_sheet
from .slicing import Size
from .space import room, slots


@dataclass(frozen=True, slots=True)
class A4Paper:
    """A4 sheets, upright or across."""

    landscape: bool = False

    def room(self, view: View, count: int = 1) -> Size:
        """What each of so many figures of a kind should fill (mm)."""
        return room(view, count)

    def slots(self, count: int) -> tuple[Size, ...]:
        """What each of so many figures on one sheet should fill (mm)."""
        return slots(count)

    def fits(self, sizes: Sequence[Size]) -> bool:
        """Whether figures of these sizes go on one sheet."""
        return fits_sheet(sizes, self.landscape)
