"""True motion: J_e α + ½ J_e′ ω² = M_e by `solve_ivp`, in segments between the corners of the loads.

Three events end a segment: a corner (a load begins or ends), standstill, and a place that is asked for. At standstill
the machine turns back, or stalls: what only resists drives nothing back.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ...errors import EquilibriumError
from ...foundation.frozen import FrozenMap
from ...foundation.slotted import replace
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...words import Words
from ..forces.laws.corners import corners
from ..forces.laws.drives import drive_range
from ..forces.laws.returning import turns_of
from ..state import Reals
from .reduced import Reduced, reduce
from .tables import Tables, tables

RTOL, ATOL = 1e-11, 1e-12
STILL = 1e-7  # rad/s: the speed with which a machine leaves a standstill, so that friction and windows have a sense
MOST = 400  # segments between corners, standstills and stations
NOTHING = 1e-9  # of the greatest moment: it is in balance
State = NDArray[np.float64]


class Outcome(StrEnum):
    """How a motion ended: it got there, it stands still for good, it came back to where it had turned before."""

    REACHED = "reached"
    STALLED = "stalled"
    OSCILLATES = "oscillates"


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Leg:
    """One segment: times (s), positions φ (rad), speeds (rad/s), in order of time."""

    t: Reals
    phi: Reals
    omega: Reals
    peaks: Reals = field(default_factory=lambda: np.empty((0, 2)))  # φ, ω where α is 0


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Moved:
    """A motion: its segments, how it ended, where it turned back (t, φ), when it first passed stations (way → t, ω)."""

    legs: tuple[Leg, ...]
    outcome: Outcome
    turned: tuple[tuple[float, float], ...] = ()
    passed: Mapping[float, tuple[float, float]] = FrozenMap({})

    @property
    def end(self) -> tuple[float, float, float]:
        """Time, position and speed at the end."""
        last = self.legs[-1]
        return float(last.t[-1]), float(last.phi[-1]), float(last.omega[-1])

    @property
    def period(self) -> float:
        """Of an oscillation (s): between two turning points on the same side; NaN of any other motion."""
        return self.turned[2][0] - self.turned[0][0] if len(self.turned) > 2 else float("nan")

    @property
    def extremes(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Where it is fastest and slowest by |ω|, and how fast (φ, ω): where α is 0, or at an end of a segment."""
        ends = [(leg.phi[i], leg.omega[i]) for leg in self.legs for i in (0, -1)]
        spots = np.array([*ends, *(spot for leg in self.legs for spot in leg.peaks)], np.float64)
        sizes = np.abs(spots[:, 1])
        top, low = spots[int(np.argmax(sizes))], spots[int(np.argmin(sizes))]
        return (float(top[0]), float(top[1])), (float(low[0]), float(low[1]))


@dataclass(eq=False)
class Mover:
    """The machine at a state; every reduction is one exact solution of the mechanism."""

    mech: Mechanism
    loads: Loads
    flywheel: float = 0.0
    corner: Reals = field(init=False)
    _tables: dict[float, Tables] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.corner = corners(self.mech, self.loads)

    @cached_property
    def range(self) -> tuple[float, float, bool]:
        """How far the drive goes."""
        return drive_range(self.mech)

    @cached_property
    def period(self) -> float:
        """After which way of the drive all is as it was (rad); ∞ where it does not turn right round."""
        low, _, whole = self.range
        return 2 * np.pi * turns_of(self.mech, self.loads, low) if whole else np.inf

    def reduced(self, phi: float, omega: float) -> Reduced:
        """The equivalent link at this state."""
        rate = omega if omega else STILL
        moving = replace(self.mech, drives=(replace(self.mech.drive, rate=rate, accel=0.0), *self.mech.drives[1:]))
        return reduce(moving, self.loads, np.array([phi]))

    def tables(self, sense: float) -> Tables:
        """What the equivalent link has over a whole period, for this sense of motion."""
        if sense not in self._tables:
            self._tables[sense] = tables(self.mech, self.loads, sense)
        return self._tables[sense]

    def acceleration(self, phi: float, omega: float) -> float:
        """α = (M_e − ½ J_e′ ω²) / J_e; by tables where the drive goes right round."""
        if self.range[2]:
            moment, inertia, slope = self.tables(float(np.sign(omega)) or 1.0).at(phi, omega)
            return (moment - slope * omega**2 / 2) / (inertia + self.flywheel)
        found = self.reduced(phi, omega)
        inertia = float(found.energy[0]) + self.flywheel
        return float((found.power[0] - found.rate[0] * omega**2 / 2) / inertia)

    def free(self, phi: float, sense: float) -> float:
        """M_e at rest of all that does not only resist, were the machine to move this way (N·m)."""
        active = replace(
            self.loads,
            forces=tuple(one for one in self.loads.forces if one.role != "resisting"),
            moments=tuple(one for one in self.loads.moments if one.role != "resisting"),
        )
        moving = replace(self.mech, drives=(replace(self.mech.drive, rate=STILL * sense), *self.mech.drives[1:]))
        return float(reduce(moving, active, np.array([phi])).power[0])

    def next_corner(self, phi: float, sense: float) -> float:
        """The next place at which a load jumps, in this sense; ±∞ where there is none."""
        if not len(self.corner):
            return sense * np.inf
        low, _, whole = self.range
        period = self.period
        turns = np.floor((phi - low) / period) if whole else 0.0
        around = np.concatenate([self.corner + (turns + k) * period for k in ((-1, 0, 1) if whole else (0,))])
        ahead = around[sense * (around - phi) > 1e-9]
        return float(sense * np.min(sense * ahead)) if len(ahead) else sense * np.inf


def refuse_massless(mover: Mover, phi: float) -> None:
    """EquilibriumError where the machine has no inertia at all."""
    if float(mover.reduced(phi, 1.0).energy[0]) + mover.flywheel <= 0:
        raise EquilibriumError(
            Words(
                "机器没有质量，等效转动惯量为零，角加速度无穷大；请在 masses 中给出质量",
                "the machine has no mass: its equivalent inertia is 0 and its acceleration without bound; give masses",
            ),
            code="massless",
        )
