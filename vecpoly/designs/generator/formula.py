"""A function y = f(x) as it is written: `log10(x)`, `x^1.5`; read once, evaluated over numbers or arrays."""

from __future__ import annotations

import ast
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from math import e, pi
from typing import Annotated, Any, TypeVar

import numpy as np
import numpy.typing as npt
from pydantic import BeforeValidator, WithJsonSchema

from ...errors import FaultError
from ...units.reading import Quantity, pure
from ...words import Words

Value = TypeVar("Value", float, float | npt.NDArray[np.float64])
LONGEST = 80  # letters of a formula
_KNOWN: dict[str, Callable[..., Any]] = {
    "sqrt": np.sqrt,
    "exp": np.exp,
    "ln": np.log,
    "log10": np.log10,
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
}
_NUMBERS = {"pi": pi, "e": e}
_OPERATIONS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: np.add,
    ast.Sub: np.subtract,
    ast.Mult: np.multiply,
    ast.Div: np.divide,
    ast.Pow: np.float_power,
}


@dataclass(frozen=True, slots=True)
class Formula:
    """A function of x, as it was written."""

    text: str

    def __str__(self) -> str:
        return self.text

    def __call__(self, x: Value) -> Value:
        """f(x); NaN or ∞ where it has no value."""
        with np.errstate(all="ignore"):
            found: Value = _value(_tree(self.text), np.asarray(x, dtype=float))[()]
        return found


@cache
def _tree(text: str) -> ast.expr:
    """The formula as Python reads it."""
    return ast.parse(text.replace("^", "**"), mode="eval").body


def _value(node: ast.expr, x: Any) -> Any:
    match node:
        case ast.Constant(value=int() | float() as value):
            return np.float64(value)
        case ast.Name(id="x"):
            return x
        case ast.Name(id=name) if name in _NUMBERS:
            return np.float64(_NUMBERS[name])
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_value(operand, x)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATIONS:
            return _OPERATIONS[type(op)](_value(left, x), _value(right, x))
        case ast.Call(func=ast.Name(id=name), args=[one], keywords=[]) if name in _KNOWN:
            return _KNOWN[name](_value(one, x))
        case _:
            raise ValueError(ast.unparse(node))


def _formula(written: Any) -> Formula:
    if isinstance(written, Formula):
        return written
    text = str(written).strip()
    try:
        if len(text) > LONGEST:
            raise ValueError(text)
        found = Formula(text)
        found(1.0)
    except (ValueError, SyntaxError, RecursionError, MemoryError) as error:
        raise FaultError(
            Words(
                f"“{text[:LONGEST]}”不是 x 的函数式；如写 log10(x)、x^1.5、sin(x)，可用 {'、'.join(_KNOWN)}",
                f"'{text[:LONGEST]}' is no formula in x; write e.g. log10(x), x^1.5 or sin(x); known are "
                f"{', '.join(_KNOWN)}",
            ),
            code="spelling",
        ) from error
    return found


Function = Annotated[Formula, BeforeValidator(_formula), WithJsonSchema({"type": "string"})]


def _number(written: Any) -> Quantity:
    """A pure number, of either sign."""
    return written if isinstance(written, Quantity) else Quantity(pure(written, "1.5"), str(written))


Number = Annotated[Quantity, BeforeValidator(_number), WithJsonSchema({"type": ["string", "number"]})]
