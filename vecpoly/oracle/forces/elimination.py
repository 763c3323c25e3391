"""Linear equations at many positions at once: one elimination for all of them, LAPACK where its pivots are weak.

The equations of statics are sparse, and most of their coefficients are the same at all positions (a pin's force enters
by ±1). So an equation is a mapping column -> coefficient, an array of one element where it does not change, and the
pivots are chosen once: unchanging ones first, then those that stay furthest from zero.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..state import Reals

Equation = dict[int, Reals]
Flags = NDArray[np.bool_]
FEW = 100  # positions below which LAPACK is quicker
WEAK = 1e-5  # a pivot below this share of its equation's largest coefficient is not used


def add(equation: Equation, column: int, term: Reals) -> None:
    """Add to a coefficient; nothing where the term is always zero."""
    if term.size > 1 or term[0] != 0.0:
        old = equation.get(column)
        equation[column] = term if old is None else old + term


def solved(left: list[Equation], right: list[Equation], sides: int, count: int) -> Reals:
    """Unknowns × sides × positions; NaN where singular or where a coefficient is NaN.

    left: the equations' coefficients by unknown; right: their right-hand sides by side.
    """
    if count < FEW:
        return _lapack(_dense(left, len(left), count), _dense(right, sides, count))
    found = np.zeros((len(left), sides, count))
    order, weak = _triangle([dict(row) for row in left], [dict(row) for row in right], count)
    for row, rest, column, pivot in reversed(order):
        for side in range(sides):
            total = rest.get(side)
            for other, factor in row.items():
                if other != column and (side in rest or found[other, side].any()):
                    part = factor * found[other, side]
                    total = -part if total is None else total - part
            if total is not None:
                found[column, side] = total / pivot
    if weak.any():
        index = np.flatnonzero(weak)
        found[:, :, index] = _lapack(
            _dense(left, len(left), count)[..., index], _dense(right, sides, count)[..., index]
        )
    return found


Step = tuple[Equation, Equation, int, Reals]


def _triangle(left: list[Equation], right: list[Equation], count: int) -> tuple[list[Step], Flags]:
    """Eliminate forwards: equations in the order of their pivots, and where a pivot is weak."""
    weak, order, open_ = np.zeros(count, bool), list[Step](), list(range(len(left)))
    while open_:
        choice = _pivot([(i, left[i]) for i in open_])
        if choice is None:
            return [], np.ones(count, bool)
        first, column = choice
        row, rest, pivot = left[first], right[first], left[first][column]
        if pivot.size > 1:
            largest = np.max(np.broadcast_arrays(*(np.abs(v) for v in row.values())), axis=0)
            weak |= ~(np.abs(pivot) > WEAK * largest)
        open_.remove(first)
        for other in open_:
            if column in left[other]:
                factor = left[other].pop(column) / pivot
                _subtract(left[other], row, factor, column)
                _subtract(right[other], rest, factor, -1)
        order.append((row, rest, column, pivot))
    return order, weak


def _pivot(rows: list[tuple[int, Equation]]) -> tuple[int, int] | None:
    """Equation and column of the next pivot:
    of the unchanging ones that which spares most, else the one furthest from zero."""
    uses: dict[int, int] = {}
    for _, row in rows:
        for column in row:
            uses[column] = uses.get(column, 0) + 1
    steady = [
        ((len(row) - 1) * (uses[column] - 1), i, column)
        for i, row in rows
        for column, v in row.items()
        if v.size == 1 and abs(v[0]) > 1e-3
    ]
    if steady:
        return min(steady)[1:]
    moving = [(float(np.fmin.reduce(np.abs(v))), i, column) for i, row in rows for column, v in row.items()]
    return max(moving)[1:] if moving else None


def _subtract(target: Equation, source: Equation, factor: Reals, skip: int) -> None:
    for column, v in source.items():
        if column != skip:
            add(target, column, -factor * v)
            if column in target and target[column].size == 1 and abs(target[column][0]) < 1e-14:
                del target[column]


def _dense(rows: list[Equation], width: int, count: int) -> Reals:
    """The same as one array."""
    table = np.zeros((len(rows), width, count))
    for i, row in enumerate(rows):
        for column, v in row.items():
            table[i, column] = v
    return table


def _lapack(matrix: Reals, right: Reals) -> Reals:
    """Stacked solution, positions last; NaN where there is none."""
    stack, sides = matrix.transpose(2, 0, 1).copy(), right.transpose(2, 0, 1).copy()
    bad = ~(np.isfinite(stack).all(axis=(1, 2)) & np.isfinite(sides).all(axis=(1, 2)))
    stack[bad] = np.eye(len(matrix))
    bad |= ~(np.abs(np.linalg.det(stack)) > 0)
    stack[bad], sides[bad] = np.eye(len(matrix)), np.nan
    return np.asarray(np.moveaxis(np.linalg.solve(stack, sides), 0, -1), np.float64)
