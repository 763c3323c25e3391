"""Which two trial cranks serve: a rough reckoning on the side, one a little too short, the other a little too long."""

from __future__ import annotations

from cmath import exp

import numpy as np

from ....designs.generator.refusals import checked, unbounded

SHORT, LONG, DIGITS = 0.8, 1.25, 2  # of the crank that is looked for; figures of a length that somebody tries
FLAT = 1e-12
Angles = tuple[tuple[float, float], ...]


def trial_cranks(pairs: Angles) -> tuple[float, float]:
    """Their lengths (in frames), negative on the lines produced backwards; raises AssemblyError where none is right.

    1/DP and 1/DQ are linear in 1/AE, and equal for the crank that is looked for.
    """
    (p0, p1), (q0, q1) = (_reciprocal(pairs[0], other) for other in pairs[1:])
    if abs(p1 - q1) < FLAT * (abs(p1) + abs(q1)):
        raise unbounded("AB", 0.0)
    inverse = (q0 - p0) / (p1 - q1)
    crank = checked("AB", 1 / inverse if inverse else float("inf"))
    place = p0 + p1 * inverse
    checked("CD", 1 / place if place else float("inf"))
    return float(f"{SHORT * crank:.{DIGITS}g}"), float(f"{LONG * crank:.{DIGITS}g}")


def _reciprocal(first: tuple[float, float], other: tuple[float, float]) -> tuple[float, float]:
    """1/DP = p + q/AE: the inverted crank pins are E − A turned back about D, in frames."""
    (phi_1, psi_1), (phi, psi) = first, other
    fixed = exp(-1j * psi_1) - exp(-1j * psi)
    along = exp(1j * (phi - psi)) - exp(1j * (phi_1 - psi_1))
    far = np.cos(phi_1) - np.cos(phi)
    if abs(far) < FLAT:
        raise unbounded("CD", 0.0)
    return float(along.real / far), float(fixed.real / far)
