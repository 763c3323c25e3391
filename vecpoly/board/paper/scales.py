"""Round scales: 1, 2, 2.5, 3, 4, 5, 6, 8 × 10ⁿ per mm, the smallest with which a figure still fits its place."""

from __future__ import annotations

from collections.abc import Iterable
from math import floor, log10

from ...foundation.slotted import dataclass
from ..place import Place, View

SERIES = (1.0, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
HALF = 1.5  # 1 : 1.5 of GB/T 14690, for figures that would be too small at 2

Size = tuple[float, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class Sketched:
    """A figure as sketched at a scale: its kind and name, width and height (mm) of what grows with the scale, and of
    what stands round it at any scale. of: the kind whose scale it follows, itself where it has a scale of its own;
    none where its size has nothing to do with scales. letters: how many labels it has, which ask for room.
    spare: the white beside lines that are narrower than their title (mm), into which they grow. short: the shortest
    vector that is laid off or read in it (mm); arm: the shortest line that is measured on a mechanism; linked: how
    large the mechanism itself stands in it; 0 where there is none. scaled: whether its lengths mean something."""

    view: View
    name: str = ""
    of: Place | None
    scale: float
    size: Size
    around: Size = (0.0, 0.0)
    letters: int = 0
    spare: float = 0.0
    short: float = 0.0
    arm: float = 0.0
    linked: float = 0.0
    scaled: bool = True

    def at(self, scale: float) -> Size:
        """Width and height at another scale."""
        grown = 1.0 if self.of is None else self.scale / scale
        filled = min(max(self.size[0] * (grown - 1.0), 0.0), self.spare)
        return self.size[0] * grown + self.around[0] - filled, self.size[1] * grown + self.around[1]


def round_up(value: float, series: Iterable[float] = SERIES) -> float:
    """The smallest scale of the series, in rising order, that is not below `value`."""
    power = floor(log10(value))
    step = next(s for s in series if s * 10.0**power >= value * (1 - 1e-9))
    return float(f"{step:g}e{power}")


def finer(scale: float) -> float:
    """The next smaller scale, on which a figure is larger: 2 is followed by 1.5."""
    power = floor(log10(scale * (1 + 1e-9)))
    steps = sorted((*SERIES, HALF, 0.8))
    step = max(s for s in steps if s * 10.0**power < scale * (1 - 1e-9))
    return float(f"{step:g}e{power}")


def coarser(scale: float) -> float:
    """The next larger scale, on which a figure is smaller."""
    power = floor(log10(scale * (1 + 1e-9)))
    step = min(s for s in sorted((*SERIES, HALF)) if s * 10.0**power > scale * (1 + 1e-9))
    return float(f"{step:g}e{power}")


def round_scale(scale: float, size: Size, place: Size) -> float:
    """The round scale for a figure that takes `size` (mm) at `scale` and should fill `place` (mm)."""
    needed = max(size[0] / place[0], size[1] / place[1])
    return round_up(scale * needed) if needed > 0 else round_up(scale)
