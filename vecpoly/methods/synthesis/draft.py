"""What a synthesis works on: a board, the candidates found so far, and the answers read off each of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import nan

import numpy as np

from ...algebra.formula import Txt
from ...algebra.quantity import Expr, Quantity, magnitude
from ...algebra.worked import stated
from ...board.candidates import Candidate
from ...board.construction import Figure, Place, Reading, View
from ...designs.base import MOST, Design, numbered
from ...designs.verdict import Verdict
from ...foundation.frozen import FrozenMap
from ...foundation.slotted import replace
from ...names import Named, subscripted
from ...plane import Points, Reals, nominal
from ...words import Words
from ..devices.bench import Bench
from .telling import gap, lost, no_use, spread

ONE, TWO = Quantity(Txt("1"), 1.0, ""), Quantity(Txt("2"), 2.0, "")
WHOLE_TURN = Quantity(Txt("360°"), 360.0, "deg")
HALF_TURN = Quantity(Txt("180°"), 180.0, "deg")
RIGHT = Quantity(Txt("90°"), 90.0, "deg")
SHEET = View.MECHANISM


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """A candidate on paper: its number, pins by every hand (mm), verdict, by what it is ordered, what linkage it is,
    and whether its last link must drive it."""

    number: int
    pins: Mapping[str, Points]
    verdict: Verdict
    order: tuple[float, ...]
    kind: Words | None
    last: bool = False


@dataclass(slots=True)
class Draft(Bench):
    """The state of one synthesis.

    numbers: the number of each candidate in the order in which they are found, as a first sketch tells it, and how many
    of them are valid. sketched: the candidates of that sketch, at the scale of this sheet. asked: the keys that are to
    be read. take: the number of the solution that is taken. rejected: whether the candidate found next is no solution.
    kind, last: what linkage it is, whether its last link must drive it. parts: with which step what is drawn for
    another solution alone begins, and how many have been found before. steps: by so many round scales a figure of
    angles may be drawn larger.
    """

    numbers: tuple[int, ...] = ()
    sketched: tuple[Found, ...] = ()
    valid: int = 0
    take: int = 1
    steps: int = 0
    asked: frozenset[str] = frozenset()
    rejected: bool = False
    kind: Words | None = None
    last: bool = False
    found: list[Found] = field(default_factory=list)
    parts: list[tuple[int, int]] = field(default_factory=list)

    # -- numbers and letters ---------------------------------------------------------------------------------

    @property
    def number(self) -> int:
        """The number of the candidate that is found next."""
        return self._number(len(self.found))

    def _number(self, n: int) -> int:
        return self.numbers[n] if n < len(self.numbers) else n + 1

    @property
    def alone(self) -> bool:
        """Whether there is only one solution."""
        return self.valid == 1

    @property
    def any_valid(self) -> bool:
        """Whether a solution has been found already."""
        return any(one.verdict is Verdict.VALID for one in self.found)

    def letter(self, letter: str, after: int = 0) -> str:
        """A letter of the candidate that is found next, or so many after it: B1 as B_1, of the second B′_1."""
        head, sub, primes = letter[0], letter[1:], "′" * (self._number(len(self.found) + after) - 1)
        return subscripted(f"{head}{primes}{sub}") if sub else head + primes

    def of_this(self, named: Named) -> Named:
        """A quantity of the candidate that is found next, under its number; printed without where it is the only
        solution."""
        one = numbered(named, self.number)
        return replace(one, symbol=named.symbol) if self.alone and not self.rejected else one

    def candidate(self, verdict: Verdict, order: tuple[Reals, ...], **pins: Points) -> None:
        """A candidate is finished; the next has another number."""
        by = tuple(float(nominal(value)) for value in order)
        self.found.append(
            Found(number=self.number, pins=pins, verdict=verdict, order=by, kind=self.kind, last=self.last)
        )
        self.rejected, self.kind, self.last = False, None, False

    def paired(self, found: Sequence[Mapping[str, Points]]) -> None:
        """What is about to be found, by its pins, where a hand finds more or fewer than the sketch: each has the number
        of the sketch's candidate that it is nearest to; what the sketch has not comes last."""
        if not self.sketched or len(found) == len(self.sketched):
            return
        left = {one.number: one.pins for one in self.sketched}
        numbers: list[int] = []
        for pins in found:
            number = min(left, key=lambda n: gap(pins, left[n]), default=len(self.sketched) + len(numbers) + 1)
            left.pop(number, None)
            numbers.append(number)
        self.numbers = tuple(numbers)

    def begins(self) -> None:
        """With the next step begins what is drawn for another solution alone."""
        self.parts.append((len(self.board.steps) + 1, len(self.found)))

    def figures(self, titles: Mapping[View, Words]) -> tuple[Figure, ...]:
        """What was drawn; the sheet knows its parts, where each is of one solution."""
        made, counts = self.board.figures(titles), [before for _, before in self.parts]
        each = counts == [*range(len(self.found))] and all(one.verdict is Verdict.VALID for one in self.found)
        parts = tuple((step, self.found[n].number) for step, n in self.parts) if each else ()
        return tuple(replace(one, parts=parts) if one.view is SHEET and not one.name else one for one in made)

    # -- reading --------------------------------------------------------------------------------------------

    def mu(self, place: Place = SHEET) -> Quantity:
        """μ_l in mm a millimetre, for lengths that are told in mm."""
        return magnitude("μ_l", self.board.scale_of(place).value * 1e3, "mm/mm")

    def mm(self, metres: float) -> float:
        """A given length on paper."""
        return float(self.board.to_paper(SHEET, metres))

    def on_paper(self, length: Quantity, place: Place = SHEET) -> Reals:
        """A length that is told in mm, on paper."""
        return length.value * 1e-3 / self.board.scale_of(place).value

    def length(self, named: Named, on_paper: Expr, letters: str, place: Place = SHEET) -> Quantity:
        """A length of the linkage: μ_l times what is read on paper."""
        found = self.worked(named, self.mu(place) * on_paper)
        self.read_off(named, place, replace(found, value=on_paper.value), letters)
        return found

    def angle(self, at: Points, one: Points, other: Points) -> Reals:
        """The angle at a point between two others, by protractor (deg)."""
        return np.degrees(np.abs(self.board.gauge(0j, (other - at) / (one - at))))

    def shared(self, named: Named, value: Reals) -> Quantity:
        """What all candidates have in common, given or found before them."""
        result = magnitude(named.symbol, value, named.unit)
        self._keep(_reading(named, value), value)
        return result

    def kept(self, *keys: str) -> str | None:
        """The first of these keys under which an answer is kept."""
        return next((key for key in keys if key in self.board.readings), None)

    def own(self, named: Named) -> Reals:
        """What was found of the candidate that is found next, under its number or in common; else what was given."""
        key = self.kept(numbered(named, self.number).key, named.key)
        assert key is not None
        return self.board.found[key]

    # -- the end -------------------------------------------------------------------------------------------

    def settle(self, design: Design) -> None:
        """Answer what is asked without a number by the solution that is taken; what is shared, of each.

        Who has made a mistake may have none that is valid, and reads what is there.
        """
        self._say_order([one.number for one in self.found])
        if self.sketched and not self.valid:
            self._settle_none(design)
        else:
            self._settle_taken(design)

    def _settle_taken(self, design: Design) -> None:
        valid = sorted(one.number for one in self.found if one.verdict is Verdict.VALID)
        valid = valid or sorted(one.number for one in self.found)
        taken = valid[design.take - 1] if design.take <= len(valid) else 0
        if self.sketched and design.take not in {one.number for one in self.found}:
            taken = 0  # this hand has lost it
        for named in design.quantities():
            for key, number in ((named, taken), *((numbered(named, n), n) for n in range(1, MOST + 1))):
                if key.key in self.asked and key.key not in self.board.readings:
                    self._copy(numbered(named, number) if number else named, named, key)

    def _settle_none(self, design: Design) -> None:
        """Of data that no linkage fits, what the data alone tell is an answer; all else has no value."""
        if not self.any_valid:
            self.board.section(Words("结论", "Conclusion"))
            self.board.step(no_use(len(self.found)), SHEET)
        told = design.settled()
        for named in design.askable():
            if named.key in self.asked - self.board.readings.keys() and named.key in told:
                self.shared(named, told[named.key])
            elif named.key in self.asked - told.keys():
                self._keep(Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=nan), np.float64(nan))

    def _say_order(self, numbers: list[int]) -> None:
        """Why what was found first is not number 1, where it is not."""
        if numbers != sorted(numbers):
            self.board.remark(
                Words(
                    "（各解按 $AB$ 由短到长编号，舍去的候选解排在最后。）",
                    " (Solutions are numbered by $AB$, the shortest first; rejected candidates come last.)",
                )
            )

    def _copy(self, source: Named, shared: Named, named: Named) -> None:
        """Keep an answer under another key; what was not found is no number."""
        if (here := self.kept(source.key, shared.key)) is None:
            self._keep(_reading(named, nan), np.float64(nan))
            return
        self._keep(replace(self.board.readings[here], key=named.key, symbol=named.symbol), self.board.found[here])

    def candidates(self, design: Design) -> tuple[Candidate, ...]:
        """What was found, as it stands on the nominal sheet, in the order of the numbers."""
        return tuple(self._candidate(one, design) for one in sorted(self.found, key=lambda one: one.number))

    def _candidate(self, one: Found, design: Design) -> Candidate:
        read, found = self.board.readings, self.board.found
        where = {named.key: (numbered(named, one.number).key, named.key) for named in design.quantities()}
        kept = {key: name for key, names in where.items() if (name := self.kept(*names))}
        valid = one.verdict is Verdict.VALID
        return Candidate(
            number=one.number,
            pins=FrozenMap({letter: complex(nominal(at)) for letter, at in one.pins.items()}),
            verdict=one.verdict.name,
            reason=None if valid else one.verdict.value,
            kind=one.kind,
            last=one.last,
            values=FrozenMap({key: read[name].scalar for key, name in kept.items() if valid}),
            spread=FrozenMap({key: spread(found[name]) for key, name in kept.items() if valid}),
            lost=max(map(lost, one.pins.values()), default=0.0),
        )


def _reading(named: Named, value: Reals) -> Reading:
    node = stated(magnitude(named.symbol, value, named.unit))
    return Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=float(nominal(value)), formula=node)
