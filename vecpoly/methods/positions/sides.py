"""Which of two meeting points a group takes: as statements say at the given position, elsewhere as it did before."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

Key = tuple[str, ...]  # the letter and the links of a meeting point; guide and block of a swinging guide


@dataclass(slots=True)
class Sides:
    """The choices made on one sheet.

    kept: the choices of a place near by, None where the statements are read. nearest: the choices (other than taken)
    that would have come nearer to where the letters are led.
    """

    kept: Mapping[Key, int] | None = None
    taken: dict[Key, int] = field(default_factory=dict)
    nearest: dict[Key, int] = field(default_factory=dict)

    @property
    def is_kept(self) -> bool:
        """Whether choices are carried on from another place."""
        return self.kept is not None

    def carry(self, key: Key, near: int | None) -> int | None:
        """The choice carried on: that of the place near by, else the nearest; None where neither tells."""
        chosen = (self.kept or {}).get(key, near)
        if chosen is not None:
            self.take(key, chosen)
            if near is not None and near != chosen:
                self.nearest[key] = near
        return chosen

    def take(self, key: Key, chosen: int) -> int:
        """Remember a choice."""
        self.taken[key] = chosen
        return chosen
