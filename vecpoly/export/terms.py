"""Real terms: what a recorded number is made of, its parts to the right and upwards apart, each term once."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True, eq=False)
class Term:
    """An operation on terms; a number (op ``number``) or a variable (op ``variable``) has only its name or value."""

    op: str
    args: tuple[Term, ...] = ()
    leaf: float | str = 0.0

    @property
    def constant(self) -> float | None:
        """The value of a number; None of anything else."""
        return float(self.leaf) if self.op == "number" else None


Pair = tuple[Term, Term]  # the parts to the right and upwards
FUNCTIONS: Mapping[str, Callable[..., float]] = {
    "sqrt": lambda x: math.sqrt(x) if x >= 0 else math.nan,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "exp": math.exp,
    "atan2": math.atan2,
    "asin": lambda x: math.asin(x) if abs(x) <= 1 else math.nan,
    "acos": lambda x: math.acos(x) if abs(x) <= 1 else math.nan,
    "abs": abs,
    "sgn": lambda x: float((x > 0) - (x < 0)),
    "neg": lambda x: -x,
    "+": lambda x, y: x + y,
    "-": lambda x, y: x - y,
    "*": lambda x, y: x * y,
    "/": lambda x, y: x / y if y else math.nan,
    "^": lambda x, y: x**y,
    "<": lambda x, y: x < y,
    "<=": lambda x, y: x <= y,
    ">": lambda x, y: x > y,
    ">=": lambda x, y: x >= y,
    "==": lambda x, y: x == y,
    "if": lambda c, x, y: x if c else y,
}


@dataclass(slots=True)
class Terms:
    """The terms of one sheet; equal terms are one."""

    _known: dict[tuple[object, ...], Term] = field(default_factory=dict)

    def number(self, value: float) -> Term:
        """A constant."""
        return self._one("number", (), float(value) + 0.0)  # + 0.0: no −0

    def variable(self, name: str) -> Term:
        """What is changed."""
        return self._one("variable", (), name)

    def of(self, op: str, *args: Term) -> Term:
        """An operation on terms: computed at once where all are constant, left away where it changes nothing."""
        values = [arg.constant for arg in args]
        if all(value is not None for value in values):
            return self.number(float(FUNCTIONS[op](*values)))
        return self._simple(op, args, values) or self._one(op, args)

    def _simple(self, op: str, args: tuple[Term, ...], values: list[float | None]) -> Term | None:
        match op, values:
            case ("+" | "-" | "*" | "/", [_, 0 | 1 as unit]) if unit == (op in "*/"):
                return args[0]
            case ("+", [0, _]) | ("*", [1, _]):
                return args[1]
            case ("*", [0, _]) | ("*", [_, 0]) | ("/", [0, _]):
                return self.number(0.0)
            case ("-", [0, _]) | ("*", [-1, _]):
                return self.of("neg", args[1])
            case ("if", [bool() | float() as holds, *_]):
                return args[1] if holds else args[2]
            case ("if", _) if args[1] is args[2]:
                return args[1]
            case ("neg", _) if args[0].op == "neg":
                return args[0].args[0]
        return None

    def _one(self, op: str, args: tuple[Term, ...], leaf: float | str = 0.0) -> Term:
        key = (op, leaf, *map(id, args))
        return self._known.setdefault(key, Term(op, args, leaf))


def values(terms: list[Term], given: Mapping[str, float]) -> list[float]:
    """The values of terms where the variables have these values; NaN where one has none."""
    found: dict[int, float] = {}
    for root in terms:
        waiting = [root]
        while waiting:
            term = waiting[-1]
            missing = [arg for arg in term.args if id(arg) not in found]
            if missing:
                waiting.extend(missing)
                continue
            found[id(waiting.pop())] = _value(term, found, given)
    return [found[id(term)] for term in terms]


def _value(term: Term, found: Mapping[int, float], given: Mapping[str, float]) -> float:
    if term.op == "variable":
        return given[str(term.leaf)]
    return float(term.leaf) if term.op == "number" else FUNCTIONS[term.op](*(found[id(arg)] for arg in term.args))
