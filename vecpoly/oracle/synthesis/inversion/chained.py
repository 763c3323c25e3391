"""Whether what hangs on the rocker of a four-bar, a slider or a further rocker, lets its crank through the positions:
loop by loop each of them may close in all positions, and the whole yet stop between them."""

from __future__ import annotations

from cmath import phase
from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import tau

import numpy as np
from numpy.typing import NDArray

from ....designs.inversion.loops import Hinged, Loop, Sliding

PLACES = 4001  # of the crank from one position to the next
SLACK = 1e-9  # of the squares of lengths
Pins = Mapping[str, Sequence[complex]]
Turns = NDArray[np.complex128]


def stopped(chain: Sequence[Loop], pins: Pins) -> bool:
    """Whether on either way of the crank from position to position one of the loops opens; chain: each hangs on the
    rocker of the one before."""
    return not any(_passes(chain, pins, sense) for sense in (1, -1))


def _passes(chain: Sequence[Loop], pins: Pins, sense: int) -> bool:
    a, b = pins[chain[0].a][0], pins[chain[0].b]
    for n, (one, two) in enumerate(pairwise(b)):
        angle = (sense * phase((two - a) / (one - a))) % tau
        turned: Turns | None = np.exp(1j * sense * angle * np.linspace(0.0, 1.0, PLACES))
        for loop in chain:
            if turned is not None:
                turned = _led(loop, pins, n, turned)
        if turned is None:
            return False
    return True


def _led(loop: Loop, pins: Pins, n: int, turned: Turns) -> Turns | None:
    """How far the last link has turned from position n while the first has turned so far (unit vectors); None where the
    loop does not close all the way."""
    a, b, c = pins[loop.a][0], pins[loop.b], pins[loop.c]
    at, rod = a + (b[n] - a) * turned, abs(c[0] - b[0])
    match loop:
        case Sliding():
            return turned if np.abs(((at - c[0]) / loop.along).imag).max() ** 2 <= rod**2 * (1 + SLACK) else None
        case Hinged():
            d, rocker = pins[loop.d][0], abs(c[0] - pins[loop.d][0])
            across = [((d - pin).conjugate() * (end - pin)).imag for pin, end in zip(b, c, strict=True)]
            base = np.abs(d - at)
            ahead = (rod**2 - rocker**2 + base**2) / (2 * base)
            rest = rod**2 - ahead**2
            if rest.min() < -SLACK * rod**2:
                return None
            side = 1 if max(across, key=abs) > 0 else -1
            pin = at + (d - at) / base * (ahead + 1j * side * np.sqrt(np.maximum(rest, 0.0)))
            return np.asarray((pin - d) / (c[n] - d))
