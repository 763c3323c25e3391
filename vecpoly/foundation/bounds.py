"""One verdict on the boundary: numbers that are equal as written are equal, however their sums are rounded."""

from __future__ import annotations

from math import isclose

ROUNDED = 1e-9  # of the greater: what two equal numbers may differ by


def below(one: float, other: float) -> bool:
    """Whether one number is less than another by more than rounding: 44 mm + 26 mm is not below 70 mm."""
    return one < other and not isclose(one, other, rel_tol=ROUNDED)
