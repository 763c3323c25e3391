"""Lines that are worked out, symbol = formula = numbers = result: who keys in the numbers printed gets the result.

A result has four figures. What it is worked out from has as many, and guard figures where four would give another
result: 1063.6 × 0.076 = 80.83, for 1064 × 0.076 is 80.86.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite, nan

from ..foundation.slotted import replace
from ..plane import nominal
from .formula import Node, Row, Txt
from .quantity import FIGURES, Expr, Of, Powered, Product, Quantity, Quotient, Rooted, Sum, Times, number
from .rounding import TIES, WHOLE, as_printed, guarded, half_unit, read_back, to_figures


def worked(result: Node, expr: Expr, unit: str, shown: str = "") -> Row:
    """symbol = formula = numbers = result with unit, from one expression; shown: the result's number as printed."""
    value = float(nominal(expr.value))
    end = Txt(f" = {_with_unit(shown or number(value), unit)}")
    if isinstance(expr, Quantity):
        return Row((result, end))
    return Row((result, Txt(" = "), expr.symbol(), Txt(" = "), keyed_in(expr, shown), end))


def stated(quantity: Quantity) -> Row:
    """symbol = value with unit."""
    return Row((quantity.node, Txt(f" = {_with_unit(number(float(nominal(quantity.value))), quantity.unit)}")))


def keyed_in(expr: Expr, shown: str = "") -> Node:
    """The expression's numbers, with the guard figures that its result needs."""
    return expr.numbers(figures_for(expr, shown))


def figures_for(expr: Expr, shown: str = "", least: int = FIGURES) -> int:
    """So many figures of its numbers that a reader who keys them in gets the result as it is printed (`shown`)."""
    value = float(nominal(expr.value))
    if not isfinite(value):
        return least
    told = (read_back(shown),) if shown else tuple(_results(value))

    def holds(digits: int) -> bool:
        reckoned = _reckoned(expr, digits)
        return all(abs(reckoned - result) <= half * TIES for result, half in told)

    return guarded(least, holds)


def _results(value: float) -> Iterator[tuple[float, float]]:
    """The result to all its figures and to fewer, as an answer is told to what was read, each with half a unit."""
    if not value:
        yield 0.0, 0.0
        return
    last = half_unit(value, FIGURES)
    yield as_printed(value, FIGURES), min(0.5, last) if abs(value) < 10.0**WHOLE else last
    for figures in range(1, FIGURES):
        yield to_figures(value, figures), half_unit(value, figures)


def spot_in_mm(at: complex) -> str:
    """The coordinates of a point (m) as they are printed, in mm: (96.3, 238.2) mm."""
    x, y = (number(round(1e3 * part, 9), 5) for part in (at.real, at.imag))
    return f"({x}, {y}) mm"


def _reckoned(expr: Expr, digits: int) -> float:
    """What a calculator shows for the expression with its numbers printed to so many figures; NaN: an error."""
    try:
        return float(nominal(_printed(expr, digits).value))
    except ZeroDivisionError:  # two printed numbers may be one, where those that are printed differ
        return nan


def _printed(expr: Expr, digits: int) -> Expr:
    """The expression of the numbers as they are printed."""
    match expr:
        case Quantity():
            return _rounded(expr, digits)
        case Product(factors):
            return Product(tuple(_printed(factor, digits) for factor in factors))
        case Quotient(num, den):
            return Quotient(_printed(num, digits), _printed(den, digits))
        case Sum(terms, signs):
            return Sum(tuple(_printed(term, digits) for term in terms), signs)
        case Powered(base, exponent):
            return Powered(_rounded(base, digits), exponent)
        case Times(factor, body):
            return Times(factor, _printed(body, digits))
        case Of(name, angle):
            return Of(name, _printed(angle, digits))
        case Rooted(body):
            return Rooted(_printed(body, digits))


def _rounded(quantity: Quantity, digits: int) -> Quantity:
    return replace(quantity, value=as_printed(float(nominal(quantity.value)), quantity.figures(digits)))


def _with_unit(text: str, unit: str) -> str:
    return f"{text}°" if unit == "deg" else f"{text} {unit}".rstrip()
