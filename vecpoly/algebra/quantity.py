"""Quantities with a symbol, and expressions of them: symbol = formula = numbers = result comes from one expression.

Values are SI (lengths on paper in mm, scales in SI per mm), `float` or arrays of shape (n,) for n hands.
"""

from __future__ import annotations

from collections.abc import Callable
from math import isinf
from operator import attrgetter
from typing import Any, cast

import numpy as np

from ..foundation.slotted import dataclass
from ..plane import Reals, nominal
from .formula import Frac, Node, Over, Power, Root, Row, Txt, alone, named, signed
from .functions import FUNCTIONS
from .rounding import to_figures, to_places

FIGURES = 4  # significant digits of a number in a line
_PI, _OF_PI = (named("π"), Txt("π")), 5  # as every pocket calculator and every table tells it


def number(value: float, digits: int = FIGURES) -> str:
    """A number as a hand writes it: `digits` significant digits, no exponent unless it must be."""
    if value == 0 or isinf(value):
        return "0" if value == 0 else "∞" if value > 0 else "−∞"
    text = f"{to_figures(value, digits):.{digits}g}"
    if "e" in text and 1 <= abs(value) < 1e6:
        text = f"{to_places(value, 0):.0f}"
    mantissa, by, exponent = text.partition("e")
    return (f"{mantissa}×10^{{{int(exponent)}}}" if by else text).replace("-", "−")


class Algebra:
    """What every expression can do: * / + − and powers give expressions again."""

    __slots__ = ()

    def __mul__(self, other: Expr) -> Product:
        return Product((*(self.factors if isinstance(self, Product) else (cast("Expr", self),)), other))

    def __truediv__(self, other: Expr) -> Quotient:
        return Quotient(cast("Expr", self), other)

    def __add__(self, other: Expr) -> Sum:
        return self._joined(other, 1)

    def __sub__(self, other: Expr) -> Sum:
        return self._joined(other, -1)

    def _joined(self, other: Expr, sign: int) -> Sum:
        terms, signs = (self.terms, self.signs) if isinstance(self, Sum) else ((cast("Expr", self),), (1,))
        return Sum((*terms, other), (*signs, sign))


class Composed(Algebra):
    """An expression of others; `reckoned` is its value where each of its quantities has what `of` says."""

    __slots__ = ()

    @property
    def value(self: Any) -> Reals:
        result: Reals = self.reckoned(attrgetter("value"))
        return result


@dataclass(frozen=True, slots=True)
class Quantity(Algebra):
    """A leaf: its symbol `node`, `value` in SI (`deg`: degrees), `unit` as printed, its number if it is `told`."""

    node: Node
    value: Reals
    unit: str
    told: str = ""

    def reckoned(self, of: Reckoner) -> Reals:
        return of(self)

    def symbol(self) -> Node:
        return self.node

    def numbers(self, digits: int = FIGURES) -> Node:
        """The leaf's number; a scale or a negative number would stand in brackets."""
        value = float(nominal(self.value))
        whole = bool(isinstance(self.node, Over) and value and not value % 1)  # a length on paper, read to a tenth
        text = (self.told or number(value, self.figures(digits)) + ".0" * whole) + "°" * (self.unit == "deg")
        return Txt(f"({text})" if value < 0 else text)

    def figures(self, digits: int) -> int:
        """So many figures, of π everywhere those of 3.1416."""
        return max(digits, _OF_PI) if self.node in _PI else digits

    def squared(self) -> Powered:
        """To the power of two."""
        return Powered(self, 2)

    def cubed(self) -> Powered:
        """This quantity to the power of three."""
        return Powered(self, 3)


@dataclass(frozen=True, slots=True)
class Product(Composed):
    """A product of expressions."""

    factors: tuple[Expr, ...]

    def reckoned(self, of: Reckoner) -> Reals:
        result: Reals = 1.0
        for factor in self.factors:
            result = result * factor.reckoned(of)
        return result

    def symbol(self) -> Node:
        nodes: list[Node] = []
        for i, factor in enumerate(self.factors):
            nodes += ([Txt("\u2009")] if i else []) + [_whole(factor, factor.symbol())]
        return Row(tuple(nodes))

    def numbers(self, digits: int = FIGURES) -> Node:
        nodes: list[Node] = []
        for i, factor in enumerate(self.factors):
            nodes += ([Txt(" × ")] if i else []) + [_whole(factor, factor.numbers(digits))]
        return Row(tuple(nodes))


