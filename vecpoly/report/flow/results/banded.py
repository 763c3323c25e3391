"""Light rules between rows: under every sixth of a long table of numbers, by which the eye keeps to a row, and over a
row of sums."""

from __future__ import annotations

from collections.abc import Sequence

from ....algebra.columns import TOTAL

LIGHT = 0.2  # pt
_LONG, _BAND = 18, 6  # rows of such a table, at least; rows between two rules


def is_banded(rows: Sequence[Sequence[str]]) -> bool:
    """Whether it is long, and a number stands at the head of each row."""
    return len(rows) >= _LONG and all(row[0].replace("−", "").replace(".", "", 1).isdigit() for row in rows)


def is_parted(row: int, cells: Sequence[str], banded: bool) -> bool:
    """Whether a rule stands over the row of this number, of the whole table, from 0 on."""
    return row > 0 and (cells[0] == TOTAL or (banded and not row % _BAND))
