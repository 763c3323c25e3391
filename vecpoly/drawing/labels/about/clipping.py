"""Straight pieces against upright boxes: whether they enter, and how much of each lies inside."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .bounds import Complexes, Floats


def inside(start: Complexes, d: Complexes, dx: Floats | float, dy: Floats | float) -> tuple[Floats, NDArray[np.bool_]]:
    """Of pieces that go by d from a start seen from the middle of a box (± dx, ± dy) the share inside it, and whether
    they enter at all."""
    share = np.maximum(_share_inside(start, d, dx, dy), 0.0)
    return share, share > 0.0


def enters(a: Complexes, b: Complexes, centre: Complexes, dx: Floats | float, dy: Floats | float) -> NDArray[np.bool_]:
    """Whether each piece enters its box at all."""
    result: NDArray[np.bool_] = _share_inside(a - centre, b - a, dx, dy) > 0.0
    return result


def _share_inside(start: Complexes, d: Complexes, dx: Floats | float, dy: Floats | float) -> Floats:
    """Of pieces that go by d from a start seen from the middle of a box the share inside it, not above nothing where
    there is none (Liang and Barsky)."""
    ends = [_passed(p, s, half) for p, s, half in ((d.real, start.real, dx), (d.imag, start.imag, dy))]
    (low, high), (sooner, later) = ends
    low, high = np.maximum(low, sooner, out=sooner), np.minimum(high, later, out=later)
    share: Floats = np.minimum(high, 1.0, out=high)
    share -= np.maximum(low, 0.0, out=low)
    return share


def _passed(p: Floats, s: Floats, half: Floats | float) -> tuple[Floats, Floats]:
    """Where on their way pieces pass into the strip ± half and out of it."""
    steep = np.where(np.abs(p) < 1e-12, 1e-12, p)
    one, other = -half - s, half - s
    one /= steep
    other /= steep
    return np.minimum(one, other), np.maximum(one, other)
