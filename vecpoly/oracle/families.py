"""Many linkages of one kind at once: their lengths are arrays, A is the origin, D lies on the x axis, AB = 1.

What the general solver does for one mechanism at many positions, this does for many mechanisms at the same positions; a
search reads it, and what it finds is solved anew by the general solver.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..foundation.slotted import dataclass

Reals = NDArray[np.float64]
Points = NDArray[np.complex128]


@dataclass(frozen=True, slots=True, kw_only=True)
class FourBars:
    """Four-bars with crank AB = 1, coupler b, rocker c, frame d (each of shape (m,)); side: +1 where C lies left of
    BD."""

    b: Reals
    c: Reals
    d: Reals
    side: Reals

    @property
    def turn(self) -> NDArray[np.bool_]:
        """Whether AB turns right round, with AB the shortest bar or the frame: Grashof."""
        lengths = np.stack([np.ones_like(self.b), self.b, self.c, self.d])
        short, long = lengths.min(axis=0), lengths.max(axis=0)
        grashof = short + long < lengths.sum(axis=0) / 2
        turns: NDArray[np.bool_] = grashof & ((short == 1.0) | (short == self.d))
        return turns

    @property
    def least_angle(self) -> Reals:
        """γ_min (rad): the crank lies on the line of the frame, cos μ = (b² + c² − (d ∓ 1)²) / (2 b c)."""
        squares = self.b**2 + self.c**2
        cosines = [(squares - (self.d - way) ** 2) / (2 * self.b * self.c) for way in (1.0, -1.0)]
        folded: Reals = np.arccos(np.clip(np.maximum(*np.abs(cosines)), 0.0, 1.0))
        return folded

    def points(self, crank: Points) -> tuple[Points, Points]:
        """B and the unit vector of BC, for crank directions of shape (n,) or (m, n); NaN where it does not close."""
        across = self.d[:, None] - crank
        square = across.real**2 + across.imag**2
        along = 0.5 + (self.b**2 - self.c**2)[:, None] / (2 * square)
        with np.errstate(invalid="ignore"):
            aside = np.sqrt((self.b**2)[:, None] / square - along**2)
        return crank, across * (along + 1j * self.side[:, None] * aside) / self.b[:, None]


def hinge(p: Points, q: Points, from_p: Reals, from_q: Reals, side: Reals) -> Points:
    """Where circles about p and q of these radii (shape (m,)) meet, left of pq for side = +1; NaN where they don't."""
    across = q - p
    square = across.real**2 + across.imag**2
    with np.errstate(invalid="ignore", divide="ignore"):
        along = 0.5 + (from_p**2 - from_q**2)[:, None] / (2 * square)
        aside = np.sqrt((from_p**2)[:, None] / square - along**2)
        met: Points = p + across * (along + 1j * side[:, None] * aside)
    return met


def circles(points: Points) -> tuple[Points, Reals]:
    """Centre and radius of the circle that fits each row best (least squares of |z − z₀|² − r²)."""
    middle = points.mean(axis=1)
    z = points - middle[:, None]
    x, y, square = z.real, z.imag, z.real**2 + z.imag**2
    xx, yy, xy = (x * x).sum(axis=1), (y * y).sum(axis=1), (x * y).sum(axis=1)
    px, py = (square * x).sum(axis=1) / 2, (square * y).sum(axis=1) / 2
    with np.errstate(invalid="ignore", divide="ignore"):
        det = xx * yy - xy * xy
        centre = ((px * yy - py * xy) + 1j * (py * xx - px * xy)) / det
    radius: Reals = np.sqrt(np.abs(centre) ** 2 + square.mean(axis=1))
    return centre + middle, radius
