"""A solved equilibrium: forces by pair, powers, loss; what the quantities with a key are found from."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from ...mechanism.asked.forces import quantities
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...names import Named
from ..motion import Motion
from ..state import Bodies, Reals
from .laws.stands import Stands
from .system import ROUNDING, Balance, System

_Number = TypeVar("_Number", np.complex128, np.float64)


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """The links' equilibrium, solved.
    Every answer has the shape of the positions asked for (a number for one position)."""

    mech: Mechanism
    loads: Loads
    motion: Motion
    rates: Bodies  # the links' velocities (virtual ones where the drive rests)
    system: System
    dry: Balance  # without friction
    wet: Balance  # with it
    causes: NDArray[np.int8]  # `causes.Cause` by position: why there is no answer
    stands: Stands  # what loads that depend on the motion ask

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
        speeds = [
            np.abs(body.velocity) + np.abs(body.omega) * self.system.scale for body in self.motion.bodies.values()
        ]
        least = ROUNDING * self.wet.largest * np.max(np.broadcast_arrays(*speeds), axis=0)
        return [np.where(np.abs(power) <= least, 0.0, power) for power in self.powers]

    @property
    def loss(self) -> Reals:
        """Σ ρ R |ω| + Σ tan φ N |v| over the joints (W)."""
        moving = self.mech.drive.rate != 0.0
        losses = [
            pair.grip * np.abs(pair.rate) * size
            for pair, size in zip(self.system.pairs, self.wet.rubs, strict=True)
            if pair.rate is not None and moving
        ]
        return self.shaped(np.sum([np.zeros(self.system.count), *losses], axis=0))

    def shaped(self, values: NDArray[_Number]) -> NDArray[_Number]:
        """As the positions were asked for: one element for one position."""
        shaped: NDArray[_Number] = np.broadcast_to(values, (self.system.count,)).reshape(self.motion.shape)
        return shaped if self.motion.shape else shaped[()]
