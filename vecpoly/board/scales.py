"""Round scales: 1, 2, 2.5, 3, 4, 5, 6, 8 × 10ⁿ per mm, the smallest with which a figure still fits its place."""

from __future__ import annotations

from math import floor, log10

SERIES = (1.0, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)


def round_up(value: float) -> float:
    """The smallest scale of the series that is not below `value`."""
    power = floor(log10(value))
    step = next(s for s in SERIES if s * 10.0**power >= value * (1 - 1e-9))
    return float(f"{step:g}e{power}")


def round_scale(scale: float, size: tuple[float, float], place: tuple[float, float]) -> float:
    """The round scale for a figure that takes `size` (mm) at `scale` and should fill `place` (mm)."""
    needed = max(size[0] / place[0], size[1] / place[1])
    return round_up(scale * needed) if needed > 0 else round_up(scale)
