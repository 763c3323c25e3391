"""The shaking force of a slider-crank: its square is a polynomial in cos φ, whose largest value lies at a root."""

from __future__ import annotations

from cmath import exp
from math import acos, cos, degrees, sqrt

import numpy as np

from ....devices.balancing.shaking import MOST_C, ShakingForce
from ..registry import Values, answers

ROUNDS = 200
GOLD = (sqrt(5) - 1) / 2


@answers(ShakingForce)
def shaking_force(device: ShakingForce) -> Values:
    """Two-term series, force on the frame, x along the cylinder away from the shaft."""
    part = device.BS2.si / device.l.si
    rotating = device.m1.si + device.m2.si * (1 - part)
    moving, ratio = device.m3.si + device.m2.si * part, device.r.si / device.l.si
    first = moving * device.r.si * device.n.si**2
    c = _best(ratio) if device.seeks else device.c.si
    size, at = _largest(c, ratio)
    phi = device.at.si
    force = first * (cos(phi) + ratio * cos(2 * phi) - c * exp(1j * phi))
    return {
        "m_rot": rotating,
        "m_rec": moving,
        "lambda": ratio,
        "F_1": first,
        "F_2": ratio * first,
        "c": c,
        "m_c": (rotating + c * moving) * device.r.si / device.r_c.si,
        "F": force,
        "F_max": first * size,
        "phi_max": degrees(at),
    }


def _largest(c: float, ratio: float) -> tuple[float, float]:
    """Of one unit of F_1 the largest force, and the angle from 0 to π where it is."""
    x = np.polynomial.Polynomial([0.0, 1.0])
    square = ((1 - c) * x + ratio * (2 * x**2 - 1)) ** 2 + c**2 * (1 - x**2)
    roots = (complex(root) for root in square.deriv().roots())
    turns = [root.real for root in roots if abs(root.imag) < 1e-9 and abs(root.real) < 1]
    places = [1.0, *sorted(turns, reverse=True), -1.0]
    at = max(places, key=lambda place: round(float(square(place)), 12))
    return sqrt(max(float(square(place)) for place in places)), acos(at)


def _best(ratio: float) -> float:
    """The largest force is a convex function of c; golden section."""
    low, high = 0.0, MOST_C
    for _ in range(ROUNDS):
        one, other = high - GOLD * (high - low), low + GOLD * (high - low)
        if _largest(one, ratio)[0] <= _largest(other, ratio)[0]:
            high = other
        else:
            low = one
    return (low + high) / 2
