"""What the acts of a sheet have given so far, by every hand: each thing in one place, looked up under its key.

Acts write here, each when it is done, and nobody else does.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from ..algebra.quantity import Quantity
from ..names import At
from ..plane import Points, Reals
from .construction import Reading
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

    spots: points by their letters; points: by what they are the point of (`Locate`: two may have one letter, k′ of K
    and of a Coriolis acceleration). vectors: as they stand (`Arrow`, and what is gone along), the last one where one
    was drawn again. sizes: computed, or given (`Compute`); laid: the vectors laid off (`LayOff`), each with the size
    that was computed before, if one was. readings: answers as they are read (`Answer`); found: the same by every hand.
    """

    spots: dict[tuple[Place, str], Points] = field(default_factory=dict)
    points: dict[tuple[Place, At], Points] = field(default_factory=dict)
    vectors: dict[tuple[Place, str], Stood] = field(default_factory=dict)
    sizes: dict[str, Quantity] = field(default_factory=dict)
    laid: dict[tuple[Place | None, str], Quantity | None] = field(default_factory=dict)
    readings: dict[str, Reading] = field(default_factory=dict)
    found: dict[str, Reals] = field(default_factory=dict)

    def below(self) -> Ledger:
        """For scratch paper laid over the sheet: what stands there is seen, and what is done above changes nothing."""
        return Ledger(
            spots=dict(self.spots),
            points=dict(self.points),
            vectors=dict(self.vectors),
            sizes=dict(self.sizes),
            laid=dict(self.laid),
        )

    def vector(self, place: Place, key: str) -> Stood | None:
        """Where a vector stands on a figure."""
        return self.vectors.get((place, key))

    def laid_off(self, place: Place, key: str) -> Quantity | None:
        """The size of a vector that was computed, or given, and then laid off; None of one that is read."""
        return self.laid.get((place, key))
