"""What the acts of a sheet have given so far, by every hand: each thing in one place, looked up under its key.

Acts write here, each when it is done, and nobody else does.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from ..algebra.quantity import Quantity
from ..plane import Points, Reals
from .construction import Reading
from .otherwise.amended import plain_letters
from .place import Place


@dataclass(frozen=True, slots=True)
class Stood:
    """Where a vector stands on its figure (mm)."""

    start: Points
    end: Points

    @property
    def ends(self) -> tuple[Points, Points]:
        """Both ends."""
        return self.start, self.end


@dataclass(slots=True)
class Ledger:
    """Of each kind of act what it gave.

    spots: lettered points (`Locate`); vectors: as they stand (`Arrow`, and what is gone along), the last one where one
    was drawn again; sizes: computed, or given (`Compute`); laid: the vectors that were laid off (`LayOff`); readings:
    answers as they are read (`Answer`), found: the same by every hand.
    """

    spots: dict[tuple[Place, str], Points] = field(default_factory=dict)
    vectors: dict[tuple[Place, str], Stood] = field(default_factory=dict)
    sizes: dict[str, Quantity] = field(default_factory=dict)
    laid: set[tuple[Place | None, str]] = field(default_factory=set)
    readings: dict[str, Reading] = field(default_factory=dict)
    found: dict[str, Reals] = field(default_factory=dict)

    def below(self) -> Ledger:
        """For scratch paper laid over the sheet: what stands there is seen, and what is done above changes nothing."""
        return Ledger(spots=dict(self.spots), vectors=dict(self.vectors), sizes=dict(self.sizes), laid=set(self.laid))

    def spot(self, place: Place, letter: str) -> Points | None:
        """The point with this letter on a figure."""
        return self.spots.get((place, plain_letters(letter)))

    def vector(self, place: Place, key: str) -> Stood | None:
        """Where a vector stands on a figure."""
        return self.vectors.get((place, key))

    def laid_off(self, place: Place, key: str) -> Quantity | None:
        """The size of a vector that was computed, or given, and then laid off; None of one that is read."""
        return self.sizes.get(key) if (place, key) in self.laid else None
