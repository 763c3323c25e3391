"""Where a number that was read at many places is greatest: the best of them, then ever nearer."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ...roots import top

TRIALS, FINER = 720, 60
ALIKE = 1e-12  # of the range of the values: of several that differ by rounding alone, the first is the greatest


def place_of_greatest(of: Callable[[Any], Any]) -> float:
    """The place between 0 and 1, ends included, where a curve is highest that is read at one place or at an array."""
    at = np.arange(TRIALS + 1) / TRIALS
    values = of(at)
    highest = np.nanmax(values)
    best = int(np.argmax(values >= highest - ALIKE * (highest - np.nanmin(values))))
    low, high = at[max(best - 1, 0)], at[min(best + 1, TRIALS)]
    return float(max((at[best], top(of, low, high, FINER)), key=of))
