"""Which two trial cranks serve: a rough reckoning on the side, one a little too short, the other a little too long."""

from __future__ import annotations

from cmath import exp

import numpy as np

from ....designs.generator.refusals import checked, unbounded

SHORT, LONG, DIGITS = 0.8, 1.25, 2  # of the crank that is looked for; figures of a length that somebody tries
FLAT = 1e-12
WEAK = 0.1  # of the best: the first position is kept unless it tells the others apart worse than so
Angles = tuple[tuple[float, float], ...]


def kept_position(pairs: Angles) -> int:
    """The position of the output link that is kept when the figures are turned back: the first, where that is possible.

    Crank pins equally far from D in two positions ask for a C in D whatever the crank is, as seen from either.
    """
    telling = [min(abs(np.cos(one) - np.cos(phi)) for phi, _ in pairs if phi != one) for one, _ in pairs]
    return 0 if telling[0] >= WEAK * max(telling) else int(np.argmax(telling))


def others(kept: int) -> tuple[int, int]:
    """The two positions that are turned back upon the one that is kept."""
    one, two = (n for n in range(3) if n != kept)
    return one, two


def trial_cranks(pairs: Angles, kept: int) -> tuple[float, float]:
    """Their lengths (in frames), negative on the lines produced backwards; raises AssemblyError where none is right.

    1/DP and 1/DQ are linear in 1/AE, and equal for the crank that is looked for.
    """
    (p0, p1), (q0, q1) = (_reciprocal(pairs[kept], pairs[n]) for n in others(kept))
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
