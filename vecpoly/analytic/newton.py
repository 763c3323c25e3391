"""Loop equations f(q, known) = 0 of a group that has no closed form:
Jacobian, right sides of its rates, and their solution."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import product as pairs

import numpy as np
from numpy.typing import NDArray

from .calculus import derivative, variables
from .expr import Expr, Var, product, total
from .functions import square

_ROUNDS, _NEAR = 12, 1e-13
Values = dict[str, NDArray[np.float64] | float]


@dataclass(frozen=True, kw_only=True)
class Loops:
    """The conditions f = 0 of a group, all told by its unknowns q and by what is known.

    rates: of every variable in f its first and second rate (an Expr: ω_2, v_Bx, or nothing); start: q at the given
    position;
    name: the symbol under which the determinant of the Jacobian is kept.
    """

    conditions: tuple[Expr, ...]
    unknowns: tuple[str, ...]
    rates: Mapping[str, tuple[Expr, Expr]]
    start: tuple[float, ...]
    name: str

    @cached_property
    def jacobian(self) -> tuple[tuple[Expr, ...], ...]:
        """∂f_i/∂q_j."""
        return tuple(tuple(derivative(f, q) for q in self.unknowns) for f in self.conditions)

    @property
    def _known(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(v for f in self.conditions for v in variables(f) if v not in self.unknowns))

    @cached_property
    def velocity_sides(self) -> tuple[Expr, ...]:
        """b_i in J q̇ = b: −Σ ∂f_i/∂k · k̇ over what is known."""
        return tuple(
            -total(*((product(derivative(f, k), self.rates[k][0]), 1) for k in self._known)) for f in self.conditions
        )

    @cached_property
    def acceleration_sides(self) -> tuple[Expr, ...]:
        """c_i in J q̈ = c: −Σ ∂f_i/∂k · k̈ − Σ ∂²f_i/∂a∂b · ȧ ḃ over everything."""
        every = (*self.unknowns, *self._known)
        sides = []
        for f in self.conditions:
            terms = [product(derivative(f, k), self.rates[k][1]) for k in self._known]
            for (i, a), (j, b) in pairs(enumerate(every), repeat=2):
                twice = derivative(derivative(f, a), b)
                rates = square(self.rates[a][0]) if i == j else product(self.rates[a][0], self.rates[b][0])
                terms += [product(twice, rates)] if i <= j else []
                terms += [product(twice, rates)] if i < j else []
            sides.append(-total(*((term, 1) for term in terms)))
        return tuple(sides)

    def places(self, env: Values, q: NDArray[np.float64]) -> NDArray[np.float64]:
        """q (unknowns × positions) by Newton's method from this guess; NaN where it does not settle."""
        f, size = self.conditions, q.shape[1]
        rows = self.jacobian
        gap = np.full(size, np.inf)
        for _ in range(_ROUNDS):
            here = env | dict(zip(self.unknowns, q, strict=True))
            left = _stacked(f, here, size)
            gap = np.abs(left).max(axis=0)
            if not np.nanmax(gap, initial=0.0) > _NEAR:
                break
            q = q - _solved(_matrix(rows, here, size), left)
        return np.where(gap < 1e-9, q, np.nan)

    def solved(self, env: Values, q: NDArray[np.float64]) -> Values:
        """The unknowns, their first and second rates and the determinant."""
        size = q.shape[1]
        here = env | dict(zip(self.unknowns, q, strict=True))
        matrix = _matrix(self.jacobian, here, size)
        here[self.name] = np.linalg.det(np.where(np.isfinite(matrix), matrix, np.nan))
        for order, sides in enumerate((self.velocity_sides, self.acceleration_sides)):
            found = _solved(matrix, _stacked(sides, here, size))
            here |= {
                rate.symbol: row
                for name, row in zip(self.unknowns, found, strict=True)
                if isinstance(rate := self.rates[name][order], Var)
            }
        return {k: v for k, v in here.items() if k not in env}


def _stacked(rows: tuple[Expr, ...], env: Values, size: int) -> NDArray[np.float64]:
    return np.stack([np.broadcast_to(np.asarray(row.value(env), np.float64), (size,)) for row in rows])


def _matrix(rows: tuple[tuple[Expr, ...], ...], env: Values, size: int) -> NDArray[np.float64]:
    """positions × rows × columns."""
    return np.stack([_stacked(row, env, size) for row in rows]).transpose(2, 0, 1)


def _solved(matrix: NDArray[np.float64], right: NDArray[np.float64]) -> NDArray[np.float64]:
    """The solution at every position; NaN where the matrix is singular or lost."""
    sound = np.asarray(np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(right).all(axis=0), np.bool_)
    sound[sound] = np.abs(np.linalg.det(matrix[sound])) > 0
    out = np.full(right.shape, np.nan)
    if sound.any():
        out[:, sound] = np.linalg.solve(matrix[sound], right.T[sound][..., None])[..., 0].T
    return out
