"""Where a number that was read at many places is greatest: the best of them, then ever nearer."""

from __future__ import annotations

from collections.abc import Callable

TRIALS, FINER = 720, 60
GOLDEN = (5**0.5 - 1) / 2


def place_of_greatest(of: Callable[[float], float]) -> float:
    """The place between 0 and 1, ends included."""
    at = [n / TRIALS for n in range(TRIALS + 1)]
    best = max(range(TRIALS + 1), key=lambda n: of(at[n]))
    low, high = at[max(best - 1, 0)], at[min(best + 1, TRIALS)]
    for _ in range(FINER):
        left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        low, high = (left, high) if of(left) < of(right) else (low, right)
    return max((at[best], (low + high) / 2), key=of)
