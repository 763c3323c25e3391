"""Long tables of numbers have a light rule under every sixth row, by which the eye keeps to a row."""

from __future__ import annotations

from collections.abc import Sequence

LIGHT = 0.2  # pt
_LONG, _BAND = 18, 6  # rows of such a table, at least; rows between two rules


def is_banded(rows: Sequence[Sequence[str]]) -> bool:
    """Whether it is long, and a number stands at the head of each row."""
    return len(rows) >= _LONG and all(row[0].replace("−", "").replace(".", "", 1).isdigit() for row in rows)


def ends_band(row: int) -> bool:
    """Whether a rule stands under the row of this number, of the whole table, from 0 on."""
    return not (row + 1) % _BAND
