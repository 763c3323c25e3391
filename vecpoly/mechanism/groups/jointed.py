"""A mechanism as the key of what follows from its joints and drives alone, whatever its lengths are."""

from __future__ import annotations

from ..model import Mechanism


class Jointed:
    """Equal where the very same joints connect links of the same names, and the drives act between the same of them.

    The mechanism lives as long as something is kept for it, so that no other joint takes the place of one of its own.
    """

    __slots__ = ("_key", "mech")

    def __init__(self, mech: Mechanism) -> None:
        self.mech = mech
        self._key = (
            tuple(map(id, mech.joints)),
            tuple(link.name for link in mech.links),
            tuple((drive.link, drive.on, drive.slide) for drive in mech.drives),
        )

    def __hash__(self) -> int:
        return hash(self._key)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Jointed) and other._key == self._key
