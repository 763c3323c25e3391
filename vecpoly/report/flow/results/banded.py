"""Light rules between rows: under every sixth of a long table of numbers, by which the eye keeps to a row, between
groups of rows that have one head, and over a row of sums."""

from __future__ import annotations

from collections.abc import Sequence

from ....algebra.columns import TOTAL
from ....foundation.slotted import dataclass

LIGHT = 0.2  # pt
_LONG, _BAND = 18, 6  # rows of such a table, at least; rows between two rules


def is_banded(rows: Sequence[Sequence[str]]) -> bool:
    """Whether it is long, and a number stands at the head of each row."""
    return len(rows) >= _LONG and all(row[0].replace("−", "").replace(".", "", 1).isdigit() for row in rows)


def is_grouped(rows: Sequence[Sequence[str]]) -> bool:
    """Whether several rows have one head, which stands in the first of them: a position, its quantities."""
    heads = [row[0] for row in rows]
    return "" in heads and heads[0] != "" and sum(head != "" for head in heads) > 1


def is_parted(row: int, cells: Sequence[str], banded: bool) -> bool:
    """Whether a rule stands over the row of this number, of the whole table, from 0 on."""
    return row > 0 and (cells[0] == TOTAL or (banded and not row % _BAND))


@dataclass(frozen=True, slots=True)
class Rules:
    """The rules of a table of so many rows."""

    banded: bool
    grouped: bool
    count: int

    @classmethod
    def of(cls, rows: Sequence[Sequence[str]]) -> Rules:
        """As these rows ask for."""
        return cls(is_banded(rows), is_grouped(rows), len(rows))

    def over(self, row: int, cells: Sequence[str]) -> bool:
        """Whether one stands over this row, from 0 on; no band is the last row alone."""
        banded = self.banded and row != self.count - 1
        return is_parted(row, cells, banded) or (row > 0 and self.grouped and cells[0] != "")
