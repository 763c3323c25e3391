"""The formulas with numbers put in, at one position: x_B = 0.04 × cos 58° = 0.0212 m."""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees, pi

import numpy as np

from ..algebra.formula import Frac, Node, Power, Root, Row, Txt
from ..algebra.quantity import number
from .equations import Equation
from .expr import THIN, Const, Expr, Num, Product, Quotient, Sum, Var
from .functions import Arctan, Square, SquareRoot, Wave

_UNITS = {"x": "m", "y": "m", "s": "m", "v": "m/s", "a": "m/s^2", "ω": "rad/s", "α": "rad/s^2"}
_ANGLES = ("φ", "ψ")
_DIGITS = 5
Env = Mapping[str, float]


def worked(equation: Equation, env: Env) -> Node:
    """left = numbers = value with its unit."""
    assert isinstance(equation.left, Var)
    value = env[equation.left.symbol]
    angle = equation.left.symbol[0] in _ANGLES
    end = (
        Txt(f" = {_degrees(value)}")
        if angle
        else Txt(f" = {number(value, _DIGITS)} {unit(equation.left.symbol)}".rstrip())
    )
    bare = isinstance(equation.right, (Var, Const, Num))
    body = _angular(equation.right, env) if angle else numbers(equation.right, env)
    return Row((equation.left.node, end)) if bare else Row((equation.left.node, Txt(" = "), body, end))


def unit(symbol: str) -> str:
    """The SI unit of a variable of the model; nothing for an auxiliary one."""
    return _UNITS.get(symbol[0], "")


def numbers(expr: Expr, env: Env) -> Node:
    """The expression with the values of all it holds (SI, angles in degrees)."""
    match expr:
        case Sum(terms):
            items: list[Node] = []
            for i, (term, sign) in enumerate(terms):
                items += [Txt(" + " if sign > 0 else " − ")] if i else [Txt("−")] if sign < 0 else []
                items.append(_guarded(term, env))
            return Row(tuple(items))
        case Product(factors):
            return Row(
                tuple(
                    node
                    for i, factor in enumerate(factors)
                    for node in ((Txt(" × "),) if i else ()) + (_guarded(factor, env),)
                )
            )
        case Quotient(num, den):
            return Frac(numbers(num, env), numbers(den, env))
        case Square(body):
            inner = numbers(body, env)
            return Power(
                inner
                if isinstance(inner, Txt) and not inner.text.startswith("−")
                else Row((Txt("("), inner, Txt(")"))),
                "2",
            )
        case SquareRoot(body):
            return Root(numbers(body, env))
        case Wave(name, angle):
            return Row((Txt(f"{name}{THIN}"), Txt(_turned(float(angle.value(env))))))
        case Arctan(rise, run):
            return Row((Txt(f"arctan{THIN}"), Frac(numbers(rise, env), numbers(run, env))))
    return Txt(number(float(np.asarray(expr.value(env))), _DIGITS))


def _angular(expr: Expr, env: Env) -> Node:
    """A sum of angles, each in degrees where it is a mere angle."""
    if isinstance(expr, Sum):
        return Row(
            tuple(
                node
                for i, (term, sign) in enumerate(expr.terms)
                for node in ((Txt(" + " if sign > 0 else " − "),) if i else (Txt("−"),) if sign < 0 else ())
                + (_angular(term, env),)
            )
        )
    if isinstance(expr, (Var, Const)):
        return Txt(_turned(float(expr.value(env))))
    return numbers(expr, env)


def _guarded(expr: Expr, env: Env) -> Node:
    """In brackets where it is a sum or a negative number."""
    node = numbers(expr, env)
    negative = isinstance(node, Txt) and node.text.startswith("−")
    return Row((Txt("("), node, Txt(")"))) if isinstance(expr, Sum) or negative else node


def _turned(angle: float) -> str:
    text = _degrees(angle)
    return f"({text})" if text.startswith("−") else text


def _degrees(angle: float) -> str:
    return f"{degrees((angle + pi) % (2 * pi) - pi):.3f}".rstrip("0").rstrip(".").replace("-", "−") + "°"
