"""A grid of written values, one of which every student gets."""

from __future__ import annotations

from decimal import Decimal

from ..foundation.slotted import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Range:
    """A grid of values: first, first + step ... in the unit in which they are written; every value is exact as text."""

    name: str
    first: Decimal
    step: Decimal
    count: int
    unit: str

    def at(self, index: int) -> str:
        """The value with this number on the grid, as it is written in a problem file."""
        number = format((self.first + index * self.step).normalize(), "f")
        return f"{number} {self.unit}".strip()

    def __str__(self) -> str:
        return f"{self.name}: {self.at(0)} .. {self.at(self.count - 1)}"
