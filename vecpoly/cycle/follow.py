"""Angles followed without jumps."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]


def follow(angle: Reals) -> Reals:
    """The angle (rad, known up to whole turns) with every step less than half a turn; gaps of NaN are stepped over."""
    out = np.array(angle)
    known = np.flatnonzero(np.isfinite(out)) if np.isnan(out.sum()) else None
    values = out if known is None else out[known]
    step = np.diff(values)
    for i in np.flatnonzero(np.abs(step) > np.pi):  # a jump: once or twice a turn
        values[i + 1 :] -= 2 * np.pi * np.round(step[i] / (2 * np.pi))
    if known is not None:
        out[known] = values
    return out
