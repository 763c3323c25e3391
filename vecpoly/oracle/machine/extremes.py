"""The greatest value of what work and inertia make together over a period: at a turning point, or at a corner."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..state import Reals
from .course import Course

SAMPLES = 33  # places in each piece between which at most one turning point lies
ROUNDS = 52  # halvings: to the last digit
Made = Callable[[Reals, Reals], Reals]  # of E and J_e
Slope = Callable[[Reals, Reals, Reals, Reals], Reals]  # of E, J_e, M, dJ_e/dψ: its sign is that of the derivative


@dataclass(frozen=True, slots=True)
class Top:
    """A place ψ (rad) and the value there."""

    psi: float
    value: float


def highest(course: Course, made: Made, slope: Slope) -> Top:
    """The greatest value of `made`, to full accuracy: its turning points are bracketed and halved."""
    places, at = course.sampled(SAMPLES)
    rise = _slope(course, slope, at)
    piece, k = np.nonzero((rise[:, :-1] > 0) & (rise[:, 1:] <= 0))
    low, high = at[k], at[k + 1]
    for _ in range(ROUNDS):
        middle = (low + high) / 2
        up = _slope_at(course, slope, piece, middle) > 0
        low, high = np.where(up, middle, low), np.where(up, high, middle)
    cuts, found = course.cuts, (low + high) / 2
    turning = cuts[piece] + (cuts[piece + 1] - cuts[piece]) / 2 * (1 + found)
    tops = np.concatenate([places[:, 0], places[-1:, -1], turning])
    values = made(course.at(course.works, tops), course.at(course.inertias, tops))
    best = int(np.argmax(values))
    return Top(float(tops[best]), float(values[best]))


def lowest(course: Course, made: Made, slope: Slope) -> Top:
    """The least value."""
    top = highest(course, lambda e, j: -made(e, j), lambda e, j, m, r: -slope(e, j, m, r))
    return Top(top.psi, -top.value)


def _slope(course: Course, slope: Slope, at: Reals) -> Reals:
    rows = (course.works, course.inertias, course.moments, course.slopes)
    return slope(*(course.of_pieces(row, at) for row in rows))


def _slope_at(course: Course, slope: Slope, piece: NDArray[np.intp], x: Reals) -> Reals:
    """The same at one place of each of these pieces."""
    rows = (course.works, course.inertias, course.moments, course.slopes)
    found = []
    for row in rows:
        powers = np.polynomial.legendre.legvander(x, row.shape[1] - 1)
        found.append((powers * row[piece]).sum(axis=1))
    return slope(*found)
