"""The formulas with their numbers keyed into a pocket calculator as they are printed."""

from __future__ import annotations

from math import atan2, cos, degrees, pi, radians, sin, sqrt

import numpy as np

from ..algebra.rounding import as_printed, to_places
from .expr import Const, Env, Expr, Product, Quotient, Sum, Var
from .functions import Arctan, Square, SquareRoot, Wave

FIGURES = 5  # of which the lines after it leave three or four
ANGLES = ("φ", "ψ")  # symbols of what is printed in degrees


def as_told(expr: Expr, env: Env, angle: bool) -> float:
    """What a calculator shows for the expression with its numbers as they are printed, rounded as it is printed."""
    if angle:
        return radians(_degrees(_angle(expr, env)))
    return as_printed(_keyed(expr, env), FIGURES)


def turned(angle: float) -> str:
    """An angle (rad) as it is printed, in degrees between −180° and 180°."""
    return f"{_degrees(angle):.{FIGURES - 2}f}".rstrip("0").rstrip(".").replace("-", "−") + "°"


def _degrees(angle: float) -> float:
    return to_places(degrees((angle + pi) % (2 * pi) - pi), FIGURES - 2)


def size(expr: Expr, env: Env) -> float:
    """How large an expression is if nothing in it cancels: against this a result may be nothing."""
    match expr:
        case Sum(terms):
            return sum(size(term, env) for term, _ in terms)
        case Product(factors):
            return float(np.prod([size(factor, env) for factor in factors]))
        case Quotient(num, den):
            below = abs(float(np.asarray(den.value(env))))
            return size(num, env) / below if below else 0.0
    return abs(float(np.asarray(expr.value(env))))


def is_angle(expr: Expr) -> bool:
    """Whether it is printed in degrees."""
    match expr:
        case Sum(terms):
            return all(is_angle(term) for term, _ in terms)
        case Var(symbol):
            return symbol[0] in ANGLES
        case Const(unit=unit):
            return unit == "rad"
    return False


def _keyed(expr: Expr, env: Env) -> float:
    match expr:
        case Sum(terms):
            return sum(sign * _keyed(term, env) for term, sign in terms)
        case Product(factors):
            return float(np.prod([_keyed(factor, env) for factor in factors]))
        case Quotient(num, den):
            below = _keyed(den, env)
            return _keyed(num, env) / below if below else float("nan")
        case Square(body):
            return _keyed(body, env) ** 2
        case SquareRoot(body):
            return sqrt(max(0.0, _keyed(body, env)))
        case Wave(name, angle):
            turn = radians(_degrees(float(np.asarray(angle.value(env)))))
            return cos(turn) if name == "cos" else sin(turn)
        case Arctan(rise, run):
            return atan2(_keyed(rise, env), _keyed(run, env))
    return as_printed(float(np.asarray(expr.value(env))), FIGURES)


def _angle(expr: Expr, env: Env) -> float:
    match expr:
        case Sum(terms):
            return sum(sign * _angle(term, env) for term, sign in terms)
        case Product(factors) if any(is_angle(factor) for factor in factors):
            return float(np.prod([(_angle if is_angle(one) else _keyed)(one, env) for one in factors]))
        case Var() | Const():
            return radians(_degrees(float(np.asarray(expr.value(env)))))
    return _keyed(expr, env)
