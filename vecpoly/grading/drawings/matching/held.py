"""How a sheet, or one of its polygons, is held before it is compared: upright, turned, or in a mirror."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....foundation.slotted import replace
from ..segment import Segment


@dataclass(frozen=True, slots=True, kw_only=True)
class Held:
    """The sheet turned by a factor of size 1; mirror: left for right first."""

    turn: complex = 1 + 0j
    mirror: bool = False

    def seen(self, one: Segment) -> Segment:
        """The line as it is seen then."""
        return replace(one, start=self._at(one.start), end=self._at(one.end))

    def drawn(self, along: complex) -> complex:
        """A vector that is seen so as it was drawn."""
        back = along / self.turn
        return -back.conjugate() if self.mirror else back

    def _at(self, at: complex) -> complex:
        return self.turn * (-at.conjugate() if self.mirror else at)

    @property
    def degrees(self) -> float:
        """By how much the sheet had been turned before it was held so (ccw)."""
        turned = round(float(np.degrees(np.angle(1 / self.turn))), 6)
        return 180.0 if turned == -180.0 else turned


def one_turn(one: Held, other: Held) -> bool:
    """Whether two ways to hold something are the same, as far as can be told."""
    return one.mirror is other.mirror and abs(np.angle(one.turn / other.turn)) < SAME


UPRIGHT = Held()
SAME = np.radians(0.5)
MIRRORED = (Held(mirror=True), Held(mirror=True, turn=-1 + 0j))
QUARTERS = tuple(Held(turn=turn) for turn in (1j, -1j, -1 + 0j))
