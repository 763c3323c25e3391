"""The formulas with numbers put in, at one position: x_B = 0.04 × cos 58° = 0.0212 m.

Each number is rounded once, and the lines after it go on with it as it is printed.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..algebra.formula import Frac, Node, Power, Root, Row, Txt, plain
from ..algebra.quantity import number
from .equations import Equation
from .expr import THIN, Const, Expr, Num, Product, Quotient, Sum, Var
from .functions import Arctan, Square, SquareRoot, Wave
from .keyed import ANGLES, FIGURES, is_angle, turned

_UNITS = {"x": "m", "y": "m", "s": "m", "v": "m/s", "a": "m/s^2", "ω": "rad/s", "α": "rad/s^2"}
Env = Mapping[str, float]


def worked(equation: Equation, env: Env) -> Node:
    """left = numbers = value with its unit."""
    assert isinstance(equation.left, Var)
    value = env[equation.left.symbol]
    angle = equation.left.symbol[0] in ANGLES
    told = turned(value) if angle else number(value, FIGURES)
    end = Txt(f" = {told} {'' if angle else unit(equation.left.symbol)}".rstrip())
    bare = isinstance(equation.right, (Var, Const, Num))
    if bare:
        return Row((equation.left.node, end))
    body = (_angular if angle else numbers)(equation.right, env)
    if plain(body).replace(" ", "") == told.replace("-", "−"):  # −1, which a formula gave: nothing is worked out
        return Row((equation.left.node, end))
    return Row((equation.left.node, Txt(" = "), body, end))


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
                first = not i and sign > 0 and isinstance(term, (Var, Const))  # −0.1 − (−0.0212)
                items.append((numbers if first else _guarded)(term, env))
            return Row(tuple(items))
        case Product():
            return Row(
                tuple(
                    node
                    for i, factor in enumerate(expr.printed)
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
            ratio = Frac(numbers(rise, env), numbers(run, env))
            turn = _half_turn(rise, run, env)
            principal = Row((Txt(f"arctan{THIN}"), ratio))
            return Row((principal, Txt(turn))) if turn else principal
    return Txt(number(float(np.asarray(expr.value(env))), FIGURES))


def _half_turn(rise: Expr, run: Expr, env: Env) -> str:
    """± 180° where the arctangent of the quotient, as a calculator gives it, is of the opposite quadrant."""
    up, along = (float(np.asarray(one.value(env))) for one in (rise, run))
    return "" if along >= 0 else " − 180°" if up < 0 else " + 180°"


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
    if isinstance(expr, Product) and any(is_angle(factor) for factor in expr.factors):
        return Row(
            tuple(
                node
                for i, factor in enumerate(expr.printed)
                for node in ((Txt(" × "),) if i else ()) + ((_degrees if is_angle(factor) else _guarded)(factor, env),)
            )
        )
    if isinstance(expr, (Var, Const)):
        return Txt(_turned(float(expr.value(env))))
    return numbers(expr, env)


def _degrees(expr: Expr, env: Env) -> Node:
    """An angle as a factor, a sum of angles in brackets."""
    node = _angular(expr, env)
    return Row((Txt("("), node, Txt(")"))) if isinstance(expr, Sum) else node


def _guarded(expr: Expr, env: Env) -> Node:
    """In brackets where it is a sum or a negative number."""
    node = numbers(expr, env)
    negative = isinstance(node, Txt) and node.text.startswith("−")
    turned_on = isinstance(expr, Arctan) and _half_turn(expr.rise, expr.run, env)
    return Row((Txt("("), node, Txt(")"))) if isinstance(expr, Sum) or negative or turned_on else node


def _turned(angle: float) -> str:
    text = turned(angle)
    return f"({text})" if text.startswith("−") else text
