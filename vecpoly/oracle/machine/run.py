"""A motion followed from a state: segment after segment, until it has got there, stalls, or repeats itself."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ...errors import MissingPackageError
from ...foundation.frozen import FrozenMap
from ...words import Words
from .forward import ATOL, MOST, NOTHING, RTOL, STILL, Leg, Moved, Mover, Outcome, State, refuse_massless

Event = Callable[[float, State], float]
NEAR = 1e-8  # rad: a place is reached
LONG = 1e7  # rad over the slowest speed of interest: a segment that takes longer never ends
BACK = 1e-6  # rad: it turns back where it did before


@dataclass(slots=True)
class _Course:
    """What has been seen of a motion so far."""

    start: float
    ways: tuple[float, ...]
    stations: tuple[float, ...]
    legs: list[Leg] = field(default_factory=list)
    turned: list[tuple[float, float]] = field(default_factory=list)
    passed: dict[float, tuple[float, float]] = field(default_factory=dict)

    def ended(self, outcome: Outcome) -> Moved:
        return Moved(legs=tuple(self.legs), outcome=outcome, turned=tuple(self.turned), passed=FrozenMap(self.passed))

    def goal(self, phi: float, sense: float) -> float:
        """The next place that is asked for."""
        ahead = [sense * way for way in self.ways if sense * (self.start + sense * way - phi) > NEAR]
        return self.start + min(ahead, key=abs)

    def way(self, phi: float) -> float:
        return abs(phi - self.start)


def follow(mover: Mover, phi: float, omega: float, turned: float, stations: tuple[float, ...] = ()) -> Moved:
    """From φ, ω until the drive is `turned` rad away from φ, either way; stations: ways (rad) at which ω is asked.

    Ends earlier where the machine stalls, or where it has swung to and fro once. Raises EquilibriumError.
    """
    refuse_massless(mover, phi)
    seen = _Course(phi, tuple(sorted({*stations, turned})), stations)
    t = 0.0
    if abs(omega) < STILL:
        omega = 0.0
        seen.turned.append((0.0, phi))
    for _ in range(MOST):
        sense = _sense(mover, phi, omega)
        if sense == 0:
            seen.legs += [] if seen.legs else [Leg(t=np.array([t]), phi=np.array([phi]), omega=np.zeros(1))]
            return seen.ended(Outcome.STALLED)
        goal, corner = seen.goal(phi, sense), mover.next_corner(phi, sense)
        leg, still = _leg(mover, (t, phi, omega), min(goal, corner, key=lambda q: sense * q), sense)
        seen.legs.append(leg)
        t, phi, omega = float(leg.t[-1]), float(leg.phi[-1]), 0.0 if still else float(leg.omega[-1])
        if (
            outcome := _seen(seen, t, phi, omega, still=still, there=abs(phi - goal) < NEAR, turned=turned)
        ) is not None:
            return seen.ended(outcome)
    return seen.ended(Outcome.STALLED)


def _seen(
    seen: _Course, t: float, phi: float, omega: float, *, still: bool, there: bool, turned: float
) -> Outcome | None:
    """Note what ended the segment; the outcome where that ends the motion."""
    if still:
        seen.turned.append((t, phi))
        again = len(seen.turned) > 2 and abs(phi - seen.turned[-3][1]) < BACK
        return Outcome.OSCILLATES if again else None
    for way in seen.stations if there else ():
        if abs(seen.way(phi) - way) < NEAR:
            seen.passed.setdefault(way, (t, omega))  # who swings to and fro comes by again
    return Outcome.REACHED if there and abs(seen.way(phi) - turned) < NEAR else None


def _sense(mover: Mover, phi: float, omega: float) -> float:
    """Which way it goes on: as it moves; from rest as it is driven; 0 where nothing drives it, or it is held."""
    if omega:
        return float(np.sign(omega))
    for sense in (1.0, -1.0):
        free = mover.free(phi, sense)
        whole = float(mover.reduced(phi, sense * STILL).power[0])
        scale = max(abs(free), abs(whole), 1e-300)
        if sense * free > NOTHING * scale and sense * whole > NOTHING * scale:
            return sense
    return 0.0


def _solver() -> Callable[..., Any]:
    try:
        from scipy.integrate import solve_ivp
    except ImportError as error:
        raise MissingPackageError(
            Words(
                "求真实运动需要 scipy；请 pip install vecpoly[motion]",
                "a motion from a state needs scipy; pip install vecpoly[motion]",
            )
        ) from error
    return solve_ivp  # type: ignore[no-any-return]


def _leg(mover: Mover, state: tuple[float, float, float], end: float, sense: float) -> tuple[Leg, bool]:
    """One segment by `solve_ivp`; whether it ended at a standstill."""
    solve_ivp = _solver()
    t, phi, omega = state

    def pull(at: State) -> float:
        speed = float(at[1])
        return mover.acceleration(float(at[0]), speed if sense * speed > 0 else sense * STILL)

    def arrived(_: float, at: State) -> float:
        return float(at[0] - end)

    def stands(_: float, at: State) -> float:
        return float(at[1])

    def even(_: float, at: State) -> float:
        return pull(at)

    for event, way in ((arrived, sense), (stands, -sense)):
        event.terminal, event.direction = True, way  # type: ignore[attr-defined]
    found = solve_ivp(
        lambda _, at: [at[1], pull(at)],
        (t, t + LONG),
        [phi, omega],
        method="DOP853",
        rtol=RTOL,
        atol=ATOL,
        events=(arrived, stands, even),
    )
    places, still = found.y[0], bool(len(found.t_events[1]))
    if not still and len(found.t_events[0]):
        places = np.append(places[:-1], end)
    peaks = np.asarray(found.y_events[2], np.float64).reshape(-1, 2)
    return Leg(t=found.t, phi=places, omega=found.y[1], peaks=peaks), still
