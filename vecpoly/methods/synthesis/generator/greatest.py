"""Where a number that was read at many places is greatest: the best of them, then ever nearer."""

from __future__ import annotations

from ...roots import Curve, top

TRIALS, FINER = 720, 60


def place_of_greatest(of: Curve) -> float:
    """The place between 0 and 1, ends included."""
    at = [n / TRIALS for n in range(TRIALS + 1)]
    best = max(range(TRIALS + 1), key=lambda n: of(at[n]))
    low, high = at[max(best - 1, 0)], at[min(best + 1, TRIALS)]
    return max((at[best], top(of, low, high, FINER)), key=of)
