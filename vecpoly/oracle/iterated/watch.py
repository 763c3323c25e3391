"""Which positions of an iteration go on: not those that have arrived, nor those that get no nearer."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ..state import Reals

ARRIVED = 1e-13  # m and rad: a step below it is none
CLOSED = 1e-14  # of the mechanism's size: gaps below it are rounding
OPEN = 1e-12  # of that size: gaps from here on are no assembly
PATIENCE = 8  # iterations without a smaller gap: then the solution is lost


@dataclass(slots=True)
class Watch:
    """How near every position has come. size: of the mechanism (m); patience: iterations without a smaller gap."""

    count: int
    size: float
    patience: int = PATIENCE
    gap: Reals = field(init=False)  # the last one (m)
    _least: Reals = field(init=False)
    _step: Reals = field(init=False)
    _idle: Reals = field(init=False)

    def __post_init__(self) -> None:
        self.gap, self._least, self._step = np.full((3, self.count), np.inf)
        self._idle = np.zeros(self.count)

    def goes_on(self, at: NDArray[np.intp], gap: Reals, step: Reals) -> NDArray[np.bool_]:
        """For these positions: their largest gap (m), and the step (m, rad) that it led to."""
        stuck = (gap < CLOSED * self.size) & (step > 0.9 * self._step[at])  # rounding alone moves it
        self._idle[at] = np.where(gap < self._least[at], 0, self._idle[at] + 1)
        self._least[at] = np.minimum(gap, self._least[at])
        self.gap[at], self._step[at] = gap, step
        moved = (step >= ARRIVED * max(self.size, 1.0)) | (gap >= OPEN * self.size)  # the gap is that before the step
        more: NDArray[np.bool_] = moved & ~stuck & (self._idle[at] < self.patience)
        return more

    @property
    def lost(self) -> NDArray[np.bool_]:
        """Where the loops stay open."""
        return ~(self.gap < OPEN * self.size)
