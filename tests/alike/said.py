"""What the pages of a solution say: steps with their headings, equations and lines, and the table of answers."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache

from tests.generators.library import Data
from vecpoly import loads
from vecpoly.algebra.formula import plain
from vecpoly.printed.digits import drawn_number
from vecpoly.printed.steps import as_printed
from vecpoly.solution import Solution, solve
from vecpoly.words import Lang

FEW = 6  # unsteady hands: points that coincide on the nominal sheet alone are two
MATH = re.compile(r"\$[^$]*\$")
LATIN = re.compile(r"[A-Za-z′]+")
NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?:(?: ?× ?|×)10\^\{?[−-]?\d+\}?)?")


@dataclass(frozen=True, slots=True)
class Line:
    """One sentence of the text, or one formula of it."""

    text: str
    formula: bool = False

    @property
    def letterless(self) -> str:
        """Without the letters of its formulas, but for their numbers, and for units."""
        if self.formula:
            return LATIN.sub("", self.text)
        return MATH.sub(lambda found: LATIN.sub("", found[0]), self.text)


def solved(data: Data) -> Solution:
    """As the hand draws it."""
    return _solved(json.dumps(data, ensure_ascii=False))


@lru_cache(maxsize=2)
def _solved(text: str) -> Solution:
    return solve(loads(text), repeats=FEW)


def said(solution: Solution, lang: Lang) -> Iterator[Line]:
    """All that the steps say, in their order, then every answer."""
    construction, answers = as_printed(solution.construction, solution.answers)
    section = ""
    for step in construction.steps:
        if (heading := step.section.of(lang)) != section:
            section = heading
            yield Line(section)
        yield Line(step.words.of(lang))
        if (table := step.equation) is not None:
            yield Line(
                " ".join(f"{sign} {symbol}" for sign, symbol in zip(table.signs, table.symbols, strict=True)), True
            )
            yield from (Line(direction.of(lang)) for direction in table.directions)
            yield from (Line(magnitude) for magnitude in table.magnitudes)
        yield from (Line(plain(formula), True) for formula in step.formulas)
    for key, answer in answers.items():
        yield Line(f"{key} = {drawn_number(answer)} {answer.reading.unit}", True)


def scales(solution: Solution) -> Mapping[str, tuple[float, str]]:
    """The scales of the figures, as a file gives them."""
    units = {"mu_l": "m/mm", "mu_v": "(m/s)/mm", "mu_a": "(m/s^2)/mm", "mu_F": "N/mm"}
    found = {f.scale.symbol.replace("μ", "mu"): f.scale.value for f in solution.construction.figures}
    return {name: (found[name], unit) for name, unit in units.items() if name in found}


def drawn_at(data: Data, at: Mapping[str, tuple[float, str]]) -> Data:
    """The problem with its scales given."""
    return data | {"scales": {name: f"{value!r} {unit}" for name, (value, unit) in at.items()}}
