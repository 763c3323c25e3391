"""What hangs on the rocker of a four-bar, tried on scratch paper in many positions of the crank: whether the rod of a
slider reaches its guide, and arcs of a further rocker meet, on the way from one position to the next."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np

from ....designs.inversion.loops import Hinged, Loop, Sliding
from ....plane import Points, circles_meet

TRIED = 4001  # positions of the crank from one that is given to the next
SLACK = 1e-9  # of a length
Spots = tuple[complex, ...]
Known = Callable[[str], Spots]  # where a pin lies in the positions


def reaches(chain: Sequence[Loop], known: Known) -> bool:
    """Whether the crank gets through the positions, turning this way or that; chain: its loop, and those that hang on
    rockers, one on the other."""
    return any(_on_the_way(chain, known, turns) for turns in (1, -1))


def _on_the_way(chain: Sequence[Loop], known: Known, turns: int) -> bool:
    (pivot, *_), pins = known(chain[0].a), known(chain[0].b)
    for n, (first, second) in enumerate(pairwise(pins)):
        angle = float(np.angle((second - pivot) / (first - pivot))) * turns % (2 * np.pi)
        turned: Points = np.exp(1j * turns * np.linspace(0.0, angle, TRIED))
        for loop in chain:
            turned = _followed(loop, known, n, turned)
        if not np.all(np.isfinite(turned)):
            return False
    return True


def _followed(loop: Loop, known: Known, n: int, turned: Points) -> Points:
    """How far the last link of a loop has turned from a position on; NaN where a rod or arcs do not reach."""
    a, b, c = known(loop.a), known(loop.b), known(loop.c)
    pins, rod = a[0] + (b[n] - a[0]) * turned, abs(c[0] - b[0])
    match loop:
        case Sliding():
            height = np.abs(((pins - c[0]) / loop.along).imag)
            return np.where(height <= rod * (1 + SLACK), turned, np.nan)
        case Hinged():
            d, rocker = known(loop.d)[0], abs(c[0] - known(loop.d)[0])
            left = sum(((d - one).conjugate() * (other - one)).imag for one, other in zip(b, c, strict=True)) > 0
            met = circles_meet(pins, rod * (1 + SLACK), d, rocker * (1 + SLACK))
            return (met[0 if left else 1] - d) / (c[n] - d)
