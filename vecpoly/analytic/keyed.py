"""The formulas with their numbers keyed into a pocket calculator as they are printed."""

from __future__ import annotations

from math import atan2, cos, degrees, isfinite, pi, radians, sin, sqrt

import numpy as np

from ..algebra.rounding import as_printed, guarded, half_unit, rounds_to, to_places
from .expr import Const, Env, Expr, Product, Quotient, Sum, Var
from .functions import Arctan, Square, SquareRoot, Wave

FIGURES = 5
ANGLES = ("φ", "ψ")  # symbols of what is printed in degrees
_NOTHING = 1e-6  # what a calculator may show for zero where all terms are


def figures_for(expr: Expr, env: Env, value: float, angle: bool) -> int:
    """So many figures (two less: decimals of a degree) of its numbers that they give the result as printed."""
    if not isfinite(value):
        return FIGURES
    result, half = _result(value, angle, size(expr, env))

    def holds(digits: int) -> bool:
        gap = (_angle if angle else _keyed)(expr, env, digits) - result
        return rounds_to(result + ((gap + pi) % (2 * pi) - pi if angle else gap), result, half)

    return guarded(FIGURES, holds)


def turned(angle: float, digits: int = FIGURES) -> str:
    """An angle (rad) as it is printed, in degrees between −180° and 180°."""
    return f"{_degrees(angle, digits):.{digits - 2}f}".rstrip("0").rstrip(".").replace("-", "−") + "°"


def _degrees(angle: float, digits: int) -> float:
    return to_places(degrees((angle + pi) % (2 * pi) - pi), digits - 2)


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


def _result(value: float, angle: bool, terms: float) -> tuple[float, float]:
    """The result as printed, and half a unit of its last place; of zero: of the last place of its terms."""
    if angle:
        return radians(_degrees(value, FIGURES)), radians(0.5 * 10.0 ** (2 - FIGURES))
    if not value:
        return 0.0, half_unit(terms, FIGURES) if terms else _NOTHING
    return as_printed(value, FIGURES), half_unit(value, FIGURES)


def _keyed(expr: Expr, env: Env, digits: int) -> float:
    match expr:
        case Sum(terms):
            return sum(sign * _keyed(term, env, digits) for term, sign in terms)
        case Product(factors):
            return float(np.prod([_keyed(factor, env, digits) for factor in factors]))
        case Quotient(num, den):
            below = _keyed(den, env, digits)
            return _keyed(num, env, digits) / below if below else float("nan")
        case Square(body):
            return _keyed(body, env, digits) ** 2
        case SquareRoot(body):
            return sqrt(max(0.0, _keyed(body, env, digits)))
        case Wave(name, angle):
            turn = radians(_degrees(float(np.asarray(angle.value(env))), digits))
            return cos(turn) if name == "cos" else sin(turn)
        case Arctan(rise, run):
            return atan2(_keyed(rise, env, digits), _keyed(run, env, digits))
    return as_printed(float(np.asarray(expr.value(env))), digits)


def _angle(expr: Expr, env: Env, digits: int) -> float:
    match expr:
        case Sum(terms):
            return sum(sign * _angle(term, env, digits) for term, sign in terms)
        case Product(factors) if any(is_angle(factor) for factor in factors):
            return float(np.prod([(_angle if is_angle(one) else _keyed)(one, env, digits) for one in factors]))
        case Var() | Const():
            return radians(_degrees(float(np.asarray(expr.value(env))), digits))
    return _keyed(expr, env, digits)
