"""A rocker with a slider tried on scratch paper in many positions of the crank: whether the slider's rod reaches its
guide on the way from one position to the next."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from ....plane import circles_meet

TRIED = 4001  # positions of the crank from one that is given to the next
SLACK = 1e-9  # of a length
Spots = tuple[complex, ...]


def reaches(four: tuple[Spots, Spots, Spots, Spots], along: complex, e: Spots) -> bool:
    """Whether the crank AB gets through the positions with the slider E on its rocker DC, turning this way or that."""
    return any(_on_the_way(four, along, e, turns) for turns in (1, -1))


def _on_the_way(four: tuple[Spots, Spots, Spots, Spots], along: complex, e: Spots, turns: int) -> bool:
    a, b, c, d = four
    coupler, rocker, rod = abs(c[0] - b[0]), abs(c[0] - d[0]), abs(c[0] - e[0])
    left = sum(((d[0] - one).conjugate() * (other - one)).imag for one, other in zip(b, c, strict=True)) > 0
    for first, second in pairwise(b):
        angle = float(np.angle((second - a[0]) / (first - a[0]))) * turns % (2 * np.pi)
        crank = (first - a[0]) * np.exp(1j * turns * np.linspace(0.0, angle, TRIED))
        pins = circles_meet(a[0] + crank, coupler * (1 + SLACK), d[0], rocker * (1 + SLACK))[0 if left else 1]
        height = np.abs(((pins - e[0]) / along).imag)
        if not np.all(height <= rod * (1 + SLACK)):  # nor of a place where the arcs do not meet
            return False
    return True
