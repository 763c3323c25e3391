"""Lines that are worked out, symbol = formula = numbers = result: who keys in the numbers printed gets the result.

A result has four figures. What it is worked out from has as many, and guard figures where four would give another
result: 1063.6 × 0.076 = 80.83, for 1064 × 0.076 is 80.86.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from math import isfinite, nan
from typing import cast

import numpy as np

from ..foundation.slotted import replace
from ..plane import nominal
from .formula import Node, Row, Txt, plain
from .quantity import FIGURES, Expr, Of, Powered, Product, Quantity, Quotient, Rooted, Sum, Times, number
from .rounding import WHOLE, as_printed, guarded, half_unit, read_back, rounds_to, to_figures

_END = 2  # parts with which a line ends: its numbers, and = result


def worked(result: Node, expr: Expr, unit: str, shown: str = "") -> Row:
    """symbol = formula = numbers = result with unit, from one expression; shown: the result's number as printed."""
    value = float(nominal(expr.value))
    end = Txt(f" = {_with_unit(shown or number(value), unit)}")
    if isinstance(expr, Quantity):
        return Row((result, end))
    formula = expr.symbol()
    if _is_lone(expr):
        return Row((result, Txt(" = "), formula, end), expr)
    said = () if isinstance(expr, Quotient) and _bare(formula) == _bare(result) else (Txt(" = "), formula)
    return Row((result, *said, Txt(" = "), keyed_in(expr, shown), end), expr)


def _is_lone(expr: Expr) -> bool:
    """Whether it is one quantity under another name, whose number is the result: J_e = J_1 = 0.2 kg·m²."""
    return isinstance(expr, Product) and len(expr.factors) == 1 and isinstance(expr.factors[0], Quantity)


def _bare(node: Node) -> str:
    """What it says, as one fraction or in one line: a ratio that is called what it is needs no formula."""
    return plain(node).translate(_BRACKETS)


_BRACKETS = {ord(sign): None for sign in "()"}


def told_again(line: Row, end: Txt, shown: str, told: Callable[[Node, float], str]) -> Row:
    """The line with another end, of which `shown` is the number; told: how a symbol's value is printed elsewhere.

    Its numbers are those with which a reader gets this end: as they are told elsewhere, or with guard figures.
    """
    expr, digits = _as_told(line, shown, told)
    if _is_lone(expr):
        return Row((*line.items[:-1], end))
    return Row((*line.items[:-_END], expr.numbers(digits), end))


def numbers_of(line: Row, shown: str, told: Callable[[Node, float], str]) -> Iterator[tuple[Node, float, str]]:
    """The quantities of the line that `told_again` gives: symbol, value, number without sign and brackets."""
    expr, digits = _as_told(line, shown, told)
    for one in _quantities(expr):
        yield one.node, float(nominal(one.value)), plain(one.numbers(digits)).strip("()−°")


def _as_told(line: Row, shown: str, told: Callable[[Node, float], str]) -> tuple[Expr, int]:
    """The line's expression with the numbers told elsewhere, unless they give another end; and how many figures the
    other numbers have."""
    own = cast("Expr", line.worked)
    for other in _told_elsewhere(own, told):
        digits = figures_for(other, shown)
        if _gives(other, digits, (read_back(shown),)):
            return other, digits
    return own, figures_for(own, shown)


def _told_elsewhere(own: Expr, told: Callable[[Node, float], str]) -> Iterator[Expr]:
    """The expression with the numbers that are told elsewhere; then with all but one of them, for another line may have
    needed that to more figures."""
    known = dict.fromkeys(one.node for one in _quantities(own) if told(one.node, float(nominal(one.value))))
    if known:
        yield _with_told(own, told)
    for left in known if len(known) > 1 else ():
        yield _with_told(own, told, left)


def _with_told(own: Expr, told: Callable[[Node, float], str], left: Node | None = None) -> Expr:
    """The expression with the numbers that are told elsewhere, but for that of one symbol."""

    def number_of(one: Quantity) -> str:
        return "" if one.node == left else told(one.node, float(nominal(one.value)))

    return _each(own, lambda one: replace(one, told=number_of(one) or one.told))


