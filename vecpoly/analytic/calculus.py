"""Derivatives of expressions, and expressions with some of their variables told by others."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from .expr import ONE, TWO, ZERO, Const, Expr, Num, Product, Sum, Var, product, total
from .functions import Square, Wave, cos, sin


def substituted(expr: Expr, by: Mapping[str, Expr]) -> Expr:
    """The expression with these variables replaced, again and again until none is left.
    Sums, products, squares, cos and sin only."""
    match expr:
        case Var(symbol):
            return substituted(by[symbol], by) if symbol in by else expr
        case Sum(terms):
            return total(*((substituted(term, by), sign) for term, sign in terms))
        case Product(factors):
            return product(*(substituted(factor, by) for factor in factors))
        case Square(body):
            return Square(substituted(body, by))
        case Wave(name, angle):
            return (cos if name == "cos" else sin)(substituted(angle, by))
        case _:
            return expr


def derivative(expr: Expr, symbol: str) -> Expr:
    """∂/∂symbol. Raises TypeError for roots, quotients and arctangents, which loop equations do not hold."""
    match expr:
        case Var(own):
            return ONE if own == symbol else ZERO
        case Const() | Num():
            return ZERO
        case Sum(terms):
            return total(*((derivative(term, symbol), sign) for term, sign in terms))
        case Product(factors):
            return total(
                *(
                    (product(*factors[:i], derivative(factor, symbol), *factors[i + 1 :]), 1)
                    for i, factor in enumerate(factors)
                )
            )
        case Square(body):
            return product(TWO, body, derivative(body, symbol))
        case Wave(name, angle):
            inner = derivative(angle, symbol)
            return -product(sin(angle), inner) if name == "cos" else product(cos(angle), inner)
    raise TypeError(f"no derivative of {type(expr).__name__} on file")


def variables(expr: Expr) -> Iterator[str]:
    """The symbols of all variables in it."""
    if isinstance(expr, Var):
        yield expr.symbol
    for part in expr.parts():
        yield from variables(part)
