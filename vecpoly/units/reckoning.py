"""Expressions of quantities with units and names, `linkage.CD / 2` or `180 deg - linkage.theta`: a value and its unit.

Sums, differences, products, quotients and brackets; nothing else. The units are checked as they are reckoned with.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite, pi
from typing import Any

from ..errors import FaultError
from ..foundation.patterns import pattern
from ..foundation.slotted import dataclass
from ..words import Words
from .names import plain, unit_of

_TOKEN = pattern(
    r"\s*(?:(?P<number>\d+\.?\d*(?:[eE][+\-]?\d+)?)(?:\s*(?P<unit>%|[a-zA-Z°][a-zA-Z°²*/^\d]*))?"
    r"|(?P<name>[^\W\d][\w\-]*(?:\.[\w′']+)+)|(?P<sign>[-+*/()−]))"
)
_SHOWN = {
    "": ("", 1.0),
    "length 1": ("mm", 1e-3),
    "angle 1": ("deg", pi / 180),
    "angle 1 time -1": ("rad/s", 1.0),
    "length 1 time -1": ("m/s", 1.0),
    "length 1 time -2": ("m/s^2", 1.0),
    "length 1 mass 1 time -2": ("N", 1.0),
    "length 2 mass 1 time -2": ("N*m", 1.0),
    "length 2 mass 1 time -3": ("W", 1.0),
    "length 2 mass 1": ("kg*m^2", 1.0),
    "mass 1": ("kg", 1.0),
}
_DEEPEST = 40  # brackets within each other


@dataclass(frozen=True, slots=True)
class Amount:
    """A value in SI with the powers of its dimensions: m/s is {"length": 1, "time": -1}."""

    si: float
    powers: tuple[tuple[str, float], ...] = ()

    @classmethod
    def of(cls, value: float, unit: str) -> Amount:
        """The value in this unit (`deg`, `mm`, `m/s^2`, `N·m`); raises FaultError for an unknown unit."""
        factor, dimension = unit_of(plain(unit)) if unit else (1.0, "")
        parts = dimension.split()
        powers = tuple((name, float(power)) for name, power in zip(parts[::2], parts[1::2], strict=True))
        return cls(value * factor, powers)

    @property
    def dimension(self) -> str:
        """Its dimension as the units have it: `length 1 time -1`."""
        return " ".join(f"{name} {power:g}" for name, power in self.powers)

    def shown(self, digits: int = 6) -> str:
        """As a problem file writes it: 30 deg, 215 mm; in SI what is neither angle nor length."""
        unit, factor = _SHOWN.get(self.dimension, (self._in_si(), 1.0))
        return f"{float(f'{self.si / factor:.{digits}g}')!r} {unit}".removesuffix(" ").replace(".0 ", " ")

    def _in_si(self) -> str:
        symbols = {"length": "m", "angle": "rad", "time": "s", "mass": "kg"}
        return "*".join(symbols[name] + (f"^{power:g}" if power != 1 else "") for name, power in self.powers)


def reckon(text: str, known: Mapping[str, Amount]) -> Amount:
    """The value of an expression; raises FaultError with what is wrong in it, and what is known."""
    tokens = _tokens(text)
    value, rest = _sum(tokens, known, text, 0)
    if rest:
        raise _unread(text, _said(rest[0]))
    if not isfinite(value.si):
        raise FaultError(Words(f"“{text}”不是有限的数", f"'{text}' is not a finite number"), code="out-of-range")
    return value


def names_in(text: str) -> list[str]:
    """The names that an expression holds, in order."""
    return [token["name"] for token in _tokens(text) if token["name"]]


def _tokens(text: str) -> list[dict[str, Any]]:
    found, at = [], 0
    while text[at:].strip():
        m = _TOKEN.match(text, at)
        if m is None:
            raise _unread(text, text[at:].strip())
        found.append(m.groupdict())
        at = m.end()
    return found


def _said(token: Mapping[str, Any]) -> str:
    return str(token["number"] or token["name"] or token["sign"])


def _unread(text: str, at: str) -> FaultError:
    return FaultError(
        Words(
            f"“{text}”中的“{at or text}”不可读；算式由数（带单位）、量（如 linkage.CD）、+ − * / 和括号组成",
            f"in '{text}' the part '{at or text}' cannot be read: an expression holds numbers with units, "
            "quantities such as linkage.CD, + - * / and brackets",
        ),
        code="spelling",
    )


Parsed = tuple[Amount, list[dict[str, Any]]]


def _sum(tokens: list[dict[str, Any]], known: Mapping[str, Amount], text: str, deep: int) -> Parsed:
    value, rest = _product(tokens, known, text, deep)
    while rest and rest[0]["sign"] in ("+", "-", "−"):
        sign = 1.0 if rest[0]["sign"] == "+" else -1.0
        other, rest = _product(rest[1:], known, text, deep)
        value = _added(value, other, sign, text)
    return value, rest


def _added(one: Amount, two: Amount, sign: float, text: str) -> Amount:
    if one.powers != two.powers:
        raise FaultError(
            Words(
                f"“{text}”：{one.shown()} 与 {two.shown()} 量纲不同，不能相加减",
                f"'{text}': {one.shown()} and {two.shown()} are of different kinds and cannot be added",
            ),
            code="wrong-unit",
        )
    return Amount(one.si + sign * two.si, one.powers)


def _product(tokens: list[dict[str, Any]], known: Mapping[str, Amount], text: str, deep: int) -> Parsed:
    value, rest = _single(tokens, known, text, deep)
    while rest and rest[0]["sign"] in ("*", "/"):
        power = 1 if rest[0]["sign"] == "*" else -1
        other, rest = _single(rest[1:], known, text, deep)
        value = _times(value, other, power, text)
    return value, rest


def _times(one: Amount, two: Amount, power: int, text: str) -> Amount:
    if power < 0 and two.si == 0:
        raise FaultError(Words(f"“{text}”：除数为零", f"'{text}' divides by zero"), code="out-of-range")
    sums = dict(one.powers)
    for name, own in two.powers:
        sums[name] = sums.get(name, 0.0) + power * own
    return Amount(one.si * two.si**power, tuple(sorted((name, p) for name, p in sums.items() if p)))


def _single(tokens: list[dict[str, Any]], known: Mapping[str, Amount], text: str, deep: int) -> Parsed:
    if not tokens or deep > _DEEPEST:
        raise _unread(text, "")
    first, rest = tokens[0], tokens[1:]
    if first["number"]:
        unit = first["unit"] or ""
        return (Amount(float(first["number"]) / 100) if unit == "%" else Amount.of(float(first["number"]), unit)), rest
    if first["name"]:
        if first["name"] not in known:
            raise _unknown(first["name"], known)
        return known[first["name"]], rest
    if first["sign"] in ("-", "−"):
        value, rest = _single(rest, known, text, deep + 1)
        return Amount(-value.si, value.powers), rest
    if first["sign"] == "(":
        value, rest = _sum(rest, known, text, deep + 1)
        if rest and rest[0]["sign"] == ")":
            return value, rest[1:]
    raise _unread(text, _said(first))


def _unknown(name: str, known: Mapping[str, Amount]) -> FaultError:
    head = name.partition(".")[0]
    own = [one for one in known if one.partition(".")[0] == head] or sorted({one.partition(".")[0] for one in known})
    return FaultError(
        Words(
            f"没有量“{name}”；此处已知：{'、'.join(own) or '无（只能引用前面的部分）'}",
            f"there is no quantity '{name}'; known here: {', '.join(own) or 'none (only earlier parts can be named)'}",
        ),
        code="unknown-name",
    )
