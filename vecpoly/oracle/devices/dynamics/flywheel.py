"""Exact flywheels: the difference of the moments integrated from root to root, the energy as its running sum."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import numpy.typing as npt

from ....devices.dynamics import asked
from ....devices.dynamics.curve import Curve
from ....devices.dynamics.flywheel import GRAVITY, Flywheel
from ....devices.dynamics.given import Areas, Torques
from ....devices.dynamics.rim import Rim
from ....mechanism.machine import flywheel_of
from ..registry import Values, answers

Reals = npt.NDArray[np.float64]
TINY = 1e-12  # of the largest difference of the moments: it is zero


@answers(Flywheel)
def flywheel(wheel: Flywheel) -> Values:
    """Everything that may be asked."""
    load = wheel.load
    found, works = _of_curves(load, wheel.speed) if isinstance(load, Torques) else ({}, _of_areas(load))
    energy = np.concatenate([[0.0], np.cumsum(works)])
    for n, value in enumerate(works, 1):
        found[asked.work(n).key] = float(value)
    for n, value in enumerate(energy[1:-1], 1):
        found[asked.level(n).key] = float(value)
    swing = float(np.ptp(energy))
    if isinstance(load, Torques):
        places = [0.0, *(found[asked.place(n).key] for n in range(1, len(works))), 0.0]
        rounded = np.round(energy / (swing or 1.0), 9)
        found[asked.PHI_MAX.key] = places[int(np.argmax(rounded))]
        found[asked.PHI_MIN.key] = places[int(np.argmin(rounded))]
    return found | {asked.DW.key: swing} | _inertia(wheel, swing)


def _inertia(wheel: Flywheel, swing: float) -> dict[str, complex | float]:
    """J_F, δ and the extreme speeds from the energies ½ J ω² there."""
    has = wheel.J.si if wheel.J else 0.0
    found: dict[str, complex | float] = {}
    whole = has
    if wheel.delta is not None:
        need = flywheel_of(swing, wheel.speed, wheel.delta.si)
        flywheel = max(need - has, 0.0)
        whole = has + flywheel
        found |= {asked.J_NEED.key: need, asked.J_F.key: flywheel, asked.GD2.key: 4 * GRAVITY * flywheel}
        if wheel.shaft is not None:
            found[asked.J_SHAFT.key] = flywheel * (wheel.speed / wheel.shaft.si) ** 2
        if wheel.rim is not None:
            found |= _rim(wheel.rim, flywheel, wheel.speed)
    delta = swing / (whole * wheel.speed**2)
    high, low = wheel.speed * (1 + delta / 2), wheel.speed * (1 - delta / 2)
    turns = 30 / pi
    return found | {
        asked.DELTA.key: delta,
        asked.OMEGA_MAX.key: high,
        asked.OMEGA_MIN.key: low,
        asked.N_MAX.key: high * turns,
        asked.N_MIN.key: low * turns,
    }


def _rim(rim: Rim, inertia: float, speed: float) -> dict[str, complex | float]:
    """Of an annulus whose mass, thought on its middle, has this moment of inertia."""
    mass = inertia / (rim.D.si / 2) ** 2
    high = sqrt(mass / (rim.density.si * pi * rim.D.si) / rim.ratio.si)
    inner, outer = rim.D.si / 2 - high / 2, rim.D.si / 2 + high / 2
    found: dict[str, complex | float] = {
        asked.RIM_MASS.key: mass,
        asked.RIM_H.key: high,
        asked.RIM_B.key: high * rim.ratio.si,
        asked.RIM_SPEED.key: speed * outer,
        asked.RIM_J.key: mass * (inner**2 + outer**2) / 2,
    }
    if rim.v_max is not None:
        found[asked.RIM_SAFE.key] = float(speed * outer <= rim.v_max.si)
    return found


def _of_areas(load: Areas) -> Reals:
    """The works, without what they miss zero by: each gives in proportion to its size."""
    sizes = np.array(load.sizes)
    return np.asarray(load.scale * (sizes - np.sum(sizes) * np.abs(sizes) / np.sum(np.abs(sizes))), dtype=float)


def _of_curves(load: Torques, speed: float) -> tuple[dict[str, complex | float], Reals]:
    """The constant moment as a mean value, the places where the moments are equal, the works between."""
    found: dict[str, complex | float] = {}
    driving, resisting = _corners(load.driving, load.period), _corners(load.resisting, load.period)
    if load.sought:
        phi, moment = resisting if load.sought == "d" else driving
        mean = float(np.trapezoid(moment, phi)) / load.period
        flat = np.array([0.0, load.period]), np.array([mean, mean])
        driving, resisting = (flat, resisting) if load.sought == "d" else (driving, flat)
        found = {(asked.M_D if load.sought == "d" else asked.M_R).key: mean, asked.POWER.key: mean * speed / 1e3}
    a, b, first, last = _strips(driving, resisting)
    works, places = _split(a, b, first, last)
    return found | {asked.place(n).key: float(np.degrees(at)) for n, at in enumerate(places, 1)}, works


def _corners(curve: Curve, period: float) -> tuple[Reals, Reals]:
    phi, moment = np.array(curve.over(period)).T
    return phi, moment


def _strips(one: tuple[Reals, Reals], other: tuple[Reals, Reals]) -> tuple[Reals, Reals, Reals, Reals]:
    """Where both are straight: from, to, and the difference behind `from` and before `to`."""
    places = np.unique(np.concatenate([one[0], other[0]]))
    places = places[np.r_[True, np.diff(places) > 1e-12]]
    a, b = places[:-1], places[1:]
    third, two_thirds = a + (b - a) / 3, a + 2 * (b - a) / 3
    u, v = (np.interp(at, *one) - np.interp(at, *other) for at in (third, two_thirds))
    return a, b, 2 * u - v, 2 * v - u


def _split(a: Reals, b: Reals, first: Reals, last: Reals) -> tuple[Reals, list[float]]:
    """Cut at every root, where they touch, and at the beginning of a stretch on which they are equal."""
    zero = TINY * float(max(np.max(np.abs(first)), np.max(np.abs(last))))
    works, places, sign, equal = [0.0], [], 0, None
    for start, end, u, v in zip(*(part.tolist() for part in (a, b, first, last)), strict=True):
        u, v = (0.0 if abs(value) <= 1e3 * zero else value for value in (u, v))
        if u * v < 0:
            root = start + (end - start) * u / (u - v)
            pieces = [(start, root, u, 0.0), (root, end, 0.0, v)]
        else:
            pieces = [(start, end, u, v)]
        for low, high, left, right in pieces:
            now = int(np.sign(left or right))
            if left == 0 and sign and equal is None:
                equal = low
            if now and sign and (now != sign or equal is not None):
                places.append(low if equal is None else equal)
                works.append(0.0)
            if now:
                sign, equal = now, (high if right == 0 else None)
            works[-1] += (high - low) * (left + right) / 2
    return np.array(works), places
