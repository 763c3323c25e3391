"""Equilibrium of all links at once, with Coulomb friction: reactions, balancing load, powers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ..run import Run
from ..state import Points, Reals
from .acting import checked, given, sought
from .answers import couple, line, value
from .flanks import solved
from .laws.drives import unit_drive
from .laws.stands import Stands
from .pairs import pairs_of
from .refusal import Judge
from .solved import Equilibrium
from .system import System


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
    from .. import solve

    checked(mech, loads)
    motion = solve(mech, position, order=2 if loads.dynamic else 1, strict=strict)
    moving = mech.drive.rate != 0.0
    rates = motion.bodies if moving else solve(unit_drive(mech), position, order=1, strict=strict).bodies
    asked = np.atleast_1d(np.asarray(mech.drive.position if position is None else position, dtype=np.float64))
    stands = Stands(mech, motion.bodies, asked)
    judge = Judge(Run(asked, strict, "mm" if mech.drive.slide else "deg"))
    system = System(
        tuple(name for name in mech.bodies if name not in mech.slot_pins),
        motion.bodies,
        pairs_of(mech, motion.bodies, rates, loads.friction),
        given(mech, loads, motion.bodies, asked),
        sought(mech, loads, motion.bodies),
        mech.scale,
        asked.size,
    )
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        judge.idle(system, rates)
        skip = judge.lost.copy()
        judge.senseless(system, rates, moving)
        dry, wet, reached = solved(system, skip)
        judge.unsolved(dry)
        judge.locked(system, (dry, wet), reached, loads.dynamic, rates)
        judge.parting(system, wet)
    return Forces(mech, loads, motion, rates, system, dry, wet.without(judge.lost), judge.causes, stands)
