"""Numbers of three digits; small ones of a table in thousandths, told so in the heads of their columns: 0.271 /10⁻³."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, log10

import numpy as np

from ....algebra.quantity import number
from ....algebra.rounding import as_printed

_DIGITS, _LONG = 3, 8  # significant digits of a deviation; decimals, beyond which a power of ten is shorter
_SMALL, _MOST = 0.01, 1.0  # the least of them is below, the greatest not above
_HEAD = " /$10^{−3}$"
_NOTHING = ("—", "0")


def figures(value: float) -> str:
    """Three digits with their last zeros, so that a column reads evenly."""
    if not value or not np.isfinite(value):
        return number(value)
    told = as_printed(float(value), _DIGITS)
    places = max(0, _DIGITS - 1 - floor(log10(abs(told))))
    return f"{told:.{places}f}" if places <= _LONG else number(told, _DIGITS)


def in_thousandths(
    heads: Sequence[str], rows: Sequence[tuple[str, ...]], columns: Sequence[int]
) -> tuple[list[str], list[tuple[str, ...]]]:
    """Heads and rows, with the numbers of these columns a thousand times as large and 10⁻³ in their heads, where the
    least is small and none is large; else as they are."""
    cells = [row[n] for row in rows for n in columns if row[n] not in _NOTHING]
    if not cells or not all(cell.replace(".", "", 1).isdigit() for cell in cells):
        return [*heads], [*rows]
    sizes = [float(cell) for cell in cells]
    if min(sizes) >= _SMALL or max(sizes) > _MOST:
        return [*heads], [*rows]
    grown = [tuple(_grown(cell) if n in columns else cell for n, cell in enumerate(row)) for row in rows]
    return [f"{head}{_HEAD}" if n in columns else head for n, head in enumerate(heads)], grown


def _grown(cell: str) -> str:
    return cell if cell in _NOTHING else figures(1e3 * float(cell))
