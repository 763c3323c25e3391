"""Quantities with a symbol, and expressions of them: symbol = formula = numbers = result comes from one expression.

Values are SI (lengths on paper in mm, scales in SI per mm), `float` or arrays of shape (n,) for n hands.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, cast

import numpy as np

from ..foundation.slotted import dataclass
from ..plane import Reals, nominal
from .formula import Frac, Node, Over, Power, Row, Txt, named, row, signed

UNIT_TEXT = {"m/s": "m/s", "m/s^2": "m/s^2", "m": "m", "rad/s": "rad/s", "rad/s^2": "rad/s^2", "mm": "mm"}


def number(value: float, digits: int = 4) -> str:
    """A number as a hand writes it: `digits` significant digits, no exponent unless it must be."""
    if value == 0:
        return "0"
    text = f"{value:.{digits}g}"
    if "e" in text and 1 <= abs(value) < 1e6:
        text = f"{value:.0f}"
    if "e" not in text:
        return text.replace("-", "−")
    mantissa, exponent = text.split("e")
    return f"{mantissa.replace('-', '−')}×10^{{{int(exponent)}}}".replace("{-", "{−")


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


@dataclass(frozen=True, slots=True)
class Quantity(Algebra):
    """A named value: leaf of an expression. `node` is its symbol, `value` SI (an angle in `deg`:
    degrees), `unit` as printed."""

    node: Node
    value: Reals
    unit: str

    def symbol(self) -> Node:
        """The leaf's symbol."""
        return self.node

    def numbers(self) -> Node:
        """The leaf's number; a scale or a negative number would stand in brackets."""
        value = float(nominal(self.value))
        text = number(value) + ("°" if self.unit == "deg" else "")
        return Txt(f"({text})" if value < 0 else text)

    def squared(self) -> Powered:
        """This quantity to the power of two."""
        return Powered(self, 2)

    def cubed(self) -> Powered:
        """This quantity to the power of three."""
        return Powered(self, 3)


@dataclass(frozen=True, slots=True)
class Product(Algebra):
    """A product of expressions."""

    factors: tuple[Expr, ...]

    @property
    def value(self) -> Reals:
        result: Reals = 1.0
        for factor in self.factors:
            result = result * factor.value
        return result

    def symbol(self) -> Node:
        nodes: list[Node] = []
        for i, factor in enumerate(self.factors):
            nodes += ([Txt("\u2009")] if i else []) + [_whole(factor, factor.symbol())]
        return Row(tuple(nodes))

    def numbers(self) -> Node:
        nodes: list[Node] = []
        for i, factor in enumerate(self.factors):
            nodes += ([Txt(" × ")] if i else []) + [_whole(factor, factor.numbers())]
        return Row(tuple(nodes))


@dataclass(frozen=True, slots=True)
class Quotient(Algebra):
    """A fraction of two expressions."""

    num: Expr
    den: Expr

    @property
    def value(self) -> Reals:
        return self.num.value / self.den.value

    def symbol(self) -> Node:
        return Frac(self.num.symbol(), self.den.symbol())

    def numbers(self) -> Node:
        return Frac(self.num.numbers(), self.den.numbers())


@dataclass(frozen=True, slots=True)
class Sum(Algebra):
    """A sum of expressions with their signs, +1 or −1."""

    terms: tuple[Expr, ...]
    signs: tuple[int, ...]

    @property
    def value(self) -> Reals:
        result: Reals = 0.0
        for term, sign in zip(self.terms, self.signs, strict=True):
            result = result + sign * term.value
        return result

    def symbol(self) -> Node:
        return signed((term.symbol() for term in self.terms), self.signs)

    def numbers(self) -> Node:
        return signed((term.numbers() for term in self.terms), self.signs)


@dataclass(frozen=True, slots=True)
class Powered(Algebra):
    """A quantity to a small power."""

    base: Quantity
    exponent: int

    @property
    def value(self) -> Reals:
        return self.base.value**self.exponent

    def symbol(self) -> Node:
        return Power(self.base.symbol(), str(self.exponent))

    def numbers(self) -> Node:
        return Power(self.base.numbers(), str(self.exponent))


@dataclass(frozen=True, slots=True)
class Times(Algebra):
    """A pure number in front of an expression: 2 ω v."""

    factor: int
    body: Expr

    @property
    def value(self) -> Reals:
        return self.factor * self.body.value

    def symbol(self) -> Node:
        return Row((Txt(str(self.factor)), _whole(self.body, self.body.symbol())))

    def numbers(self) -> Node:
        return Row((Txt(f"{self.factor} × "), _whole(self.body, self.body.numbers())))


_FUNCTIONS: dict[str, Callable[[Any], Any]] = {"sin": np.sin, "cos": np.cos, "tan": np.tan}


@dataclass(frozen=True, slots=True)
class Of(Algebra):
    """A trigonometric function of an angle in degrees: tan(α + φ); `name` is sin, cos or tan."""

    name: str
    angle: Expr

    @property
    def value(self) -> Reals:
        result: Reals = _FUNCTIONS[self.name](np.radians(self.angle.value))
        return result

    def symbol(self) -> Node:
        return Row((Txt(f"{self.name}\u2009"), _whole(self.angle, self.angle.symbol())))

    def numbers(self) -> Node:
        return Row((Txt(f"{self.name}\u2009"), _whole(self.angle, self.angle.numbers())))


Expr = Quantity | Product | Quotient | Sum | Powered | Times | Of


def _whole(expr: Expr, node: Node) -> Node:
    """The node in brackets where it is a sum beside which something stands."""
    return Row((Txt("("), node, Txt(")"))) if isinstance(expr, Sum) else node


def magnitude(symbol: str, value: Reals, unit: str) -> Quantity:
    """A named quantity by its symbol in the short notation of `formula`."""
    return Quantity(named(symbol), value, unit)


def letters_node(letters: str) -> Node:
    """Letters of a paper length side by side: ``p c_2`` → p c₂."""
    return Row(tuple(item for word in letters.split() for item in row(word).items))


def paper(letters: Node, mm: Reals) -> Quantity:
    """A length measured on paper, overlined: \\overline{pb}."""
    return Quantity(Over(letters), mm, "mm")


def worked(result: Node, expr: Expr, unit: str) -> Row:
    """symbol = formula = numbers = result with unit, from one expression."""
    end = Txt(f" = {_with_unit(expr.value, unit)}")
    same = isinstance(expr, Quantity)
    middle: tuple[Node, ...] = () if same else (Txt(" = "), expr.symbol(), Txt(" = "), expr.numbers())
    return Row((result, *middle, end))


def stated(quantity: Quantity) -> Row:
    """symbol = value with unit."""
    return Row((quantity.node, Txt(f" = {_with_unit(quantity.value, quantity.unit)}")))


def spot_in_mm(at: complex) -> str:
    """The coordinates of a point (m) as they are printed, in mm: (96.3, 238.2) mm."""
    x, y = (number(round(1e3 * part, 9), 5) for part in (at.real, at.imag))
    return f"({x}, {y}) mm"


def _with_unit(value: Reals, unit: str) -> str:
    text = number(float(nominal(value)))
    return f"{text}°" if unit == "deg" else f"{text} {unit}".rstrip()
