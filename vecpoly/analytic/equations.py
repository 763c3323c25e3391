"""What a mathematical model consists of: equations in parts, parts of a group, groups in order of solution."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..algebra.formula import Node, Row, Txt
from ..words import Words
from .expr import Const, Expr, Var, constants
from .newton import Loops


@dataclass(frozen=True, slots=True)
class Equation:
    """left = right; it gives the variable on its left its value, or it is a condition that must hold."""

    left: Expr
    right: Expr
    gives: bool = True

    @property
    def node(self) -> Node:
        """As it is printed."""
        return Row((self.left.node, Txt(" = "), self.right.node))


@dataclass(frozen=True, slots=True)
class Part:
    """A sentence and the equations that follow it."""

    said: Words
    equations: tuple[Equation, ...] = ()


@dataclass(frozen=True, slots=True)
class Stage:
    """Position, velocity or acceleration of one group."""

    title: Words
    parts: tuple[Part, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class GroupModel:
    """One group's formulas (or those of the driving link): what it is, its stages, and when it is ill-conditioned."""

    title: Words
    opening: Words
    links: tuple[str, ...]
    stages: tuple[Stage, ...]
    determinant: Expr | None = None  # it vanishes at the group's singular positions
    singular: Words | None = None
    loops: Loops | None = None  # where there is no closed form: what Newton's method solves

    @property
    def equations(self) -> Iterator[Equation]:
        """All equations in order."""
        return (equation for stage in self.stages for part in stage.parts for equation in part.equations)

    @property
    def constants(self) -> tuple[Const, ...]:
        """The dimensions in it, each once."""
        found = (c for e in self.equations for side in (e.left, e.right) for c in constants(side))
        return tuple({c.symbol: c for c in found}.values())


Values = dict[str, NDArray[np.float64] | float]


@dataclass(slots=True)
class Trail:
    """Where the last step along the drive has left the unknowns of the loops, and the angles that are followed."""

    unknowns: dict[int, NDArray[np.float64]]
    angles: Values

    def __bool__(self) -> bool:
        return bool(self.unknowns or self.angles)


@dataclass(frozen=True, slots=True)
class Model:
    """The model of a mechanism; `given`: symbols and values of the drive's rates."""

    groups: tuple[GroupModel, ...]
    drive: str  # symbol of the drive's coordinate
    given: tuple[tuple[str, float], ...]
    position: float = 0.0  # of the drive in the given position, from which Newton's method sets out
    step: float = 0.035  # of the drive, from one solution of the loops to the next (rad, or m)
    followed: tuple[tuple[str, float], ...] = ()  # angles that must not jump by a turn, as at that position

    @property
    def closed(self) -> bool:
        """Whether every group has a closed form."""
        return all(group.loops is None for group in self.groups)

    def values(self, position: NDArray[np.float64], consts: Mapping[str, float] | None = None) -> Values:
        """Every variable at these positions of the drive, by the printed formulas.
        consts: other values of dimensions, by their symbol."""
        position = np.asarray(position, np.float64)
        trail = Trail(
            {
                i: np.tile(np.array(g.loops.start)[:, None], (1, position.size))
                for i, g in enumerate(self.groups)
                if g.loops is not None
            },
            dict(self.followed),
        )
        gap = position - self.position
        count = max(1, int(np.ceil(np.abs(gap).max(initial=0.0) / self.step))) if trail else 1
        with np.errstate(invalid="ignore", divide="ignore"):
            for share in np.arange(1, count) / count:  # walk there, so that the assembly stays the same
                self._at(self.position + share * gap, trail, consts)
            return self._at(position, trail, consts)

    def _at(self, position: NDArray[np.float64], trail: Trail, consts: Mapping[str, float] | None) -> Values:
        """Every variable; the unknowns of the loops start from the trail and are left there."""
        env: Values = {self.drive: position, **dict(self.given), **(consts or {})}
        for i, group in enumerate(self.groups):
            if group.loops is not None:
                trail.unknowns[i] = group.loops.places(env, trail.unknowns[i])
                env |= group.loops.solved(env, trail.unknowns[i])
            _reckon(group, env, trail.angles)
        return env

    def gaps(self, position: NDArray[np.float64]) -> Iterator[tuple[Equation, NDArray[np.float64]]]:
        """By how much each condition fails to hold at these positions, group by group."""
        at_once = self.closed and not self.followed
        env: Values = {self.drive: position, **dict(self.given)} if at_once else self.values(position)
        for group in self.groups:
            with np.errstate(invalid="ignore", divide="ignore"):  # at a change point rates have no value
                if at_once:
                    _reckon(group, env, {})
                found = [
                    (equation, np.abs(equation.left.value(env) - equation.right.value(env)))
                    for equation in group.equations
                    if not equation.gives
                ]
            yield from found


def _reckon(group: GroupModel, env: Values, angles: Values) -> None:
    """Every variable of the group that an equation gives, in order; an angle that is followed is the one, among those
    that differ by whole turns, that is nearest to where it was."""
    for equation in group.equations:
        if equation.gives and isinstance(equation.left, Var):
            symbol, value = equation.left.symbol, equation.right.value(env)
            if symbol in angles:
                value = value - 2 * np.pi * np.round((value - angles[symbol]) / (2 * np.pi))
                angles[symbol] = value
            env[symbol] = value
