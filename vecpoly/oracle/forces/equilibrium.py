"""Equilibrium of all links at once, by Newton with continuation in f (being written)."""

from __future__ import annotations

from dataclasses import dataclass

from numpy.typing import ArrayLike

from ...errors import NoMethodError
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ..state import Points, Reals


@dataclass(frozen=True, slots=True, eq=False)
class Forces:
    """A solved equilibrium. Every answer has the shape of the positions asked for."""

    mech: Mechanism
    loads: Loads

    def value(self, key: str) -> Points | Reals:
        """The quantity with this key (`mechanism.quantities`): complex for a vector."""
        raise NoMethodError("the oracle of forces is being written")

    def line(self, by: str, on: str) -> Points:
        """A point of the line of action (m) of the force of link `by` on link `on`, by printed numbers."""
        raise NoMethodError("the oracle of forces is being written")


def forces(mech: Mechanism, loads: Loads, position: ArrayLike | None = None, *, strict: bool = True) -> Forces:
    """Reactions, balancing load and efficiency at one or many positions of the drive."""
    return Forces(mech, loads)
