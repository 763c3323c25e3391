"""Equilibrium of all links at once, with Coulomb friction: reactions, balancing load, powers."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...mechanism.quantities import quantities
from ...names import Named
from ..motion import Motion
from ..run import Run
from ..state import Bodies, Points, Reals
from .acting import checked, given, sought, unit_drive
from .pairs import pairs_of
from .refusal import Judge
from .system import ROUNDING, Balance, System

_Number = TypeVar("_Number", np.complex128, np.float64)


@dataclass(frozen=True, eq=False)
class Forces:
    """A solved equilibrium. Every answer has the shape of the positions asked for (a number for one position)."""

    mech: Mechanism
    loads: Loads
    motion: Motion
    rates: Bodies  # the links' velocities (virtual ones where the drive rests)
    system: System
    dry: Balance  # without friction
    wet: Balance  # with it
    causes: NDArray[np.int8]  # `causes.Cause` by position: why there is no answer

    def value(self, key: str) -> Points | Reals:
        """The quantity with this key (`mechanism.quantities`): N, N·m or m, complex for a vector.

        Raises UnknownNameError for a key that this mechanism does not have.
        """
        from .answers import value
        return value(self, key)

    def line(self, by: str, on: str) -> Points:
        """A point of the line of action (m) of the force of link `by` on link `on`, by printed numbers.

        On a pin's friction circle, on the guide's line, at the point of contact; NaN where there is no force.
        Raises UnknownNameError for links that do not touch.
        """
        return self.line_of(f"R_{by}{on}")

    def line_of(self, key: str) -> Points:
        """The same by the reaction's key, which two pins of one link in slots of another need: R_24B."""
        from .answers import line
        return line(self, key)

    def couple_of(self, key: str) -> Reals:
        """The couple (N·m, counter-clockwise) beside this reaction where two links slide and pass on no force; 0 elsewhere."""
        from .answers import couple
        return couple(self, key)

    @cached_property
    def named(self) -> dict[str, Named]:
        """The quantities that `value` knows."""
        return quantities(self.mech, self.loads)

    @cached_property
    def powers(self) -> tuple[Reals, ...]:
        """Powers of the known loads, weights and inertia forces, the balancing load last (W)."""
        one = np.ones(self.system.count)
        known = (one * act.power(self.motion.bodies) for act in self.system.known)
        return (*known, self.wet.load * self.system.free.power(self.motion.bodies))

    @property
    def power_in(self) -> Reals:
        """Sum of the powers that drive (W)."""
        return self.shaped(np.sum([np.maximum(power, 0.0) for power in self._working], axis=0))

    @property
    def power_out(self) -> Reals:
        """Sum of the powers that resist (W), positive."""
        return self.shaped(np.sum([np.maximum(-power, 0.0) for power in self._working], axis=0))

    @property
    def _working(self) -> list[Reals]:
        """The powers, 0 where one is nothing but rounding."""
        speeds = [np.abs(body.velocity) + np.abs(body.omega) * self.system.scale for body in self.motion.bodies.values()]
        least = ROUNDING * self.wet.largest * np.max(np.broadcast_arrays(*speeds), axis=0)
        return [np.where(np.abs(power) <= least, 0.0, power) for power in self.powers]

    @property
    def loss(self) -> Reals:
        """Σ ρ R |ω| + Σ tan φ N |v| over the joints (W)."""
        moving = self.mech.drive.rate != 0.0
        losses = [pair.grip * np.abs(pair.rate) * size for pair, size in zip(self.system.pairs, self.wet.rubs, strict=True)
                  if pair.rate is not None and moving]
        return self.shaped(np.sum([np.zeros(self.system.count), *losses], axis=0))

    def shaped(self, values: NDArray[_Number]) -> NDArray[_Number]:
        """As the positions were asked for: one element for one position."""
        shaped: NDArray[_Number] = np.broadcast_to(values, (self.system.count,)).reshape(self.motion.shape)
        return shaped if self.motion.shape else shaped[()]


def forces(mech: Mechanism, loads: Loads, position: ArrayLike | None = None, *, strict: bool = True) -> Forces:
    """Reactions, balancing load and efficiency at one or many positions of the drive.

    Σ F - m a = 0 and Σ M - J α = 0 for every moving link. position: as in `oracle.solve`.
    strict: the first position that fails raises NoSlipSenseError (friction at rest), LockedError, or EquilibriumError
    (an unknown that does no work, links that part); else such positions give NaN. Also raises the errors of `oracle.solve`.
    """
    from .. import solve
    checked(mech, loads)
    motion = solve(mech, position, order=2 if loads.dynamic else 1, strict=strict)
    moving = mech.drive.rate != 0.0
    rates = motion.bodies if moving else solve(unit_drive(mech), position, order=1, strict=strict).bodies
    asked = np.atleast_1d(np.asarray(mech.drive.position if position is None else position, dtype=np.float64))
    judge = Judge(Run(asked, strict, "mm" if mech.drive.slide else "deg"))
    system = System(tuple(name for name in mech.bodies if name not in mech.slot_pins), motion.bodies, pairs_of(mech, motion.bodies, rates, loads.friction),
                    given(mech, loads, motion.bodies), sought(mech, loads, motion.bodies), mech.scale, asked.size)
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        judge.idle(system, rates)
        skip = judge.lost.copy()
        judge.senseless(system, rates, moving)
        dry, wet, reached = system.solve(skip)
        judge.unsolved(dry)
        judge.locked(system, (dry, wet), reached, loads.dynamic, rates)
        judge.parting(system, wet)
    return Forces(mech, loads, motion, rates, system, dry, wet.without(judge.lost), judge.causes)
