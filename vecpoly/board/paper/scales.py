"""Round scales: 1, 2, 2.5, 3, 4, 5, 6, 8 × 10ⁿ per mm, the smallest with which a figure still fits its place; finer
ones as far as a sheet has room."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from math import floor, log10
from typing import TypeVar

from ...foundation.slotted import dataclass

SERIES = (1.0, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
HALF = 1.5  # 1 : 1.5 of GB/T 14690, for figures that would be too small at 2

Size = tuple[float, float]
Name = TypeVar("Name")


@dataclass(frozen=True, slots=True)
class Sketched:
    """A figure as sketched at a scale: width and height of what grows with the scale, and of what stands round it at
    any scale; how large it need be at most (mm)."""

    scale: float
    size: Size
    around: Size
    enough: float

    def at(self, scale: float) -> Size:
        """Width and height at another scale."""
        grown = self.scale / scale
        return self.size[0] * grown + self.around[0], self.size[1] * grown + self.around[1]


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


def round_scale(scale: float, size: Size, place: Size) -> float:
    """The round scale for a figure that takes `size` (mm) at `scale` and should fill `place` (mm)."""
    needed = max(size[0] / place[0], size[1] / place[1])
    return round_up(scale * needed) if needed > 0 else round_up(scale)


def enlarged(
    figures: Mapping[Name, Sketched],
    scales: Mapping[Name, float],
    fixed: frozenset[Name],
    fit: Callable[[list[Size]], bool],
) -> dict[Name, float]:
    """Finer scales for the figures of one sheet, the smallest first, as long as all fit it together;
    those of `fixed` stay."""
    chosen = dict(scales)
    growing = [name for name in figures if name not in fixed and max(figures[name].size) > 0]
    waiting: set[Name] = set()
    while growing:
        name = min(growing, key=lambda one: max(figures[one].at(chosen[one])))
        trial = chosen | {name: finer(chosen[name])}
        sizes = [figure.at(trial[one]) for one, figure in figures.items()]
        if max(figures[name].at(trial[name])) <= figures[name].enough and fit(sizes):
            chosen, growing = trial, [one for one in figures if one in growing or one in waiting]
            waiting.clear()
        else:
            growing.remove(name)
            waiting.add(name)  # it may find room once another has grown and stands elsewhere
    return chosen
