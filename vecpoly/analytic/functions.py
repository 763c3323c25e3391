"""Squares, roots, cos, sin and arctan of expressions."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np

from ..algebra.formula import Frac, Node, Power, Root, Row, Txt
from .expr import ONE, THIN, ZERO, Const, Env, Expr, Num, Place, Sum, Values, bracketed, total, vanishes

_QUARTER = 1e-12  # of a right angle


@dataclass(frozen=True, slots=True)
class Square(Expr):
    """The second power."""

    body: Expr

    @property
    def node(self) -> Node:
        return Power(bracketed(self.body), "2")

    @property
    def place(self) -> Place:
        return self.body.place

    def value(self, env: Env) -> Values:
        return self.body.value(env) ** 2

    def parts(self) -> tuple[Expr, ...]:
        return (self.body,)


@dataclass(frozen=True, slots=True)
class SquareRoot(Expr):
    """The root; not a number where there is none."""

    body: Expr

    @property
    def node(self) -> Node:
        return Root(self.body.node)

    def value(self, env: Env) -> Values:
        with np.errstate(invalid="ignore"):  # NaN where it does not assemble
            return np.sqrt(np.asarray(self.body.value(env)))

    def parts(self) -> tuple[Expr, ...]:
        return (self.body,)


@dataclass(frozen=True, slots=True)
class Wave(Expr):
    """cos or sin of an angle."""

    name: str
    angle: Expr

    @property
    def node(self) -> Node:
        return Row((Txt(f"{self.name}{THIN}"), bracketed(self.angle)))

    @property
    def place(self) -> Place:
        return Place.FUNCTION

    def value(self, env: Env) -> Values:
        return (np.cos if self.name == "cos" else np.sin)(self.angle.value(env))

    def parts(self) -> tuple[Expr, ...]:
        return (self.angle,)


@dataclass(frozen=True, slots=True)
class Arctan(Expr):
    """arctan(rise / run) in the quadrant that the signs of rise and run tell."""

    rise: Expr
    run: Expr

    @property
    def node(self) -> Node:
        return Row((Txt(f"arctan{THIN}"), Frac(self.rise.node, self.run.node)))

    def value(self, env: Env) -> Values:
        return np.arctan2(self.rise.value(env), self.run.value(env))

    def parts(self) -> tuple[Expr, ...]:
        return self.rise, self.run


def square(body: Expr) -> Expr:
    """The square; of a negative term, of the term."""
    if isinstance(body, Sum) and len(body.terms) == 1:
        body = body.terms[0][0]
    return ZERO if vanishes(body) else Square(body)


def cos(angle: Expr) -> Expr:
    """cos, turned into ±cos, ±sin, ±1 or 0 where right angles are added."""
    return _wave("cos", angle)


def sin(angle: Expr) -> Expr:
    """sin, turned likewise."""
    return _wave("sin", angle)


def _wave(name: str, angle: Expr) -> Expr:
    terms = angle.terms if isinstance(angle, Sum) else ((angle, 1),)
    right = [
        (t, s)
        for t, s in terms
        if isinstance(t, (Const, Num)) and abs(t.size / (pi / 2) - round(t.size / (pi / 2))) < _QUARTER
    ]
    quarters = sum(s * round(t.size / (pi / 2)) for t, s in right if isinstance(t, (Const, Num))) % 4
    rest = total(*(term for term in terms if term not in right))
    if quarters % 2:
        name, flip = ("sin", quarters == 1) if name == "cos" else ("cos", quarters == 3)
    else:
        flip = quarters == 2
    if isinstance(rest, Sum) and len(rest.terms) == 1:  # of a negative angle
        rest, flip = rest.terms[0][0], flip ^ (name == "sin")
    body: Expr = (ONE if name == "cos" else ZERO) if rest == ZERO else Wave(name, rest)
    return -body if flip else body
