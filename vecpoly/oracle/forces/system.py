"""The equations of equilibrium, three for every body, all positions at once;
friction's wrenches as further right-hand sides."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ...errors import EquilibriumError
from ...words import Words
from ..state import Bodies, Points, Reals, cross
from .acting import Acting
from .elimination import Equation, Flags, add, solved
from .friction import sizes
from .pairs import Pair, Wrench

NO_FLANKS: Mapping[int, Reals] = {}
ROUNDING = 1e-12  # of the largest force: a smaller one, or its moment at an arm of the mechanism's size, is rounding


@dataclass(frozen=True, slots=True, eq=False)
class Balance:
    """A solved equilibrium: sizes of the pairs' units, of their friction, and of the balancing load, per position."""

    units: tuple[tuple[Reals, ...], ...]  # by pair, by unit
    rubs: tuple[Reals, ...]  # pressing force that friction counts by, 0 where there is none
    load: Reals
    largest: Reals  # the largest force at each position (N), couples over the mechanism's scale

    def without(self, lost: Flags) -> Balance:
        """The same, NaN at these positions."""
        if not lost.any():
            return self
        blank = np.where(lost, np.nan, 0.0)
        return Balance(
            tuple(tuple(size + blank for size in units) for units in self.units),
            tuple(size + blank for size in self.rubs),
            self.load + blank,
            self.largest,
        )

    def wrench(self, pairs: Sequence[Pair], index: int) -> Wrench:
        """Force and couple (about the pair's point) of link a on link b; a force that is only rounding is zero."""
        pair = pairs[index]
        parts = [(size, unit) for size, unit in zip(self.units[index], pair.units, strict=True)]
        if pair.rub is not None:
            parts.append((self.rubs[index], pair.rub))
        if pair.apart is not None:
            parts.append((np.abs(self.units[index][0]), pair.apart))
        force = sum((size * unit.force for size, unit in parts), np.zeros_like(self.load, np.complex128))
        return Wrench(
            np.where(np.abs(force) <= ROUNDING * self.largest, 0.0, force),
            sum((size * unit.couple for size, unit in parts), np.zeros_like(self.load)),
        )


def _leant(pair: Pair, flank: Reals | None) -> tuple[Wrench, ...]:
    """The pair's units; that of teeth along the line of action of the flank that works."""
    if pair.apart is None or flank is None:
        return pair.units
    unit = pair.units[0]
    return (Wrench(unit.force + flank * pair.apart.force, unit.couple),)


@dataclass(frozen=True, slots=True, eq=False)
class System:
    """Bodies in their order, what they do to each other, what acts on them, and the balancing load of size 1."""

    names: tuple[str, ...]
    bodies: Bodies
    pairs: tuple[Pair, ...]
    known: tuple[Acting, ...]
    free: Acting
    scale: float
    count: int  # positions

    def solve(self, skip: Flags, flanks: Mapping[int, Reals] = NO_FLANKS) -> tuple[Balance, Balance, Reals]:
        """Without friction, with it, and the share of the friction that could be borne (1:
        all). skip: positions that stay NaN. flanks: the signs of the teeth's first units, by pair; 0 where left out.

        Raises EquilibriumError where unknowns and equations differ in number.
        """
        columns = [(pair, unit) for n, pair in enumerate(self.pairs) for unit in _leant(pair, flanks.get(n))]
        rubbing = [pair for pair in self.pairs if pair.rub is not None]
        side = len(columns) + 1
        if side != 3 * len(self.names):
            raise EquilibriumError(
                Words(
                    f"{len(self.names)} 个构件有 {3 * len(self.names)} 个平衡方程，而未知量有 {side} 个："
                    "一个平衡载荷只适用于单自由度、没有闲置构件的机构",
                    f"{3 * len(self.names)} equations of equilibrium for {len(self.names)} links, but {side} "
                    "unknowns: one balancing load holds a mechanism of one degree of freedom without idle links",
                )
            )
        left, right = ([Equation() for _ in range(side)] for _ in "lr")
        for k, (pair, unit) in enumerate(columns):
            self._enter_pair(left, k, pair, unit)
        for act in self.free.parts:
            self._enter(left, side - 1, act.link, act.at, act.force, act.couple)
        for act in (part for known in self.known for part in known.parts):
            self._enter(right, 0, act.link, act.at, -act.force, -act.couple)
        for k, pair in enumerate(rubbing):
            assert pair.rub is not None
            self._enter_pair(right, 1 + k, pair, Wrench(-pair.rub.force, -pair.rub.couple))
        found = solved(left, right, 1 + len(rubbing), self.count)
        found[..., skip] = np.nan
        return self._balances(found)

    def _enter_pair(self, rows: list[Equation], column: int, pair: Pair, wrench: Wrench) -> None:
        self._enter(rows, column, pair.b, pair.at, wrench.force, wrench.couple)
        self._enter(rows, column, pair.a, pair.at, -wrench.force, -wrench.couple)

    def _enter(self, rows: list[Equation], column: int, link: str, at: Points, force: Points, couple: Reals) -> None:
        """Add a wrench to the link's three equations; moments about its own first point, over the mechanism's scale."""
        if link not in self.names:
            return
        first, centre = 3 * self.names.index(link), self.bodies[link].at
        add(rows[first], column, force.real)
        add(rows[first + 1], column, force.imag)
        add(rows[first + 2], column, couple / self.scale)
        if at is not centre and (force.size > 1 or force[0] != 0):
            add(rows[first + 2], column, cross(at - centre, force) / self.scale)

    def _balances(self, found: Reals) -> tuple[Balance, Balance, Reals]:
        """found: unknowns × (loads, friction of each rubbing pair) × positions."""
        firsts = np.cumsum([0, *(len(pair.units) for pair in self.pairs)])
        rubbing = [(first, pair.pressed) for first, pair in zip(firsts, self.pairs, strict=False) if pair.rubs]
        press = np.zeros((len(rubbing), found.shape[1], self.count), np.complex128)
        for row, (first, parts) in zip(press, rubbing, strict=True):
            row.real = found[first]
            if parts == 2:
                row.imag = found[first + 1]
        dry = found[:, 0]
        base = np.where(np.abs(press[:, 0]) <= ROUNDING * self._largest(dry), 0.0, press[:, 0])
        pressed, reached = sizes(base, press[:, 1:])
        wet = dry + sum((found[:, 1 + k] * u for k, u in enumerate(pressed)), np.zeros(1))
        return self._balance(dry, np.zeros_like(pressed)), self._balance(wet, pressed), reached

    def _balance(self, x: Reals, pressed: Reals) -> Balance:
        rows, rubs = iter(x[:-1]), iter(pressed)
        units = tuple(tuple(next(rows) for _ in pair.units) for pair in self.pairs)
        none = np.zeros(self.count)
        return Balance(units, tuple(next(rubs) if pair.rubs else none for pair in self.pairs), x[-1], self._largest(x))

    @property
    def given(self) -> Reals:
        """The largest of the given loads at each position (N), couples over the mechanism's scale."""
        sizes = [size for act in self.known for size in (np.abs(act.force), np.abs(act.couple) / self.scale)]
        largest: Reals = np.max(np.broadcast_arrays(np.zeros(self.count), *sizes), axis=0)
        return largest

    def _largest(self, x: Reals) -> Reals:
        largest: Reals = np.max(np.broadcast_arrays(self.given, *np.abs(x[:-1])), axis=0)
        return largest
