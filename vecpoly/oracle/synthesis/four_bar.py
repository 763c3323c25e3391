"""A crank-rocker in its limit positions: lengths, angles, and whether the rocker can swing from one to the other."""

from __future__ import annotations

from cmath import phase
from math import acos, degrees, inf, nan, pi

from ...designs.verdict import Verdict
from .registry import Linkage

NEAR = 1e-9  # of the rocker: a point on a line


def least_angle(a: float, b: float, c: float, d: float) -> float:
    """γ_min (rad) of a crank-rocker a, b, c, d: its crank lies on the line of the frame.

    cos μ = (b² + c² − (d ∓ a)²) / (2 b c), γ = min(μ, π − μ).
    """
    return min(extreme_angles(a, b, c, d))


def extreme_angles(a: float, b: float, c: float, d: float) -> tuple[float, float]:
    """γ (rad) with the crank on the line of the frame: along it, and the other way; none where a link has no length."""
    if not b * c:
        return nan, nan
    near, far = (acos(max(-1.0, min(1.0, (b * b + c * c - side * side) / (2 * b * c)))) for side in (d - a, d + a))
    return min(near, pi - near), min(far, pi - far)


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
    size = abs(c1 - d_pin)
    if abs(abs(c1 - a_pin) - abs(c2 - a_pin)) < NEAR * size:
        return Verdict.NO_CRANK
    sides = [((d_pin - a_pin).conjugate() * (c - a_pin)).imag for c in (c1, c2)]
    return Verdict.OPPOSITE if sides[0] * sides[1] <= 0 else Verdict.VALID
