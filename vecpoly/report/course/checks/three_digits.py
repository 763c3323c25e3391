"""Numbers of three digits."""

from __future__ import annotations

from math import floor, log10

import numpy as np

from ....algebra.quantity import number
from ....algebra.rounding import as_printed

_DIGITS, _LONG = 3, 8  # significant digits of a deviation; decimals, beyond which a power of ten is shorter


def figures(value: float) -> str:
    """Three digits with their last zeros, so that a column reads evenly."""
    if not value or not np.isfinite(value):
        return number(value)
    told = as_printed(float(value), _DIGITS)
    places = max(0, _DIGITS - 1 - floor(log10(abs(told))))
    return f"{told:.{places}f}" if places <= _LONG else number(told, _DIGITS)
