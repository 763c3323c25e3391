"""A pocket calculator in the hands of a strict reader: every a × b / c = d of a printed line, keyed in as printed."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from math import atan, cos, pi, radians, sin, sqrt, tan

_NUMBER = re.compile(r"(\d+(?:\.\d+)?)(?:×10\^(?:\{([−-]?\d+)\}|([−-]?\d+)))?")
_UNITS = (
    *("kN·m", "N·m", "kg·m²", "kg·m^2", "kg·m", "g·mm", "g", "kg", "kN", "mm²", "mm^2", "mm", "m/s²", "m/s^2", "m/s"),
    *("m²", "m^2", "m", "rad²/s²", "rad/s²", "rad/s^2", "rad/s", "rad", "N", "J", "kW", "W", "s"),
)
_UNIT = re.compile(rf"\s?({'|'.join(re.escape(unit) for unit in _UNITS)})(?![\w/·²^])")
_OPENS = re.compile(r"(?:^|(?<=[=≈：，。；,;(（]))\s*")
_EQUALS = re.compile(r"\s*(?:=|≈)\s*")
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")
_FUNCTIONS: dict[str, Callable[[float], float]] = {
    "arctan": atan,
    "sin": sin,
    "cos": cos,
    "tan": tan,
    "cot": lambda x: 1.0 / tan(x),
}
_SPACES = " \u2009\u200a\u00a0"


@dataclass(frozen=True, slots=True)
class Keyed:
    """What the calculator shows for one side of an equation; half: half a unit of its last place, for a bare number."""

    value: float
    half: float
    worked: bool
    turned: bool = False
    unit: str = ""


@dataclass(frozen=True, slots=True)
class Sum:
    """worked-out = printed, as they stand in the text."""

    text: str
    reckoned: float
    printed: Keyed

    @property
    def off(self) -> float:
        """How far the printed result is from what the printed figures give, in units of its last place."""
        gap = self.reckoned - self.printed.value
        if self.printed.turned:
            gap = (gap + pi) % (2 * pi) - pi
        return abs(gap) / (2 * self.printed.half)

    @property
    def holds(self) -> bool:
        """Whether a reader gets the printed result; what lies midway goes to the even figure, or up: 13.75 is never
        13.7."""
        midway = abs(self.off - 0.5) <= 1e-6
        even = round(self.printed.value / (2 * self.printed.half)) % 2 == 0
        return even or abs(self.printed.value) > abs(self.reckoned) if midway else self.off < 0.5


class _Stop(Exception):
    """Here no number follows."""


class _Reader:
    """Reads an arithmetic expression from a place in a text as far as it goes."""

    def __init__(self, text: str, at: int) -> None:
        self.text, self.at, self.operated = text, at, False

    def side(self) -> Keyed:
        """One side of an equation."""
        self._blank()
        start = self.at
        value = self._sum()
        alone = None if self.operated else _NUMBER.search(self.text, start, self.at)
        turned = self.text[start : self.at].endswith("°")
        half = _half(alone) * (pi / 180 if turned else 1.0) if alone else 0.0
        return Keyed(value, half, self.operated, turned)

    def _sum(self) -> float:
        value = self._product()
        while sign := self._operator("+−-"):
            value += self._product() * (1 if sign == "+" else -1)
        return value

    def _product(self) -> float:
        value = self._power()
        while sign := self._operator("×/·"):
            value = value / self._power() if sign == "/" else value * self._power()
        return value

    def _operator(self, signs: str) -> str:
        """The next operator, if one follows behind which a number stands."""
        was = self.at
        self._blank()
        sign = self.text[self.at : self.at + 1]
        if not sign or sign not in signs:
            self.at = was
            return ""
        self.at += 1
        try:
            ahead = _Reader(self.text, self.at)
            ahead._power()
        except (_Stop, ZeroDivisionError):
            self.at = was
            return ""
        self.operated = True
        return sign

    def _power(self) -> float:
        value = self._atom()
        if m := re.compile(r"\^\{?(−?\d+)\}?|([⁰¹²³⁴⁵⁶⁷⁸⁹]+)").match(self.text, self.at):
            self.at, self.operated = m.end(), True
            value = value ** int((m[1] or m[2].translate(_RAISED)).replace("−", "-"))
        if self.text[self.at : self.at + 1] == "°":
            self.at += 1
            value = radians(value)
        return value

    def _atom(self) -> float:
        self._blank()
        if self._take("−") or self._take("-"):
            return -self._power()
        if self._take("√"):
            self.operated = True
            return sqrt(self._atom())
        for name, function in _FUNCTIONS.items():
            if self._take(name):
                self.operated = True
                return float(function(self._power()))
        if self._take("("):
            value = self._sum()
            self._blank()
            if not self._take(")"):
                raise _Stop
            return value
        if self._take("π"):
            self.operated = True
            return pi
        if not (m := _NUMBER.match(self.text, self.at)):
            raise _Stop
        self.at = m.end()
        value = float(f"{m[1]}e{(m[2] or m[3] or '0').replace('−', '-')}")
        if self._take("π"):
            self.operated = True
            value *= pi
        return value

    def _take(self, word: str) -> bool:
        if self.text.startswith(word, self.at):
            self.at += len(word)
            return True
        return False

    def _blank(self) -> None:
        while self.at < len(self.text) and self.text[self.at] in _SPACES:
            self.at += 1


def _half(m: re.Match[str]) -> float:
    """Half a unit of the last place of a printed number; one that is whole may have lost its zeros to the right."""
    places = len(m[1].partition(".")[2])
    return 0.5 * 10.0 ** (int((m[2] or m[3] or "0").replace("−", "-")) - places)


def sums(text: str) -> Iterator[Sum]:
    """Every worked-out side of an equation in a text, metres told in mm too, and the printed number that follows."""
    text = text.replace("$", "")
    taken = 0
    for opened in _OPENS.finditer(text):
        if opened.end() < taken:
            continue
        sides = list(_chain(text, opened.end()))
        for (one, _), (other, end) in pairwise(sides):
            taken = end
            if not other.worked and (one.worked or (one.unit, other.unit) == ("m", "mm")):
                yield Sum(text[opened.end() : end], one.value if one.worked else 1e3 * one.value, other)


def _chain(text: str, at: int) -> Iterator[tuple[Keyed, int]]:
    """The sides of an equation from a place on, all of them numbers."""
    while True:
        reader = _Reader(text, at)
        try:
            side = reader.side()
        except (_Stop, ZeroDivisionError):
            return
        unit = _UNIT.match(text, reader.at)
        end = unit.end() if unit else reader.at
        yield replace(side, unit=unit[1] if unit else ""), end
        if not (follows := _EQUALS.match(text, end)):
            return
        at = follows.end()
