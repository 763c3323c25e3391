"""The table of verification of a synthesis: what each solution does, as moved with the lengths read, beside exact."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from math import isfinite

from ..algebra.quantity import number
from ..board.candidates import Candidate
from ..check.candidates import exact
from ..check.found import Verified
from ..designs.base import Design
from ..designs.inversion.stages import Stages
from ..solution import Solution
from ..words import Lang, Words
from .flow.table import DataTable

_HEADER = Words("校核项目", "Item")
_NONE, _YES, _NO = Words.same("—"), Words("是", "yes"), Words("否", "no")
_BARS = (("A", "B"), ("B", "C"), ("C", "D"))
Line = tuple[Words, tuple[Words, ...]]


def verification_table(solution: Solution, lang: Lang) -> DataTable | None:
    """One line an item, one column a solution; None where no solution can be moved."""
    moved = [one for one in solution.verification if one.broken is None]
    design = solution.problem.subject
    if not moved or not isinstance(design, Design):
        return None
    found = {one.number: one for one in solution.construction.candidates}
    true: dict[int, Mapping[str, float]] = dict(enumerate(exact(design), 1))
    mu = 1e3 * solution.construction.figures[0].scale.value
    columns = [_Column(design, one, found[one.number], true.get(one.number, {}), mu).items() for one in moved]
    lines = [(items[0][0], [text for _, text in items]) for items in zip(*columns, strict=True)]
    rows = [[title.of(lang), *(text.of(lang) for text in texts)] for title, texts in lines if set(texts) != {_NONE}]
    header = [_HEADER.of(lang), *(Words(f"解 {one.number}", f"Solution {one.number}").of(lang) for one in moved)]
    return DataTable(header, rows, None, "l" + "c" * len(moved), lang=lang)


class _Column:
    """What is said of one solution."""

    def __init__(self, design: Design, moved: Verified, drawn: Candidate, true: Mapping[str, float], mu: float) -> None:
        self.design, self.moved, self.drawn, self.mu = design, moved, drawn, mu
        self.exact = true

    def items(self) -> list[tuple[Words, Words]]:
        """Item by item, in one order for all."""
        one = self.moved
        swings = one.unit == "°"
        stroke, unit = ("psi", "°") if swings else ("H", " mm")
        return [
            (Words("各位置闭合，杆长相差", "Closes in its positions; bars differ by"), self._closes()),
            (Words("各位置在同一回路、同一分支", "Positions in one circuit and branch"), self._yes()),
            (Words("依次通过各位置", "Passes through them in order"), self._order()),
            (Words("机构类型（杆长和余量）", "Type (margin of lengths)"), self._type()),
            (Words("原动件整周转动", "The driver turns fully"), _YES if one.full else _NO),
            (Words("$K$（精确值）", "$K$ (exact)"), self._beside(one.ratio, "K", "", 4)),
            (Words("$θ$（精确值）", "$θ$ (exact)"), self._beside(one.theta, "theta", "°", 4)),
            (
                Words("摆角（精确值）", "Swing (exact)") if swings else Words("行程（精确值）", "Stroke (exact)"),
                self._beside(one.stroke, stroke, unit, 4),
            ),
            (
                Words("最小传动角（精确值）", "Least transmission angle (exact)"),
                self._beside(one.gamma, "gamma_min", "°", 4) if one.full else _NONE,
            ),
        ]

    def _closes(self) -> Words:
        """How much the bars differ in length from position to position, on paper."""
        spans = [self.mu * (max(lengths) - min(lengths)) for lengths in self._lengths() if len(lengths) > 1]
        return Words.same(f"{max(spans):.2f} mm") if spans else _NONE

    def _lengths(self) -> Iterator[list[float]]:
        bars: Iterable[tuple[str, str]] = self.design.plan().bars() if isinstance(self.design, Stages) else _BARS
        for one, two in bars:
            places = [(self._pin(one, n), self._pin(two, n)) for n in range(1, self.positions + 1)]
            yield [abs(b - a) for a, b in places if a is not None and b is not None]

    @property
    def positions(self) -> int:
        """How many positions its pins are known in."""
        return max((int(key[-1]) for key in self.drawn.pins if key[-1].isdigit()), default=1)

    def _pin(self, letter: str, n: int) -> complex | None:
        pins = self.drawn.pins
        return pins.get(f"{letter}{n}", pins.get(letter))

    def _yes(self) -> Words:
        """A candidate of another circuit or branch is none that is valid."""
        return _YES if self.positions > 1 else _NONE

    def _order(self) -> Words:
        order = " → ".join(map(str, range(1, self.positions + 1)))
        return Words.same(order) if self.positions > 2 else _NONE

    def _type(self) -> Words:
        one = self.moved
        if one.kind is None:
            return _NONE
        return one.kind + Words.same(f" ({number(one.margin)} mm)")

    def _beside(self, value: float, key: str, unit: str, digits: int) -> Words:
        if not isfinite(value):
            return _NONE
        exact = f" ({number(self.exact[key], digits)}{unit})" if key in self.exact else ""
        return Words.same(f"{number(value, digits)}{unit}{exact}")
