"""A problem to be marked over and over, and a tally of what came out."""

from __future__ import annotations

from dataclasses import dataclass, field

from tests.grader_proof.students import Cells
from vecpoly import Problem
from vecpoly.board.otherwise.slip import Slip
from vecpoly.grading.derive.keyed import answer_key
from vecpoly.grading.key import AnswerKey, Graded
from vecpoly.grading.marking.marked import Marked
from vecpoly.grading.marking.marker import mark
from vecpoly.grading.rules import Rules
from vecpoly.grading.sheet import sheet_of
from vecpoly.grading.slips.mutants import Mutant, mutants
from vecpoly.grading.told.named import Told


@dataclass(slots=True)
class Tally:
    """So many of so many, by name."""

    hits: dict[str, int] = field(default_factory=dict)
    of: dict[str, int] = field(default_factory=dict)

    def add(self, name: str, hits: int | bool, of: int = 1) -> None:
        self.hits[name] = self.hits.get(name, 0) + int(hits)
        self.of[name] = self.of.get(name, 0) + of

    def share(self, name: str) -> float:
        return self.hits.get(name, 0) / self.of[name] if self.of.get(name) else float("nan")

    def __iadd__(self, other: Tally) -> Tally:
        for name in other.of:
            self.add(name, other.hits.get(name, 0), other.of[name])
        return self


@dataclass(frozen=True, slots=True)
class Trial:
    """A problem with its key and its mutants."""

    problem: Problem
    key: AnswerKey
    mutants: tuple[Mutant, ...]

    @classmethod
    def of(cls, problem: Problem) -> Trial:
        key = answer_key(problem)
        return cls(problem, key, mutants(problem, key))

    def mark(self, cells: Cells, rules: Rules | None = None) -> Marked:
        return mark(self.problem, self.key, lambda: self.mutants, sheet_of(self.key, dict(cells)), rules or Rules())


def named(trial: Trial, sheet: Marked) -> list[Slip]:
    """The mistakes of the catalogue that a marked sheet names, one of the two that it names beside exchanged names
    among them."""
    told = {said.numbers["slip"] for one in sheet.findings for said in one.messages if said.id is Told.EXCHANGED}
    return [*sheet.slips.values(), *(one.slip for one in trial.mutants if str(one.slip) in told)]


def apart(mine: AnswerKey, theirs: AnswerKey) -> bool:
    """Whether two keys are further apart than 3 T in two answers, as the gate of a class wants it."""
    both = [(one, other) for one in mine.quantities if one.asked and (other := theirs.find(one.key)) is not None]
    return sum(_between(one, other) > 3 * one.allowed > 0 for one, other in both) >= 2


def _between(one: Graded, other: Graded) -> float:
    if one.at is not None and other.at is not None:
        return abs(complex(*one.at) - complex(*other.at))
    return abs(abs(one.exact) - abs(other.exact))