def goes_on(
    line: Row, shown: str, told: Callable[[Node, float], str], needs: Callable[[Node], bool] = lambda _: False
) -> bool:
    """Whether the line gives this end with the numbers that are told elsewhere, those that it needs among them; so does
    one that goes on with none."""
    own = cast("Expr", line.worked)
    known = [one.node for one in _quantities(own) if told(one.node, float(nominal(one.value)))]
    chosen = _as_told(line, shown, told)[0]
    with_them = all(one.told for one in _quantities(chosen) if one.node in known and needs(one.node))
    return (chosen is not own and with_them) or not known


def reckoned_again(line: Row, told: Callable[[Node, float], str], figures: int = FIGURES) -> float:
    """What a calculator shows for the line with the numbers that are told elsewhere, the others to their figures."""
    own = cast("Expr", line.worked)
    return _reckoned(_with_told(own, told), figures)


def stated(quantity: Quantity) -> Row:
    """symbol = value with unit."""
    return Row((quantity.node, Txt(f" = {_with_unit(number(float(nominal(quantity.value))), quantity.unit)}")))


def keyed_in(expr: Expr, shown: str = "") -> Node:
    """The expression's numbers, with the guard figures that its result needs."""
    return expr.numbers(figures_for(expr, shown))


def figures_for(expr: Expr, shown: str = "", least: int = FIGURES) -> int:
    """So many figures of its numbers that a reader who keys them in gets the result as it is printed (`shown`)."""
    told: tuple[tuple[float, float], ...]
    if any(map(str.isdigit, shown)):
        told = (read_back(shown),)
    elif isfinite(value := _by_one(expr)):
        told = tuple(_results(value))
    else:
        return least
    return guarded(least, lambda digits: _gives(expr, digits, told))


def _by_one(expr: Expr) -> float:
    """The value by the nominal hand alone; not finite where it divides by nothing."""
    with np.errstate(all="ignore"):
        return float(nominal(expr.reckoned(lambda one: np.float64(nominal(one.value)))))


def _gives(expr: Expr, digits: int, told: Iterable[tuple[float, float]]) -> bool:
    """Whether they give every one of these results: what is reckoned rounds to it, from midway to the even figure."""
    reckoned = _reckoned(expr, digits)
    return all(rounds_to(reckoned, result, half) for result, half in told)


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
        return float(nominal(expr.reckoned(lambda one: _printed(one, digits))))
    except ZeroDivisionError:  # two printed numbers may be one, where those that are printed differ
        return nan


def _each(expr: Expr, made: Callable[[Quantity], Quantity]) -> Expr:
    """The expression of what is made of each of its quantities."""
    match expr:
        case Quantity():
            return made(expr)
        case Product(factors):
            return Product(tuple(_each(factor, made) for factor in factors))
        case Quotient(num, den):
            return Quotient(_each(num, made), _each(den, made))
        case Sum(terms, signs):
            return Sum(tuple(_each(term, made) for term in terms), signs)
        case Powered(base, exponent):
            return Powered(made(base), exponent)
        case Times(factor, body):
            return Times(factor, _each(body, made))
        case Of(name, angle):
            return Of(name, _each(angle, made))
        case Rooted(body):
            return Rooted(_each(body, made))


def _quantities(expr: Expr) -> list[Quantity]:
    """Every quantity in it."""
    found: list[Quantity] = []

    def noted(one: Quantity) -> Quantity:
        found.append(one)
        return one

    _each(expr, noted)
    return found


def size_of(line: Row) -> float:
    """What a line that is worked out comes to, without its sign."""
    return abs(_by_one(cast("Expr", line.worked)))


def sizes_in(line: Row) -> Iterator[tuple[Node, float]]:
    """The quantities that a line goes on with: symbol, and value without its sign."""
    for one in _quantities(cast("Expr", line.worked)):
        yield one.node, abs(float(nominal(one.value)))


def scale_of(line: Row) -> float | None:
    """The scale before the lengths of a line such as l = μ_l AB; None of a line that begins with no such factor."""
    own = line.worked.terms[0] if isinstance(line.worked, Sum) and len(line.worked.terms) == 1 else line.worked
    factors: tuple[Expr, ...] = own.factors if isinstance(own, Product) else ()
    return abs(float(nominal(factors[0].value))) if factors and isinstance(factors[0], Quantity) else None


def _printed(quantity: Quantity, digits: int) -> float:
    """Its value as it is printed to so many figures."""
    if quantity.told:
        return read_back(quantity.told)[0]
    return as_printed(float(nominal(quantity.value)), quantity.figures(digits))


def _with_unit(text: str, unit: str) -> str:
    return f"{text}°" if unit == "deg" else f"{text} {unit}".rstrip()
