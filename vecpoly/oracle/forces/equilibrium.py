"""Equilibrium of all links at once, with Coulomb friction: reactions, balancing load, powers."""

from __future__ import annotations

from dataclasses import dataclass, fields

from numpy.typing import ArrayLike

from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ..state import Points, Reals
from .answers import couple, line, value
from .balanced import balanced
from .solved import Equilibrium


@dataclass(frozen=True, eq=False)
class Forces(Equilibrium):
    """A solved equilibrium. Every answer has the shape of the positions asked for (a number for one position)."""

    def value(self, key: str) -> Points | Reals:
        """The quantity with this key (`mechanism.quantities`): N, N·m or m, complex for a vector.

        Raises UnknownNameError for a key that this mechanism does not have.
        """
        return value(self, key)

    def line(self, by: str, on: str) -> Points:
        """A point of the line of action (m) of the force of link `by` on link `on`, by printed numbers.

        On a pin's friction circle, on the guide's line, at the point of contact; NaN where there is no force.
        Raises UnknownNameError for links that do not touch.
        """
        return self.line_of(f"R_{by}{on}")

    def line_of(self, key: str) -> Points:
        """The same by the reaction's key, which two pins of one link in slots of another need: R_24B."""
        return line(self, key)

    def couple_of(self, key: str) -> Reals:
        """The couple (N·m, counter-clockwise) beside this reaction where two links slide and pass on no force;
        0 elsewhere."""
        return couple(self, key)


def forces(mech: Mechanism, loads: Loads, position: ArrayLike | None = None, *, strict: bool = True) -> Forces:
    """Reactions, balancing load and efficiency at one or many positions of the drive.

    Σ F - m a = 0 and Σ M - J α = 0 for every moving link. position: as in `oracle.solve`.
    strict: the first position that fails raises NoSlipSenseError (friction at rest), LockedError, or EquilibriumError
    (an unknown that does no work, links that part); else such positions give NaN. Also raises the errors of
    `oracle.solve`.
    """
    found = balanced(mech, loads, position, strict=strict)
    return Forces(**{one.name: getattr(found, one.name) for one in fields(found)})
