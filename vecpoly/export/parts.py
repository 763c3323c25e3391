"""The arithmetic of the plane as that of real numbers: what becomes of both parts."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from ..errors import NoMethodError
from ..plane.derived import Derived
from ..words import Words
from .terms import Pair, Term, Terms

_REAL = {"sqrt": "sqrt", "sin": "sin", "cos": "cos", "tan": "tan", "asin": "asin", "acos": "acos", "sign": "sgn"}


@dataclass(slots=True)
class Numbers(Terms):
    """The terms of one sheet, and the recorded numbers that are made of them."""

    _parts: dict[int, tuple[Derived, Pair]] = field(default_factory=dict)  # by identity, which keeps the numbers alive

    def parts(self, value: complex | Derived) -> Pair:
        """Both parts of a recorded number, or of a constant."""
        if type(value) is not Derived:
            return self.number(complex(value).real), self.number(complex(value).imag)
        for one in _from_the_leaves(value, self._parts):
            self._parts[id(one)] = one, self._split(one)
        return self._parts[id(value)][1]

    def _split(self, one: Derived) -> Pair:
        if one.op == "variable":
            return self.variable(str(one.args[0])), self.number(0.0)
        return split(self, one.op, [self._parts[id(a)][1] if type(a) is Derived else self.parts(a) for a in one.args])


def _from_the_leaves(value: Derived, known: Mapping[int, Any]) -> Iterator[Derived]:
    """What the number is made of, each before what is made of it; without what is known."""
    waiting, seen = [(value, False)], set(known)
    while waiting:
        one, ready = waiting.pop()
        if ready:
            yield one
        elif id(one) not in seen:
            seen.add(id(one))
            waiting.append((one, True))
            waiting.extend((arg, False) for arg in one.args if type(arg) is Derived)


def split(t: Terms, op: str, args: Sequence[Pair]) -> Pair:
    """Both parts of an operation on numbers given by theirs; raises NoMethodError for one that is not known here."""
    none = t.number(0.0)
    (a, b), *others = args
    match op:
        case "+" | "-":
            ((c, d),) = others
            return t.of(op, a, c), t.of(op, b, d)
        case "*":
            return _product(t, args[0], args[1])
        case "/":
            return _quotient(t, args[0], args[1])
        case "square":
            return _product(t, args[0], args[0])
        case "pow":
            return _power(t, args[0], others[0][0])
        case "neg":
            return t.of("neg", a), t.of("neg", b)
        case "conj":
            return a, t.of("neg", b)
        case "real":
            return a, none
        case "imag":
            return b, none
        case "abs":
            return (t.of("abs", a) if b.constant == 0 else t.of("sqrt", _squares(t, a, b))), none
        case "angle":
            return t.of("atan2", b, a), none
        case "exp":
            size = t.of("exp", a)
            return t.of("*", size, t.of("cos", b)), t.of("*", size, t.of("sin", b))
        case "where":
            (c, d), (e, f) = others
            return t.of("if", a, c, e), t.of("if", a, d, f)
        case _ if all(imaginary.constant == 0 for _, imaginary in args):
            return _real(t, op, [real for real, _ in args]), none
    raise _unknown(op)


def _real(t: Terms, op: str, args: list[Term]) -> Term:
    match op, args:
        case ("<" | "<=" | ">" | ">=" | "==" | "atan2", _):
            return t.of(op, *args)
        case ("max", [one, other]):
            return t.of("if", t.of(">=", one, other), one, other)
        case ("min", [one, other]):
            return t.of("if", t.of("<=", one, other), one, other)
        case ("radians", [one]):
            return t.of("*", one, t.number(math.pi / 180))
        case ("degrees", [one]):
            return t.of("*", one, t.number(180 / math.pi))
        case _ if op in _REAL:
            return t.of(_REAL[op], *args)
    raise _unknown(op)


def _unknown(op: str) -> NoMethodError:
    return NoMethodError(
        Words(
            f"运算 {op} 不能写入 GeoGebra；请另取一题",
            f"the operation {op} cannot be written for GeoGebra; take another problem",
        ),
        code="export-operation",
    )


def _squares(t: Terms, a: Term, b: Term) -> Term:
    return t.of("+", t.of("*", a, a), t.of("*", b, b))


def _product(t: Terms, one: Pair, other: Pair) -> Pair:
    (a, b), (c, d) = one, other
    return t.of("-", t.of("*", a, c), t.of("*", b, d)), t.of("+", t.of("*", a, d), t.of("*", b, c))


def _quotient(t: Terms, one: Pair, other: Pair) -> Pair:
    (a, b), (c, d) = one, other
    if d.constant == 0:
        return t.of("/", a, c), t.of("/", b, c)
    up, size = _product(t, one, (c, t.of("neg", d))), _squares(t, c, d)
    return t.of("/", up[0], size), t.of("/", up[1], size)


def _power(t: Terms, base: Pair, exponent: Term) -> Pair:
    if exponent.constant == 2:
        return _product(t, base, base)
    if base[1].constant == 0:
        return t.of("^", base[0], exponent), t.number(0.0)
    raise _unknown("^")
