"""Quantities with a symbol, and expressions of them: symbol = formula = numbers = result comes from one expression.

Values are SI (lengths on paper in mm, scales in SI per mm), `float` or arrays of shape (n,) for n hands.
"""

from __future__ import annotations

from dataclasses import dataclass

from .formula import Frac, Node, Over, Power, Row, Txt, sym
from .plane import Reals, nominal

UNIT_TEXT = {"m/s": "m/s", "m/s^2": "m/s^2", "m": "m", "rad/s": "rad/s", "rad/s^2": "rad/s^2", "mm": "mm"}


def number(value: float, digits: int = 4) -> str:
    """A number as a hand writes it: `digits` significant digits, no exponent unless it must be."""
    if value == 0:
        return "0"
    text = f"{value:.{digits}g}"
    if "e" not in text:
        return text.replace("-", "−")
    mantissa, exponent = text.split("e")
    return f"{mantissa.replace('-', '−')}×10^{{{int(exponent)}}}".replace("{-", "{−")


@dataclass(frozen=True, slots=True)
class Quantity:
    """A named value: leaf of an expression. `node` is its symbol, `value` SI, `unit` as printed."""

    node: Node
    value: Reals
    unit: str

    def symbol(self) -> Node:
        """The leaf's symbol."""
        return self.node

    def numbers(self) -> Node:
        """The leaf's number; a scale or a negative number would stand in brackets."""
        value = float(nominal(self.value))
        text = number(value)
        return Txt(f"({text})" if value < 0 else text)

    def __mul__(self, other: Expr) -> Product:
        return Product((self, other))

    def __truediv__(self, other: Expr) -> Quotient:
        return Quotient(self, other)

    def squared(self) -> Squared:
        """This quantity to the power of two."""
        return Squared(self)


@dataclass(frozen=True, slots=True)
class Product:
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
            nodes += ([Txt("\u2009")] if i else []) + [factor.symbol()]
        return Row(tuple(nodes))

    def numbers(self) -> Node:
        nodes: list[Node] = []
        for i, factor in enumerate(self.factors):
            nodes += ([Txt(" × ")] if i else []) + [factor.numbers()]
        return Row(tuple(nodes))

    def __mul__(self, other: Expr) -> Product:
        return Product((*self.factors, other))

    def __truediv__(self, other: Expr) -> Quotient:
        return Quotient(self, other)


@dataclass(frozen=True, slots=True)
class Quotient:
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
class Squared:
    """The square of a quantity."""

    base: Quantity

    @property
    def value(self) -> Reals:
        return self.base.value * self.base.value

    def symbol(self) -> Node:
        return Power(self.base.symbol(), "2")

    def numbers(self) -> Node:
        return Power(self.base.numbers(), "2")

    def __mul__(self, other: Expr) -> Product:
        return Product((self, other))


@dataclass(frozen=True, slots=True)
class Times:
    """A pure number in front of an expression: 2 ω v."""

    factor: int
    body: Expr

    @property
    def value(self) -> Reals:
        return self.factor * self.body.value

    def symbol(self) -> Node:
        return Row((Txt(str(self.factor)), self.body.symbol()))

    def numbers(self) -> Node:
        return Row((Txt(f"{self.factor} × "), self.body.numbers()))


Expr = Quantity | Product | Quotient | Squared | Times


def magnitude(symbol: str, value: Reals, unit: str) -> Quantity:
    """A named quantity by its symbol in the short notation of `formula.sym`."""
    return Quantity(sym(symbol), value, unit)


def paper(letters: Node, mm: Reals) -> Quantity:
    """A length measured on paper, overlined: \\overline{pb}."""
    return Quantity(Over(letters), mm, "mm")


def worked(result: Node, expr: Expr, unit: str) -> Row:
    """symbol = formula = numbers = result with unit, from one expression."""
    end = Txt(f" = {number(float(nominal(expr.value)))} {unit}")
    same = isinstance(expr, Quantity)
    middle: tuple[Node, ...] = () if same else (Txt(" = "), expr.symbol(), Txt(" = "), expr.numbers())
    return Row((result, *middle, end))


def stated(quantity: Quantity) -> Row:
    """symbol = value with unit."""
    return Row((quantity.node, Txt(f" = {number(float(nominal(quantity.value)))} {quantity.unit}")))
