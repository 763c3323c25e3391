"""The table of verification of a synthesis: what each solution does, as moved with the lengths read, beside exact."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from math import isfinite

from ...algebra.columns import column, significant
from ...board.candidates import Candidate
from ...check.candidates import exact
from ...check.designs.found import Verified
from ...designs.base import Design
from ...designs.inversion.stages import Stages
from ...foundation.slotted import dataclass
from ...solution import Solution
from ...words import Lang, Words, stopped
from ..flow.table import DataTable
from .heads import (
    ALL_TURNS,
    BETWEEN,
    BROKEN,
    CIRCUIT,
    DRIVER,
    ERROR,
    GAMMA,
    MARGIN,
    MEANT,
    NO,
    NONE,
    NUMBER,
    OF_ALL,
    ORDER,
    SAID,
    STROKE,
    SWING,
    TURNS,
    TYPE,
    TYPE_OF,
    YES,
)
from .margins import margin_told

_FIGURES, _SMALL = 4, 10.0  # degrees: a smaller angle to so many figures would have more than hundredths
_SEEN = 0.005  # mm: less is no difference of lengths
_BESIDE = frozenset({"K", "psi", "H", "gamma_min"})  # keys of what is moved and found exactly too
_SIZE = re.compile(r"([−\d.]+)(°| mm)(?: \([−\d.]+\2\))?")  # 40.75° (40.74°)
_UNIT = re.compile(r"(?<=\d)(?:°| mm)")
_BARS = (("A", "B"), ("B", "C"), ("C", "D"))


@dataclass(frozen=True, slots=True)
class _Item:
    """What is said of one solution: in a table under its head; the same as a clause."""

    head: Words
    cell: Words
    clause: Words


def verification_table(solution: Solution, lang: Lang) -> DataTable | None:
    """One line a solution, one column an item; None where no solution can be moved."""
    return _table(solution, _lines(solution), lang)


def as_moved(solution: Solution, lang: Lang) -> tuple[DataTable | None, str]:
    """What the solutions do, as moved: of several a table, and a sentence of what all have in common; of one this."""
    lines = _told(_lines(solution))
    alike = [n for n in range(len(lines[0]) if lines else 0) if len(lines) == 1 or _is_common(lines, n)]
    said = Words("，", "; ").of(lang).join(lines[0][n].clause.of(lang) for n in alike)
    apart = [[one for n, one in enumerate(line) if n not in alike] for line in lines]
    told = stopped(f"{OF_ALL.of(lang) if len(lines) > 1 else ''}{said}", lang) if said else ""
    return _table(solution, apart, lang), told


def _is_common(lines: list[list[_Item]], n: int) -> bool:
    """Whether an item is the same of all solutions, and no size."""
    return len({line[n].cell for line in lines}) == 1 and "." not in lines[0][n].cell.en


def _lines(solution: Solution) -> list[list[_Item]]:
    """All items of every solution; none where no solution can be moved."""
    moved = solution.verification
    design = solution.problem.subject
    if all(one.broken is not None for one in moved) or not isinstance(design, Design) or design.is_given:
        return []
    found = {one.number: one for one in solution.construction.candidates}
    true: dict[int, Mapping[str, float]] = dict(enumerate(exact(design), 1))
    mu = 1e3 * solution.construction.figures[0].scale.value
    drivers = {one.driver for one in moved if one.broken is None}
    driver = drivers.pop() if len(drivers) == 1 else ""
    lines = (_Line(design, one, found[one.number], true.get(one.number, {}), mu, driver) for one in moved)
    return [one.items(margin_told(solution, design, one.moved, one.drawn.values)) for one in lines]


def _told(lines: list[list[_Item]]) -> list[list[_Item]]:
    """Those that any of the solutions has."""
    told = [n for n in range(len(lines[0]) if lines else 0) if any(line[n].cell != NONE for line in lines)]
    return [[line[n] for n in told] for line in lines]


def _table(solution: Solution, lines: list[list[_Item]], lang: Lang) -> DataTable | None:
    if not any(lines):
        return None
    told = _told(lines)
    header = [NUMBER.of(lang), *(one.head.of(lang) for one in told[0])]
    numbers = [str(one.number) for one in solution.verification]
    columns = [[line[n].cell.of(lang) for line in told] for n in range(len(told[0]))]
    named = [_in_head(head, cells) for head, cells in zip(header[1:], columns, strict=True)]
    rows = list(zip(numbers, *(cells for _, cells in named), strict=True))
    return DataTable([header[0], *(head for head, _ in named)], rows, None, "c" * len(header), lang=lang)


def _in_head(head: str, cells: list[str]) -> tuple[str, list[str]]:
    """A unit that all numbers of a column have stands in its head."""
    found = [_SIZE.fullmatch(cell) for cell in cells if cell != NONE.zh]
    units = {one[2].strip() if one else "" for one in found}
    if len(units) != 1 or "" in units:
        return head, cells
    (unit,) = units
    return f"{head} /{unit}", [_UNIT.sub("", cell) for cell in cells]


def heads_told(table: DataTable | None, lang: Lang) -> str:
    """What the heads of that table mean that do not say all."""
    header = [] if table is None else [head.partition(" /")[0] for head in table.header]
    told = [meant.of(lang) for head, meant in MEANT.items() if head.of(lang) in header]
    return stopped(Words("；", "; ").of(lang).join(told), lang) if told else ""


def beside_exact(solution: Solution) -> bool:
    """Whether exact values stand in that table, in brackets."""
    design = solution.problem.subject
    numbers = {one.number for one in solution.verification if one.broken is None}
    true = enumerate(exact(design), 1) if numbers and isinstance(design, Design) else ()
    return any(number in numbers and not _BESIDE.isdisjoint(values) for number, values in true)


class _Line:
    """What is said of one solution."""

    def __init__(
        self, design: Design, moved: Verified, drawn: Candidate, true: Mapping[str, float], mu: float, driver: str
    ) -> None:
        self.design, self.moved, self.drawn, self.mu = design, moved, drawn, mu
        self.exact, self.driver = true, driver

    def items(self, margin: float) -> list[_Item]:
        """Item by item, in one order for all; margin: of the lengths as they are printed (mm)."""
        one = self.moved
        swings = one.unit == "°"
        stroke, unit = ("psi", "°") if swings else ("H", " mm")
        return [
            self._kept(),
            _item(CIRCUIT, self._yes()),
            _item(ORDER, self._order()),
            _item(TYPE_OF if self._added() else TYPE, NONE if one.kind is None else one.kind),
            _item(MARGIN, NONE if one.kind is None else Words.same(f"{column([margin], 1)[0]} mm")),
            self._turning(),
            _item(Words.same("$K$"), self._beside(one.ratio, "K", "")),
            _item(SWING if swings else STROKE, self._beside(one.stroke, stroke, unit)),
            _item(GAMMA, self._beside(one.gamma, "gamma_min", "°") if one.full else NONE),
            _item(BETWEEN, self._beside(one.between, "", "°")),
        ]

    def _kept(self) -> _Item:
        """How much the bars differ in length from position to position, on paper; nothing where they do not."""
        spans = [self.mu * (max(lengths) - min(lengths)) for lengths in self._lengths() if len(lengths) > 1]
        if max(spans, default=0.0) < _SEEN:
            return _item(ERROR, NONE)
        return _item(ERROR, Words.same(f"{max(spans):.2f} mm"))

    def _lengths(self) -> Iterator[list[float]]:
        for one, two in self._bars():
            places = [(self._pin(one, n), self._pin(two, n)) for n in range(1, self.positions + 1)]
            yield [abs(b - a) for a, b in places if a is not None and b is not None]

    def _bars(self) -> Iterable[tuple[str, str]]:
        """Those with a length: B slides along a guide bar BC."""
        if isinstance(self.design, Stages):
            return self.design.plan().bars()
        known = {named.key for named in self.design.quantities()}
        return [(one, two) for one, two in _BARS if {one + two, two + one} & known]

    def _added(self) -> bool:
        """Whether links are added to a four-bar, of which alone the type is told."""
        bars = {frozenset(bar) for bar in self._bars()} if isinstance(self.design, Stages) else set()
        return self.moved.kind is not None and bool(bars - {frozenset(bar) for bar in (*_BARS, ("A", "D"))})

    @property
    def positions(self) -> int:
        """How many positions its pins are known in."""
        return max((int(key[-1]) for key in self.drawn.pins if key[-1].isdigit()), default=1)

    def _pin(self, letter: str, n: int) -> complex | None:
        pins = self.drawn.pins
        return pins.get(f"{letter}{n}", pins.get(letter))

    def _yes(self) -> Words:
        """A candidate of another circuit or branch is none that is valid."""
        return YES if self.positions > 1 and self.moved.broken is None else NONE

    def _turning(self) -> _Item:
        """Whether it turns right round, with what is added; of one that does not move with the lengths read, that."""
        added = self._added()
        if not self.driver:
            return _item(DRIVER, self._own_driver())
        ab = self.driver
        head = ALL_TURNS if added else Words(f"原动件 ${ab}$ 整周转动", f"Driver ${ab}$ rotates fully")
        if self.moved.broken is not None:
            return _item(head, BROKEN)
        cell = YES if self.moved.full else NO
        turns = TURNS[cell]
        if added:
            clause = Words(f"加装杆组后曲柄{turns.zh}整周转动", f"with the dyad added the crank {turns.en} fully")
        else:
            clause = Words(f"原动件 ${ab}$ {turns.zh}整周转动", f"the driver ${ab}$ {turns.en} fully")
        return _Item(head, cell, clause)

    def _own_driver(self) -> Words:
        """Where not all solutions are driven by one link: by which, and whether it turns right round."""
        if self.moved.broken is not None:
            return BROKEN
        cell, ab = YES if self.moved.full else NO, f"${self.moved.driver}$"
        return Words(f"{ab}，{cell.zh}", f"{ab}, {cell.en}")

    def _order(self) -> Words:
        order = " → ".join(map(str, range(1, self.positions + 1)))
        return Words.same(order) if self.positions > 2 and self.moved.broken is None else NONE

    def _beside(self, value: float, key: str, unit: str) -> Words:
        """With the exact value in brackets."""
        if not isfinite(value):
            return NONE
        exact = f" ({_figures(self.exact[key], unit)}{unit})" if key in self.exact else ""
        return Words.same(f"{_figures(value, unit)}{unit}{exact}")


def _figures(value: float, unit: str) -> str:
    """Four, but of an angle no more than its hundredths."""
    return f"{value:.2f}" if unit == "°" and abs(value) < _SMALL else significant(value, _FIGURES)


def _item(head: Words, cell: Words) -> _Item:
    """An item that stands in a sentence by its own words, or as it is headed."""
    if (said := SAID.get(head)) is not None:
        return _Item(head, cell, Words(said.zh.format(cell.zh), said.en.format(cell.en)))
    sign = Words.same(" = ") if head.en.startswith("$") else Words("：", ": ")
    return _Item(head, cell, head + sign + cell)
