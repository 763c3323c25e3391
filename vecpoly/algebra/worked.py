"""Lines that are worked out, symbol = formula = numbers = result: who keys in the numbers printed gets the result.

A result has four figures. What it is worked out from has as many, and guard figures where four would give another
result: 1063.6 × 0.076 = 80.83, for 1064 × 0.076 is 80.86.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import floor, isfinite, log10, nan

from ..foundation.slotted import replace
from ..plane import nominal
from .formula import Node, Row, Txt
from .quantity import FIGURES, Expr, Of, Powered, Product, Quantity, Quotient, Rooted, Sum, Times, number
from .rounding import to_figures

_MOST = 10  # figures of a number in a line, at most
_WHOLE = 6  # numbers of fewer figures are told whole
_TIES = 1e-6  # share of half a unit: a result may lie midway


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
    told = ((_read(shown), _half_unit(shown)),) if shown else tuple(_results(value))
    for digits in range(least, _MOST + 1):
        reckoned = _as_printed(expr, digits)
        if all(abs(reckoned - result) <= half * (1.0 + _TIES) for result, half in told):
            return digits
    return least


def _results(value: float) -> Iterator[tuple[float, float]]:
    """The result to all its figures and to fewer, as an answer is told to what was read, each with half a unit."""
    yield _read(number(value)), _half_figure(value, FIGURES)
    for figures in range(1, FIGURES):
        yield to_figures(value, figures), _half_figure(value, figures)


def spot_in_mm(at: complex) -> str:
    """The coordinates of a point (m) as they are printed, in mm: (96.3, 238.2) mm."""
    x, y = (number(round(1e3 * part, 9), 5) for part in (at.real, at.imag))
    return f"({x}, {y}) mm"


def _as_printed(expr: Expr, digits: int) -> float:
    """What a calculator shows for the expression with its numbers printed to so many figures; NaN: an error."""
    try:
        return float(nominal(_printed(expr, digits).value))
    except ZeroDivisionError:  # two printed numbers may be one, where those that are printed differ
        return nan


def _printed(expr: Expr, digits: int) -> Expr:
    """The expression of the numbers as they are printed."""
    match expr:
        case Quantity():
            return replace(expr, value=_read(number(float(nominal(expr.value)), digits)))
        case Product(factors):
            return Product(tuple(_printed(factor, digits) for factor in factors))
        case Quotient(num, den):
            return Quotient(_printed(num, digits), _printed(den, digits))
        case Sum(terms, signs):
            return Sum(tuple(_printed(term, digits) for term in terms), signs)
        case Powered(base, exponent):
            return Powered(replace(base, value=_read(number(float(nominal(base.value)), digits))), exponent)
        case Times(factor, body):
            return Times(factor, _printed(body, digits))
        case Of(name, angle):
            return Of(name, _printed(angle, digits))
        case Rooted(body):
            return Rooted(_printed(body, digits))


def _parts(text: str) -> tuple[str, int]:
    """Mantissa and exponent of a number as `number` writes it."""
    mantissa, _, exponent = text.replace("−", "-").rstrip("}").partition("×10^{")
    return mantissa, int(exponent or 0)


def _read(text: str) -> float:
    mantissa, exponent = _parts(text)
    return float(f"{mantissa}e{exponent}")


def _half_unit(text: str) -> float:
    """Half a unit of the last place that is printed."""
    mantissa, exponent = _parts(text)
    return 0.5 * 10.0 ** (exponent - len(mantissa.partition(".")[2]))


def _half_figure(value: float, figures: int) -> float:
    """Half a unit of the last of so many figures; of a number told whole half of one."""
    if not value:
        return 0.0
    top = floor(log10(abs(value)))
    last = top + 1 - figures
    return 0.5 * 10.0 ** (min(0, last) if figures == FIGURES and top < _WHOLE else last)


def _with_unit(text: str, unit: str) -> str:
    return f"{text}°" if unit == "deg" else f"{text} {unit}".rstrip()
