"""A crank-rocker in its limit positions: lengths, angles, and whether the rocker can swing from one to the other."""

from __future__ import annotations

from cmath import phase
from math import degrees, inf, nan, pi
from typing import Any

import numpy as np

from ...designs.verdict import Verdict
from .registry import Linkage

NEAR = 1e-9  # of the rocker: a point on a line


def least_angle(a: float, b: float, c: float, d: float) -> float:
    """γ_min (rad) of a crank-rocker a, b, c, d: its crank lies on the line of the frame.

    tan² (μ/2) = (s² − (b − c)²) / ((b + c)² − s²), s = |d ∓ a|; γ = min(μ, π − μ).
    """
    return float(np.minimum(*extreme_angles(a, b, c, d))) if b * c else nan


def extreme_angles(a: Any, b: Any, c: Any, d: Any) -> tuple[Any, Any]:
    """γ (rad) with the crank on the line of the frame: along it, and the other way; of one linkage or of many."""
    near, far = (_opposite(side, b, c) for side in (d - a, d + a))
    return np.minimum(near, pi - near), np.minimum(far, pi - far)


def _opposite(side: Any, b: Any, c: Any) -> Any:
    """The angle opposite a side of a triangle by the tangent of its half: a cosine of nearly 1 has no digits left."""
    low, high = (side - b + c) * (side + b - c), (b + c - side) * (b + c + side)
    return 2 * np.arctan2(np.sqrt(np.maximum(low, 0.0)), np.sqrt(np.maximum(high, 0.0)))


def useful(a_pin: Any, d_pin: complex, c1: complex, c2: complex) -> Any:
    """Whether the linkage with this A is valid, or which of those with A in many places are."""
    one, other, c = abs(c1 - a_pin), abs(c2 - a_pin), abs(c1 - d_pin)
    return ~((np.minimum(one, other) < NEAR * c) | _even(one, other, c) | _across(a_pin, d_pin, c1, c2))


def useful_angles(a_pin: Any, d_pin: complex, c1: complex, c2: complex) -> tuple[Any, Any]:
    """The extreme angles of the linkages with A in many places; NaN where one is not valid."""
    one, other, c = abs(c1 - a_pin), abs(c2 - a_pin), abs(c1 - d_pin)
    use = useful(a_pin, d_pin, c1, c2)
    both = extreme_angles(abs(other - one) / 2, (one + other) / 2, c, abs(d_pin - a_pin))
    return np.where(use, both[0], nan), np.where(use, both[1], nan)


def found(a_pin: complex, d_pin: complex, c1: complex, c2: complex, verdict: Verdict | None = None) -> Linkage:
    """The linkage with the fixed pins A, D whose rocker has these limits (m); its verdict as the limits tell it."""
    near, far = sorted((abs(c1 - a_pin), abs(c2 - a_pin)))
    a, b, c, d = (far - near) / 2, (far + near) / 2, abs(c1 - d_pin), abs(d_pin - a_pin)
    if near < NEAR * c:  # no angle is seen from there
        seen, verdict = nan, Verdict.AT_LIMIT
    else:
        seen = abs(phase((c2 - a_pin) / (c1 - a_pin)))
        verdict = verdict or judged(a_pin, d_pin, c1, c2)
    values = {
        "theta": degrees(seen),
        "AB": 1e3 * a,
        "BC": 1e3 * b,
        "CD": 1e3 * c,
        "AD": 1e3 * d,
        "psi": degrees(abs(phase((c2 - d_pin) / (c1 - d_pin)))),
        "gamma_min": degrees(least_angle(a, b, c, d)),
        "K": inf if seen >= pi else (pi + seen) / (pi - seen),
    }
    pins = {"A": a_pin, "D": d_pin, "C1": c1, "C2": c2}
    return Linkage(values=values, pins=pins, verdict=verdict, order=(a, b, d, a_pin.real))


def judged(a_pin: complex, d_pin: complex, c1: complex, c2: complex) -> Verdict:
    """The verdict on limit positions that are seen from A under θ."""
    if _even(abs(c1 - a_pin), abs(c2 - a_pin), abs(c1 - d_pin)):
        return Verdict.NO_CRANK
    return Verdict.OPPOSITE if _across(a_pin, d_pin, c1, c2) else Verdict.VALID


def _even(one: Any, other: Any, size: float) -> Any:
    """Whether A is as far from one limit as from the other."""
    return abs(one - other) < NEAR * size


def _across(a_pin: Any, d_pin: complex, c1: complex, c2: complex) -> Any:
    """Whether the limits lie on either side of AD, or one of them in its line."""
    frame = d_pin - a_pin
    one, other = ((np.conj(frame) * (c - a_pin)).imag for c in (c1, c2))
    return (one * other <= 0) | (np.minimum(abs(one), abs(other)) < NEAR * abs(frame) * abs(c1 - d_pin))
