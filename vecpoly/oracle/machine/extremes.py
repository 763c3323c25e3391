"""The greatest value of what work and inertia make together over a period: at a turning point, or at a corner."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...foundation.slotted import replace
from ..state import Reals
from .course import Course

SAMPLES = 33  # places in each piece between which at most one turning point lies
ROUNDS = 52  # halvings: to the last digit
ALIKE = 1e-11  # of the range of the values: tops that differ by less are equally high
APART = 1e-3  # rad: places nearer than this are one top
Made = Callable[[Reals, Reals], Reals]  # of E and J_e
Slope = Callable[[Reals, Reals, Reals, Reals], Reals]  # of E, J_e, M, dJ_e/dψ: its sign is that of the derivative


@dataclass(frozen=True, slots=True)
class Top:
    """A place ψ (rad) and the value there; rival: another place that is as high."""

    psi: float
    value: float
    rival: float | None = None


def highest(course: Course, made: Made, slope: Slope) -> Top:
    """The greatest value of `made`, to full accuracy: its turning points are bracketed and halved."""
    places, at = course.sampled(SAMPLES)
    rows = (course.works, course.inertias, course.moments, course.slopes)
    rise = slope(*(course.of_pieces(row, at) for row in rows))
    piece, k = np.nonzero((rise[:, :-1] > 0) & (rise[:, 1:] <= 0))
    low, high, mine = at[k], at[k + 1], [row[piece] for row in rows]
    for _ in range(ROUNDS):
        middle = (low + high) / 2
        up = slope(*_values_at(mine, middle)) > 0
        low, high = np.where(up, middle, low), np.where(up, high, middle)
    cuts, found = course.cuts, (low + high) / 2
    turning = cuts[piece] + (cuts[piece + 1] - cuts[piece]) / 2 * (1 + found)
    tops = np.concatenate([places[:, 0], places[-1:, -1], turning])
    values = made(course.at(course.works, tops), course.at(course.inertias, tops))
    best = int(np.argmax(values))
    around = cuts[-1] - cuts[0]
    apart = np.abs((tops - tops[best] + around / 2) % around - around / 2) > APART
    rivals = tops[apart & (values[best] - values <= ALIKE * np.ptp(values))]
    return Top(float(tops[best]), float(values[best]), float(rivals[0]) if rivals.size else None)


def lowest(course: Course, made: Made, slope: Slope) -> Top:
    """The least value."""
    top = highest(course, lambda e, j: -made(e, j), lambda e, j, m, r: -slope(e, j, m, r))
    return replace(top, value=-top.value)


def _values_at(rows: Sequence[Reals], x: Reals) -> Iterator[Reals]:
    """What the coefficients of these pieces, of each quantity, make at one place of each piece."""
    powers = np.polynomial.legendre.legvander(x, max(row.shape[1] for row in rows) - 1)
    return ((powers[:, : row.shape[1]] * row).sum(axis=1) for row in rows)
