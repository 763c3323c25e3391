"""The range through which an input link turns."""

from __future__ import annotations

from math import ceil, floor, pi


def extremes(low: float, high: float) -> tuple[float, ...]:
    """Where BD may be shortest or longest while AB turns from low to high (rad): at both ends, on the line of AD."""
    return (low, high, *(pi * n for n in range(ceil(low / pi), floor(high / pi) + 1)))
