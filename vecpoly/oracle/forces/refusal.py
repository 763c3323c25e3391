"""Positions at which there is no answer: named, with the reason, in an error; or marked, to become NaN."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ...errors import EquilibriumError, LockedError, NoSlipSenseError
from ..run import Run
from ..state import Bodies, Reals
from .causes import Cause
from .system import ROUNDING, Balance, System

Flags = NDArray[np.bool_]
STILL = 1e-9  # of the mechanism's scale of rates: below it nothing moves


@dataclass(frozen=True, slots=True, eq=False)
class Judge:
    """The positions asked for; `causes` collects why some have no answer, where not strict."""

    run: Run
    causes: NDArray[np.int8] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "causes", np.zeros(self.run.q.shape, np.int8))

    @property
    def lost(self) -> Flags:
        """Positions without an answer."""
        return np.asarray(self.causes != Cause.NONE)

    def bad(self, mask: Flags, cause: Cause | NDArray[np.int_]) -> int | None:
        """The first failing position where strict; None where none fails, or where they are only marked, each with its first cause."""
        if not mask.any():
            return None
        if self.run.strict:
            return self.run.first(mask)
        new = mask & ~self.lost
        self.causes[new] = np.broadcast_to(cause, new.shape)[new]
        return None

    def where(self, index: int) -> str:
        """The drive's position as printed."""
        return f"where the drive stands at {self.run.text(float(self.run.q[index]))}"

    def idle(self, system: System, rates: Bodies) -> None:
        """EquilibriumError where the balancing load does no work."""
        free = system.free
        pace = _pace(system, rates)
        lever = free.power(rates)
        weak = np.abs(lever) <= STILL * (pace if free.force.any() else pace / system.scale)
        if (at := self.bad(np.broadcast_to(weak, self.run.q.shape), Cause.IDLE)) is not None:
            rest = (f"its point of link {free.link} does not move in its direction" if free.force.any()
                    else f"link {free.link} does not turn")
            raise EquilibriumError(
                f"{free.name} cannot balance the other loads {self.where(at)}: {rest} here, so it does no work; "
                f"let another load balance, or choose another position"
            )

    def senseless(self, system: System, rates: Bodies, moving: bool) -> None:
        """NoSlipSenseError where a pair with friction has no relative motion."""
        pace = _pace(system, rates)
        for pair in system.pairs:
            if not pair.rubs or pair.rate is None:
                continue
            still = np.abs(pair.rate) <= STILL * (pace / system.scale if pair.turns else pace) if moving else np.ones(1, bool)
            if (at := self.bad(np.broadcast_to(still, self.run.q.shape), Cause.SENSELESS)) is not None:
                why = f"there is no relative motion {self.where(at)}" if moving else "the drive stands still"
                raise NoSlipSenseError(
                    f"{pair.text}: friction between links {' and '.join(pair.who)} has no sense, for {why}; "
                    f"{'choose another position' if moving else 'give the drive a rate'}, or leave out this friction"
                )

    def unsolved(self, dry: Balance) -> None:
        """EquilibriumError where the equations have no single solution."""
        if (at := self.bad(~np.isfinite(dry.load), Cause.UNSOLVED)) is not None:
            raise EquilibriumError(f"the reactions have no single value {self.where(at)}: a link is held twice, or at a dead point")

    def locked(self, system: System, balances: tuple[Balance, Balance], reached: Reals, inertia: bool, rates: Bodies) -> None:
        """LockedError where the driving loads cannot move the mechanism against its friction."""
        dry, wet = balances
        free, lever = system.free, system.free.power(rates)
        before, after = dry.load * lever, wet.load * lever
        before = np.where(np.abs(before) <= ROUNDING * dry.largest * _pace(system, rates), 0.0, before)
        driven = before < 0
        if (at := self.bad(reached < 1.0, np.where(driven, Cause.LOCKED, Cause.BOUND))) is not None:
            share = float(reached[at])
            needs = f"no {free.name}, however large, moves the mechanism {self.where(at)}"
            if driven[at]:
                needs = f"the driving loads cannot move the mechanism {self.where(at)}, whatever {free.name}"
            raise LockedError(f"locked: {needs}; the friction binds at {100 * share:.3g} % of its size. Reduce the friction, or choose another position")
        if not inertia and (at := self.bad((before < 0) & (after >= 0), Cause.LOCKED)) is not None:
            drives = [(act.name, float(np.broadcast_to(act.power(rates), self.run.q.shape)[at])) for act in system.known]
            names = ", ".join(name for name, power in drives if power > 0) or "the weights and inertia forces"
            raise LockedError(
                f"locked: {names} cannot move the mechanism {self.where(at)}: without friction {free.name} would take "
                f"{-float(before[at]):.4g} W, the friction takes {float((after - before)[at]):.4g} W, so the efficiency would be "
                f"{-float(after[at] / abs(before[at])):.3g}. Reduce the friction, or let {free.name} drive"
            )

    def parting(self, system: System, wet: Balance) -> None:
        """EquilibriumError where a contact would have to pull."""
        largest = np.max([np.abs(size) for units in wet.units for size in units], axis=0)
        for pair, units in zip(system.pairs, wet.units, strict=True):
            if pair.pushes and (at := self.bad(units[0] < -STILL * largest, Cause.PARTING)) is not None:
                raise EquilibriumError(
                    f"links {' and '.join(pair.who)} part at their {pair.text} {self.where(at)}: equilibrium would need a pull of "
                    f"{-float(units[0][at]):.4g} N there, and a contact only presses; change the sense of a load"
                )


def _pace(system: System, rates: Bodies) -> Reals:
    """The mechanism's scale of rates (m/s): the fastest link's."""
    speeds = [np.abs(body.velocity) + np.abs(body.omega) * system.scale for name, body in rates.items() if name in system.names]
    pace: Reals = np.max(np.broadcast_arrays(*speeds), axis=0)
    return pace

