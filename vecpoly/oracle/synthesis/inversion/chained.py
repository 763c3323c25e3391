"""Whether a slider that hangs on the rocker of a four-bar lets its crank through the positions: loop by loop each of
them may close in all positions, and the whole yet stop between them."""

from __future__ import annotations

from cmath import phase
from collections.abc import Sequence
from itertools import pairwise
from math import tau

import numpy as np

PLACES = 4001  # of the crank from one position to the next
SLACK = 1e-9  # of the squares of lengths


def stopped(
    four: tuple[Sequence[complex], Sequence[complex], complex, complex], along: complex, e: Sequence[complex]
) -> bool:
    """Whether on either way of the crank AB from position to position C leads the slider E beyond its reach.

    four: B and C in the positions, A and D.
    """
    b, c, a, d = four
    return not any(_passes((b, c, a, d), along, e, sense) for sense in (1, -1))


def _passes(
    four: tuple[Sequence[complex], Sequence[complex], complex, complex],
    along: complex,
    e: Sequence[complex],
    sense: int,
) -> bool:
    b, c, a, d = four
    rod, rocker, reach = abs(c[0] - b[0]), abs(c[0] - d), abs(e[0] - c[0])
    across = [((d - at).conjugate() * (pin - at)).imag for at, pin in zip(b, c, strict=True)]
    side = 1 if max(across, key=abs) > 0 else -1
    for one, two in pairwise(b):
        turned = (sense * phase((two - a) / (one - a))) % tau
        at = a + (one - a) * np.exp(1j * sense * turned * np.linspace(0.0, 1.0, PLACES))
        base = np.abs(d - at)
        ahead = (rod**2 - rocker**2 + base**2) / (2 * base)
        rest = rod**2 - ahead**2
        if rest.min() < -SLACK * rod**2:
            return False
        pin = at + (d - at) / base * (ahead + 1j * side * np.sqrt(np.maximum(rest, 0.0)))
        if np.abs(((pin - e[0]) / along).imag).max() ** 2 > reach**2 * (1 + SLACK):
            return False
    return True