@dataclass(frozen=True, slots=True)
class Quotient(Composed):
    """A fraction of two expressions."""

    num: Expr
    den: Expr

    def reckoned(self, of: Reckoner) -> Reals:
        return self.num.reckoned(of) / self.den.reckoned(of)

    def symbol(self) -> Node:
        return Frac(self.num.symbol(), self.den.symbol())

    def numbers(self, digits: int = FIGURES) -> Node:
        return Frac(alone(self.num.numbers(digits)), alone(self.den.numbers(digits)))


@dataclass(frozen=True, slots=True)
class Sum(Composed):
    """A sum of expressions with their signs, +1 or −1."""

    terms: tuple[Expr, ...]
    signs: tuple[int, ...]

    def reckoned(self, of: Reckoner) -> Reals:
        result: Reals = 0.0
        for term, sign in zip(self.terms, self.signs, strict=True):
            result = result + sign * term.reckoned(of)
        return result

    def symbol(self) -> Node:
        return signed((term.symbol() for term in self.terms), self.signs)

    def numbers(self, digits: int = FIGURES) -> Node:
        return signed((term.numbers(digits) for term in self.terms), self.signs)


@dataclass(frozen=True, slots=True)
class Powered(Composed):
    """A quantity to a small power."""

    base: Quantity
    exponent: int

    def reckoned(self, of: Reckoner) -> Reals:
        return self.base.reckoned(of) ** self.exponent

    def symbol(self) -> Node:
        return Power(self.base.symbol(), str(self.exponent))

    def numbers(self, digits: int = FIGURES) -> Node:
        return Power(self.base.numbers(digits), str(self.exponent))


@dataclass(frozen=True, slots=True)
class Times(Composed):
    """A pure number in front of an expression: 2 ω v."""

    factor: int
    body: Expr

    def reckoned(self, of: Reckoner) -> Reals:
        return self.factor * self.body.reckoned(of)

    def symbol(self) -> Node:
        return Row((Txt(str(self.factor)), _whole(self.body, self.body.symbol())))

    def numbers(self, digits: int = FIGURES) -> Node:
        return Row((Txt(f"{self.factor} × "), _whole(self.body, self.body.numbers(digits))))


@dataclass(frozen=True, slots=True)
class Of(Composed):
    """A trigonometric function of an angle in degrees, tan(α + φ), or the angle itself in degrees, arctan f."""

    name: str
    angle: Expr

    def reckoned(self, of: Reckoner) -> Reals:
        return FUNCTIONS[self.name](self.angle.reckoned(of))

    def symbol(self) -> Node:
        return Row((Txt(f"{self.name}\u2009"), _whole(self.angle, self.angle.symbol())))

    def numbers(self, digits: int = FIGURES) -> Node:
        return Row((Txt(f"{self.name}\u2009"), _whole(self.angle, self.angle.numbers(digits))))


@dataclass(frozen=True, slots=True)
class Rooted(Composed):
    """The square root of an expression."""

    body: Expr

    def reckoned(self, of: Reckoner) -> Reals:
        result: Reals = np.sqrt(self.body.reckoned(of))
        return result

    def symbol(self) -> Node:
        return Root(self.body.symbol())

    def numbers(self, digits: int = FIGURES) -> Node:
        return Root(self.body.numbers(digits))


Expr = Quantity | Product | Quotient | Sum | Powered | Times | Of | Rooted
Reckoner = Callable[[Quantity], Reals]


def _whole(expr: Expr, node: Node) -> Node:
    """The node in brackets where it is a sum beside which something stands."""
    return Row((Txt("("), node, Txt(")"))) if isinstance(expr, Sum) else node


def magnitude(symbol: str, value: Reals, unit: str) -> Quantity:
    """A named quantity by its symbol in the short notation of `formula`."""
    return Quantity(named(symbol), value, unit)


def paper(letters: Node, mm: Reals, *, summed: bool = False) -> Quantity:
    """A length measured on paper, overlined: \\overline{pb}; or the sum of several, told by the letters of one."""
    return Quantity(Over(letters, summed), mm, "mm")
