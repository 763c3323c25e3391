"""A number that knows how it was computed:
a term of + − × ÷, elementary functions and cases, over variables and constants.

A recorded drawing starts from such numbers (`variable`); arithmetic, numpy's elementwise functions and `np.where`
go on with them. What they cannot follow (turning one into a plain `float`, a choice made by `if`) gives a number that
is constant from there on. Ordinary drawings contain none, and pay nothing for them.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from .traced import Traced

_UFUNCS: Mapping[Any, str] = {
    np.add: "+",
    np.subtract: "-",
    np.multiply: "*",
    np.divide: "/",
    np.power: "pow",
    np.negative: "neg",
    np.conjugate: "conj",
    np.absolute: "abs",
    np.exp: "exp",
    np.sqrt: "sqrt",
    np.square: "square",
    np.sign: "sign",
    np.sin: "sin",
    np.cos: "cos",
    np.tan: "tan",
    np.arcsin: "asin",
    np.arccos: "acos",
    np.arctan2: "atan2",
    np.less: "<",
    np.less_equal: "<=",
    np.greater: ">",
    np.greater_equal: ">=",
    np.equal: "==",
    np.maximum: "max",
    np.minimum: "min",
    np.radians: "radians",
    np.degrees: "degrees",
}


class Derived:
    """A number, complex number or truth value, the operation that gave it, and what it was given."""

    __slots__ = ("args", "op", "value")
    __hash__ = None  # type: ignore[assignment]  # like an array

    def __init__(self, value: Any, op: str, *args: Any) -> None:
        self.value = value
        self.op = op
        self.args = args

    def __repr__(self) -> str:
        return f"{self.value!r} by {self.op}"

    # -- arithmetic -------------------------------------------------------------------------------------------

    def __add__(self, other: Any) -> Any:
        return _two("+", self, other)

    def __radd__(self, other: Any) -> Any:
        return _two("+", other, self)

    def __sub__(self, other: Any) -> Any:
        return _two("-", self, other)

    def __rsub__(self, other: Any) -> Any:
        return _two("-", other, self)

    def __mul__(self, other: Any) -> Any:
        return _two("*", self, other)

    def __rmul__(self, other: Any) -> Any:
        return _two("*", other, self)

    def __truediv__(self, other: Any) -> Any:
        return _two("/", self, other)

    def __rtruediv__(self, other: Any) -> Any:
        return _two("/", other, self)

    def __pow__(self, power: Any) -> Any:
        return _two("pow", self, power)

    def __mod__(self, other: Any) -> Any:
        return plain(self) % plain(other)

    def __neg__(self) -> Derived:
        return Derived(-self.value, "neg", self)

    def __abs__(self) -> Derived:
        return Derived(abs(self.value), "abs", self)

    def __lt__(self, other: Any) -> Any:
        return _two("<", self, other)

    def __le__(self, other: Any) -> Any:
        return _two("<=", self, other)

    def __gt__(self, other: Any) -> Any:
        return _two(">", self, other)

    def __ge__(self, other: Any) -> Any:
        return _two(">=", self, other)

    def __eq__(self, other: object) -> Any:
        return _two("==", self, other)

    def __ne__(self, other: object) -> Any:
        return plain(self) != plain(other)

    # -- as numpy's numbers -----------------------------------------------------------------------------------

    @property
    def real(self) -> Derived:
        """The part to the right."""
        return Derived(self.value.real, "real", self) if np.iscomplexobj(self.value) else self

    @property
    def imag(self) -> Derived:
        """The part upwards."""
        return Derived(self.value.imag, "imag", self)

    def conjugate(self) -> Derived:
        """Mirrored in the x axis."""
        return Derived(self.value.conjugate(), "conj", self)

    @property
    def ndim(self) -> int:
        """One number."""
        return 0

    @property
    def dtype(self) -> Any:
        """As numpy calls its kind."""
        return np.asarray(self.value).dtype

    def __getitem__(self, which: Any) -> Derived:
        return self

    def __complex__(self) -> complex:
        return complex(self.value)

    def __float__(self) -> float:
        return float(self.value)

    def __bool__(self) -> bool:
        return bool(self.value)

    def __format__(self, form: str) -> str:
        return format(self.value, form)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
        return np.array(self.value, dtype=dtype)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        if any(type(one) is Traced for one in inputs):
            return NotImplemented
        if method == "__call__" and ufunc in _UFUNCS:
            return _found(ufunc(*map(plain, inputs), **options), _UFUNCS[ufunc], *inputs)
        return getattr(ufunc, method)(*map(plain, inputs), **options)

    def __array_function__(self, function: Any, types: Any, args: Any, options: Any) -> Any:
        if any(type(one) is Traced for one in args):
            return NotImplemented
        if function is np.where:
            return _case(*args)
        if function is np.angle:
            return Derived(np.angle(plain(args[0])), "angle", args[0])
        return function(*map(plain, args), **options)


def variable(value: float, name: str) -> Derived:
    """A number that may be changed."""
    return Derived(value, "variable", name)


def moves(value: object) -> bool:
    """Whether the number depends on what may be changed."""
    return type(value) is Derived


def plain(value: Any) -> Any:
    """The number alone."""
    return value.value if type(value) is Derived else value


def _two(op: str, one: Any, other: Any) -> Any:
    """The result of an operation on two numbers, one of which knows where it came from."""
    if type(one) is Traced or type(other) is Traced:
        return NotImplemented
    return _found(_APPLIED[op](plain(one), plain(other)), op, one, other)


def _found(value: Any, op: str, *args: Any) -> Any:
    """What an operation gave; what changes nothing gives the same number again."""
    if np.ndim(value):
        return value  # many at once are marks to look at
    match op, [None if type(one) is Derived else one for one in args]:
        case ("+" | "-", [None, 0]) | ("*" | "/", [None, 1]):
            return args[0]
        case ("+", [0, None]) | ("*", [1, None]):
            return args[1]
        case _:
            return Derived(value, op, *args)


def _case(condition: Any, one: Any, other: Any) -> Any:
    """`one` where the condition holds, else `other`."""
    if one is other:
        return one
    if type(condition) is not Derived:
        return one if condition else other
    return Derived(plain(one) if condition.value else plain(other), "where", condition, one, other)


_APPLIED: Mapping[str, Any] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": np.divide,
    "pow": lambda a, b: a**b,
    "<": lambda a, b: a < b,
    "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b,
    ">=": lambda a, b: a >= b,
    "==": lambda a, b: a == b,
}
