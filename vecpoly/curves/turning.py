"""The turning points of a sampled curve, to a fraction of a line's width: where its dots stand."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]
WORTH = 0.25  # of half the range: a turning point farther than this from the middle is marked
_SMOOTH = 0.02  # of the range: neighbours farther apart stand on both sides of a jump


def turning(x: Reals, y: Reals, periodic: bool) -> list[tuple[float, float]]:
    """The greatest and least values that are no ends, and other turning points nearly as far from the middle:
    parabolas through three samples each."""
    known = y[np.isfinite(y)]
    if not known.size or float(np.ptp(known)) <= 1e-9 * max(1.0, float(np.abs(known).max())):
        return []
    middle, half = (float(known.max()) + float(known.min())) / 2, float(np.ptp(known)) / 2
    before, after = (
        np.r_[y[-2] if periodic else np.nan, y[:-1]],
        np.r_[y[1:], np.nan],
    )  # the last is no place of its own
    with np.errstate(invalid="ignore"):
        high = (y > before) & (y >= after) & (y > middle + WORTH * half)
        low = (y < before) & (y <= after) & (y < middle - WORTH * half)
    step = float(x[1] - x[0])
    found = []
    for i in np.flatnonzero(high | low):
        y0, y1, y2 = float(before[i]), float(y[i]), float(after[i])
        bend = y0 - 2 * y1 + y2
        shift = 0.5 * (y0 - y2) / bend if bend and abs(y0 - y2) < _SMOOTH * half else 0.0
        found.append((float(x[i]) + shift * step, y1 - 0.25 * (y0 - y2) * shift))
    return [(max(place, float(x[0])), value) for place, value in found]
