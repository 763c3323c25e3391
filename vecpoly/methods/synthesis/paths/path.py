"""The path of a coupler point on scratch paper, place by place, and equal steps along it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ....designs.straight_line import StraightLine
from ..generator.greatest import place_of_greatest

DENSE = 2000  # trials over the range


class Path:
    """E (m) at a share of the range of AB, or at an array of them, by the law of cosines."""

    def __init__(self, design: StraightLine) -> None:
        self.design = design

    def phi(self, share: Any) -> Any:
        """The angle of AB there (rad)."""
        first, last = (end.si for end in self.design.phi)
        return first + share * (last - first)

    def __call__(self, share: Any) -> Any:
        design = self.design
        b = design.AB.si * np.exp(1j * self.phi(share))
        way = design.AD.si - b
        along = (abs(way) ** 2 + design.BC.si**2 - design.CD.si**2) / (2 * abs(way))
        across = np.sqrt(np.maximum(design.BC.si**2 - along**2, 0.0))  # 0 at a dead point
        c = (along + (1j if design.side == "left" else -1j) * across) * way / abs(way)
        return b + design.E.at / design.BC.si * c

    def seen(self, shares: Sequence[float]) -> list[complex]:
        """E (mm) at these shares of the range."""
        places: list[complex] = (1e3 * self(np.array(shares))).tolist()
        return places

    def furthest(self, way: complex) -> float:
        """The share at which the path lies furthest in this direction."""
        return place_of_greatest(lambda share: (complex(way).conjugate() * self(share)).real)

    def stations(self, steps: int) -> list[float]:
        """The shares of so many equal steps along the path, both ends included.

        Near a dead point E moves as the root of the angle: the trials are dense at both ends.
        """
        shares = (1 - np.cos(np.linspace(0, np.pi, DENSE + 1))) / 2
        gone = np.append(0.0, np.cumsum(np.abs(np.diff(self(shares)))))
        inner = np.interp(gone[-1] * np.arange(1, steps) / steps, gone, shares)
        return [0.0, *map(float, inner), 1.0]
