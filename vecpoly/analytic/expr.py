"""Expressions that both print and compute: the formulas of the mathematical model are what was evaluated.

A leaf is a variable, looked up by its symbol, or a constant with its value (SI, rad). What vanishes or is 1 for this
mechanism is left out as the expression is built: x_A + l cos φ is l cos φ where A is the origin.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import IntEnum, auto
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..algebra.formula import Frac, Node, Row, Txt, signed, sym

Values = Any  # a float, or an array over the positions
Env = Mapping[str, NDArray[np.float64] | float]
THIN = "\u2009"


class Place(IntEnum):
    """The order of factors as they are printed: 2 ω v sin φ."""

    NUMBER = auto()
    LETTER = auto()
    BRACKET = auto()
    FUNCTION = auto()


class Expr:
    """What every expression can do."""

    __slots__ = ()

    def __add__(self, other: Expr) -> Expr:
        return total((self, 1), (other, 1))

    def __sub__(self, other: Expr) -> Expr:
        return total((self, 1), (other, -1))

    def __neg__(self) -> Expr:
        return total((self, -1))

    def __mul__(self, other: Expr) -> Expr:
        return product(self, other)

    def __truediv__(self, other: Expr) -> Expr:
        return quotient(self, other)

    @property
    def node(self) -> Node:
        """As it is printed."""
        raise NotImplementedError

    @property
    def place(self) -> Place:
        """Where it is printed in a product."""
        return Place.LETTER

    def value(self, env: Env) -> Values:
        """Its value where the variables have these."""
        raise NotImplementedError

    def parts(self) -> tuple[Expr, ...]:
        """The expressions of which it is made."""
        return ()


@dataclass(frozen=True, slots=True)
class Num(Expr):
    """A pure number."""

    size: float

    @property
    def node(self) -> Node:
        return Txt(f"{self.size:g}")

    @property
    def place(self) -> Place:
        return Place.NUMBER

    def value(self, env: Env) -> Values:
        return self.size


@dataclass(frozen=True, slots=True)
class Var(Expr):
    """A quantity that changes over the cycle."""

    symbol: str

    @property
    def node(self) -> Node:
        return sym(self.symbol)

    def value(self, env: Env) -> Values:
        return env[self.symbol]


@dataclass(frozen=True, slots=True)
class Const(Expr):
    """A dimension or a given rate; unit: m, rad, rad/s ..."""

    symbol: str
    size: float
    unit: str = "m"

    @property
    def node(self) -> Node:
        return sym(self.symbol) if self.symbol != "π" else Txt("π")

    def value(self, env: Env) -> Values:
        return env.get(self.symbol, self.size) if self.unit == "m" else self.size  # another length may be tried


@dataclass(frozen=True, slots=True)
class Sum(Expr):
    """Terms with their signs, +1 or −1."""

    terms: tuple[tuple[Expr, int], ...]

    @property
    def node(self) -> Node:
        return signed((term.node for term, _ in self.terms), (sign for _, sign in self.terms))

    @property
    def place(self) -> Place:
        return Place.BRACKET

    def value(self, env: Env) -> Values:
        return sum(sign * term.value(env) for term, sign in self.terms)

    def parts(self) -> tuple[Expr, ...]:
        return tuple(term for term, _ in self.terms)


@dataclass(frozen=True, slots=True)
class Product(Expr):
    """Factors side by side; they are multiplied as they come, and printed by kinds."""

    factors: tuple[Expr, ...]

    @property
    def printed(self) -> tuple[Expr, ...]:
        """The factors as they are printed."""
        return tuple(sorted(self.factors, key=lambda one: one.place))

    @property
    def node(self) -> Node:
        items: list[Node] = []
        for i, factor in enumerate(self.printed):
            items += ([Txt(THIN)] if i else []) + [bracketed(factor)]
        return Row(tuple(items))

    def value(self, env: Env) -> Values:
        result: Values = 1.0
        for factor in self.factors:
            result = result * factor.value(env)
        return result

    def parts(self) -> tuple[Expr, ...]:
        return self.factors


@dataclass(frozen=True, slots=True)
class Quotient(Expr):
    """A fraction."""

    num: Expr
    den: Expr

    @property
    def node(self) -> Node:
        return Frac(self.num.node, self.den.node)

    def value(self, env: Env) -> Values:
        return self.num.value(env) / self.den.value(env)

    def parts(self) -> tuple[Expr, ...]:
        return self.num, self.den


ZERO, ONE, TWO = Num(0.0), Num(1.0), Num(2.0)


def total(*terms: tuple[Expr, int]) -> Expr:
    """The sum of signed terms, without what vanishes."""
    flat: list[tuple[Expr, int]] = []
    for term, sign in terms:
        inner = term.terms if isinstance(term, Sum) else ((term, 1),)
        flat += [(part, sign * own) for part, own in inner if not vanishes(part)]
    if not flat:
        return ZERO
    first = next((i for i, (_, sign) in enumerate(flat) if sign > 0), 0)
    flat.insert(0, flat.pop(first))
    return flat[0][0] if len(flat) == 1 and flat[0][1] > 0 else Sum(tuple(flat))


def product(*factors: Expr) -> Expr:
    """The product, its sign in front; numbers first."""
    sign, flat = 1, list[Expr]()
    for factor in factors:
        if isinstance(factor, Sum) and len(factor.terms) == 1:
            sign, factor = sign * factor.terms[0][1], factor.terms[0][0]
        flat += factor.factors if isinstance(factor, Product) else (factor,)
    if any(vanishes(factor) for factor in flat):
        return ZERO
    flat = sorted((factor for factor in flat if factor != ONE), key=lambda factor: not isinstance(factor, Num))
    body = ONE if not flat else flat[0] if len(flat) == 1 else Product(tuple(flat))
    return body if sign > 0 else Sum(((body, -1),))


def quotient(num: Expr, den: Expr) -> Expr:
    """The fraction, its sign in front."""
    if vanishes(num) or den == ONE:
        return num
    if isinstance(num, Sum) and all(sign < 0 for _, sign in num.terms):
        return Sum(((Quotient(-num, den), -1),))
    return Quotient(num, den)


def vanishes(expr: Expr) -> bool:
    """Whether it is the number or the dimension 0."""
    return isinstance(expr, (Num, Const)) and expr.size == 0


def bracketed(expr: Expr) -> Node:
    """As it is printed, in brackets where it is a sum."""
    return Row((Txt("("), expr.node, Txt(")"))) if isinstance(expr, Sum) else expr.node


def constants(expr: Expr) -> Iterator[Const]:
    """All constants in it."""
    if isinstance(expr, Const):
        yield expr
    for part in expr.parts():
        yield from constants(part)
