"""A mechanism as a machine: what acts on it, all of known size, and how fast and how evenly it is to run.

SI; angles in rad; counter-clockwise positive.
"""

from __future__ import annotations

from ..foundation.slotted import dataclass, replace
from .loads import Loads


@dataclass(frozen=True, slots=True, kw_only=True)
class Steady:
    """Periodic motion: the mean speed ω_m (rad/s, positive) and δ = (ω_max − ω_min) / ω_m, which is allowed (`delta`),
    or follows from a flywheel that is there (`flywheel`, J_F in kg·m²)."""

    speed: float
    delta: float | None = None
    flywheel: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Started:
    """Motion from a state: the drive's position φ_0 (rad) and its ω_0 (rad/s); `turned`: how far it is followed (rad;
    None: until it is steady); `stations`: how far from φ_0 its speed is asked for on the way (rad).
    `flywheel`: J_F (kg·m²)."""

    phi: float
    omega: float
    turned: float | None
    stations: tuple[float, ...] = ()
    flywheel: float = 0.0


Run = Steady | Started


@dataclass(frozen=True, slots=True, kw_only=True)
class Machine:
    """What acts on a mechanism, each load of known size, and its masses; how it runs, where that is given."""

    loads: Loads
    run: Run | None = None

    @property
    def steady(self) -> Steady | None:
        """The mean speed and the unevenness, where these are given."""
        return self.run if isinstance(self.run, Steady) else None

    @property
    def started(self) -> Started | None:
        """The state that it starts from, where one is given."""
        return self.run if isinstance(self.run, Started) else None


def flywheel_of(work: float, speed: float, delta: float) -> float:
    """J_F = W / (δ ω_m²) (kg·m²): what stores this work (J) between ω_max and ω_min, δ ω_m apart about ω_m (rad/s).

    Of ΔW_max where the equivalent inertia is even, of the length cut off by Wittenbauer's tangents where it is not.
    """
    return work / (delta * speed**2)


def known_of(loads: Loads) -> Loads:
    """The loads of known size: one that only balances the others is no part of a machine's work."""
    return replace(
        loads,
        forces=tuple(one for one in loads.forces if one.size is not None),
        moments=tuple(one for one in loads.moments if one.size is not None),
    )
