"""One scale, one unit: where μ_l is stated in m/mm, the lines of lengths in mm have that number too, 0.04 × 49.2 =
1.968 m = 1968 mm."""

from __future__ import annotations

from collections.abc import Container
from decimal import Decimal

from ..algebra.formula import Frac, Node, Row, Txt
from ..algebra.quantity import Product, Quantity, Quotient, Sum
from .told import ABOUT, EQUALS, NUMBER

_NUMBERS, _PARTS = -2, 5  # of a line symbol = formula = numbers = result
_IN_MM, _MILLI = "mm/mm", -3


def in_metres(line: Row, own: Row, scales: Container[Node]) -> Row:
    """The line as it is printed, with the scale in m/mm and the result in metres before that in mm; one that does not
    begin with such a scale, or whose result is no length in mm, as it is. own: as it was worked out."""
    first, end = _first(own.worked), line.items[-1]
    if first is None or first.node not in scales or first.unit != _IN_MM or not isinstance(end, Txt):
        return line
    ends = end.text.split(EQUALS)
    if len(line.items) < _PARTS or len(ends) != 2 or not ends[1].endswith(" mm"):
        return line
    result, numbers = ends[1].partition(ABOUT)[0].removesuffix(" mm"), _shifted(line.items[_NUMBERS])
    if numbers is None or NUMBER.fullmatch(result) is None or "×" in result or not float(result.lstrip("−")):
        return line
    told = end.text.partition(ABOUT)[2]  # of what later lines go on with to more figures: 0.04698 m ≈ 47.0 mm
    last = f"{ABOUT}{told}" if told else end.text
    return Row((*line.items[:_NUMBERS], numbers, Txt(f"{EQUALS}{_by_milli(result)} m{last}")))


def _first(expr: object) -> Quantity | None:
    """The first factor of a product, above a fraction bar too."""
    match expr:
        case Quantity():
            return expr
        case Product(factors):
            return _first(factors[0])
        case Quotient(num, _):
            return _first(num)
        case Sum(terms) if len(terms) == 1:
            return _first(terms[0])
        case _:
            return None


def _shifted(node: Node) -> Node | None:
    """The numbers of the line, the first of them in metres; None where it is not found."""
    match node:
        case Txt(text) if (found := NUMBER.search(text)) is not None and "×10" not in found[0]:
            scale = _by_milli(found[0])
            return Txt(text[: found.start()] + (scale.rstrip("0") if "." in scale else scale) + text[found.end() :])
        case Row((Txt("−") as minus, *rest)) if (shifted := _shifted(Row(tuple(rest)))) is not None:
            return Row((minus, shifted))
        case Row(items) if items and (first := _shifted(items[0])) is not None:
            return Row((first, *items[1:]))
        case Frac(num, den) if (first := _shifted(num)) is not None:
            return Frac(first, den)
        case _:
            return None


def _by_milli(number: str) -> str:
    """A thousandth of a number that is printed so, with as many figures."""
    return f"{Decimal(number.replace('−', '-')).scaleb(_MILLI):f}".replace("-", "−")
