"""Which lines tell a length that was read on paper: l = μ_l AB, l = μ_l (AC_2 − AC_1)/2, v = μ_v pb."""

from __future__ import annotations

from collections.abc import Iterator
from typing import cast

from ..algebra.formula import Frac, Node, Over, Row, Sym
from ..algebra.quantity import Expr, Of, Powered, Product, Quantity, Quotient, Rooted, Sum, Times
from ..plane import nominal

_FORMULA, _PARTS = 2, 4  # of a line symbol = formula = numbers = result


def is_length(line: Row) -> bool:
    """Whether it has nothing but one scale and lengths on paper, and is no ratio of those."""
    if len(line.items) <= _PARTS:
        return False
    above = list(_leaves(line.items[_FORMULA], below=False))
    scales, lengths = (sum(isinstance(one, kind) for one in above) for kind in (Sym, Over))
    return scales == 1 and lengths > 0 and not any(_leaves(line.items[_FORMULA], below=True))


def only_length(line: Row) -> float | None:
    """The length on paper (mm) to which the line's result is proportional; None where there is none, or more."""
    found = list(_over(cast("Expr", line.worked), 1)) if line.worked is not None else []
    return abs(float(nominal(found[0][0].value))) if len(found) == 1 and found[0][1] == 1 else None


def _over(expr: Expr, power: int) -> Iterator[tuple[Quantity, int]]:
    """The lengths on paper in an expression, each with its power; those in sums and functions with none."""
    match expr:
        case Quantity(node=Over()):
            yield expr, power
        case Quantity():
            return
        case Product(factors):
            for factor in factors:
                yield from _over(factor, power)
        case Quotient(num, den):
            yield from _over(num, power)
            yield from _over(den, -power)
        case Sum(terms):
            for term in terms:
                yield from _over(term, power if len(terms) == 1 else 0)
        case Powered(base, exponent):
            yield from _over(base, power * exponent)
        case Times(_, body):
            yield from _over(body, power)
        case Of(_, angle):
            yield from _over(angle, 0)
        case Rooted(body):
            yield from _over(body, 0)


def _leaves(node: Node, *, below: bool) -> Iterator[Node]:
    """The symbols and lengths of a formula above, or below, its fraction bars; powers and roots are no lengths."""
    match node:
        case Row(items):
            for one in items:
                yield from _leaves(one, below=below)
        case Frac(num, den):
            if below:
                yield from _leaves(den, below=False)
            yield from _leaves(num, below=below)
        case Sym() | Over() if not below:
            yield node
        case _:
            pass
