"""Curves as polynomials, piece by piece: each piece is halved until the last coefficients are rounding.

A curve that is smooth in a piece is off its polynomial by about the last of the coefficients, which fall by a constant
factor each; near a change point, or about a kink that nobody foretold, pieces come out short.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from .state import Reals

NODES = 14  # Gauss's, in each piece
TAIL = 1e-12  # of the greatest value: larger last coefficients are more than rounding
ROUNDS, MOST = 20, 2000  # halvings of a piece; pieces
_AT, _WEIGHTS = legendre.leggauss(NODES)
_FITTED = legendre.legvander(_AT, NODES - 1).T * _WEIGHTS * (np.arange(NODES) + 0.5)[:, None]
Curves = Callable[[Reals], Sequence[Reals]]


def followed(curves: Curves, cuts: Reals) -> tuple[Reals, list[Reals]]:
    """The cuts, more of them where they are needed, and of each curve Legendre's coefficients, a row a piece."""
    rows = _rows(curves, cuts[:-1], cuts[1:])
    for _ in range(ROUNDS):
        rough = np.flatnonzero(np.any([_is_rough(row) for row in rows], axis=0))
        if not rough.size or len(cuts) > MOST:
            break
        cuts = np.insert(cuts, rough + 1, (cuts[rough] + cuts[rough + 1]) / 2)
        first = rough + np.arange(len(rough))  # of each the first half; the second follows it
        rows = [np.insert(row, rough, 0.0, axis=0) for row in rows]
        both = np.sort(np.concatenate([first, first + 1]))
        for row, found in zip(rows, _rows(curves, cuts[both], cuts[both + 1]), strict=True):
            row[both] = found
    return cuts, rows


def _is_rough(rows: Reals) -> NDArray[np.bool_]:
    return np.asarray(np.abs(rows[:, -2:]).max(axis=1) > TAIL * np.abs(rows).sum(axis=1).max(), np.bool_)


def _rows(curves: Curves, left: Reals, right: Reals) -> list[Reals]:
    places = left[:, None] + (right - left)[:, None] / 2 * (1 + _AT)
    return [np.reshape(values, (-1, NODES)) @ _FITTED.T for values in curves(places.ravel())]
