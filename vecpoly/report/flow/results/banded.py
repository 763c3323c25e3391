"""What parts the rows of a table: a little white under every sixth of a long table of numbers, by which the eye keeps
to a row, and where a page break may part it; light rules between groups of rows that have one head, and over a row
of sums."""

from __future__ import annotations

from collections.abc import Sequence

from ....algebra.columns import TOTAL
from ....foundation.slotted import dataclass

LIGHT, WHITE = 0.2, 3.0  # pt: a rule, the white between two bands of rows
_LONG, _BAND = 18, 6  # rows of such a table, at least; rows of a band


def is_banded(rows: Sequence[Sequence[str]]) -> bool:
    """Whether it is long, and a number stands at the head of each row."""
    return len(rows) >= _LONG and all(row[0].replace("−", "").replace(".", "", 1).isdigit() for row in rows)


def is_grouped(rows: Sequence[Sequence[str]]) -> bool:
    """Whether several rows have one head, which stands in the first of them: a position, its quantities."""
    heads = [row[0] for row in rows]
    return "" in heads and heads[0] != "" and sum(head != "" for head in heads) > 1


@dataclass(frozen=True, slots=True)
class Rules:
    """The rules and the bands of a table of so many rows."""

    banded: bool
    grouped: bool
    count: int

    @classmethod
    def of(cls, rows: Sequence[Sequence[str]]) -> Rules:
        """As these rows ask for."""
        return cls(is_banded(rows), is_grouped(rows), len(rows))

    def over(self, row: int, cells: Sequence[str]) -> bool:
        """Whether a rule stands over this row, of the whole table, from 0 on."""
        return row > 0 and (cells[0] == TOTAL or (self.grouped and cells[0] != ""))

    def white(self, before: int, row: int) -> float:
        """What stays free (pt) over this row of what is left of a table behind so many rows: over the first of a band,
        unless that is the last of all, or the first here."""
        there = before + row
        return WHITE if self.banded and row > 0 and not there % _BAND and there != self.count - 1 else 0.0

    def before(self, row: int, least: int) -> int:
        """How many rows stand before a page break after so many at most: whole bands, if these are enough."""
        whole = row - row % _BAND
        return whole if self.banded and whole >= least else row
