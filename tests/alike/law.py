"""A law: how a problem is told otherwise, and what of its pages must be the same then."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import zip_longest
from typing import get_args

import numpy as np

from tests.alike.said import NUMBER, Line, drawn_at, said, scales, solved
from tests.generators.library import Data
from vecpoly.words import Lang

Scales = Mapping[str, tuple[float, str]]
Retold = Callable[[np.random.Generator, Data], Data | None]  # None: the law does not speak of this problem
Seen = Callable[[Line], str]


@dataclass(frozen=True, slots=True, kw_only=True)
class Law:
    """retold: the other problem; grown: by what its scales are multiplied; before, after: what must be the same of a
    line of the first, and of one of the other."""

    name: str
    retold: Retold
    before: Seen
    after: Seen
    grown: Mapping[str, float] | None = None
    ordered: bool = True  # else the lines may come in another order

    def broken(self, rng: np.random.Generator, data: Data) -> str:
        """The first line that differs; "" where none does, or the law does not speak of this problem."""
        first, other = solved(data), self.retold(rng, data)
        if other is None:
            return ""
        at = {name: (value * (self.grown or {}).get(name, 1.0), unit) for name, (value, unit) in scales(first).items()}
        second = solved(drawn_at(other, at))
        for lang in get_args(Lang):
            one = [self.before(line) for line in said(first, lang)]
            two = [self.after(line) for line in said(second, lang)]
            if not self.ordered:
                one, two = sorted(one), sorted(two)
            for a, b in zip_longest(one, two, fillvalue="(nothing)"):
                if a != b:
                    return f"{a!r} became {b!r}"
        return ""


ROUNDED = re.compile(r" ≈ .*")  # a last figure less, where the result lay midway


def whole(line: Line) -> str:
    """The line as it is."""
    return line.text


def unnumbered(line: Line) -> str:
    """The line without its numbers, but for lengths on paper."""
    text = ROUNDED.sub("", line.text)
    return NUMBER.sub(lambda found: found[0] if text[found.end() :].startswith(" mm") else "#", text)


SENSES = (("counter-clockwise", "clockwise"), ("逆时针", "顺时针"), ("left", "right"), ("左", "右"))


def mirrored(text: str) -> str:
    """Senses and sides exchanged."""
    for one, other in SENSES:
        text = other.join(part.replace(other, one) for part in text.split(one))
    return text
