"""How a sheet is held before its figures are sought: upright, turned by quarters, or in a mirror."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..segment import Segment


@dataclass(frozen=True, slots=True, kw_only=True)
class Held:
    """The sheet turned by a factor of size 1; mirror: left for right first."""

    turn: complex = 1 + 0j
    mirror: bool = False

    def seen(self, one: Segment) -> Segment:
        """The line as it is seen then."""
        return replace(one, start=self._at(one.start), end=self._at(one.end))

    def _at(self, at: complex) -> complex:
        return self.turn * (-at.conjugate() if self.mirror else at)

    @property
    def degrees(self) -> float:
        """By how much the sheet had been turned before it was held so (ccw)."""
        return round(float(np.degrees(np.angle(1 / self.turn))), 6)


UPRIGHT = Held()
MIRRORED = (Held(mirror=True), Held(mirror=True, turn=-1 + 0j))
QUARTERS = tuple(Held(turn=turn) for turn in (1j, -1j, -1 + 0j))
