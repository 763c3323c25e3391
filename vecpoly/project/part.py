"""One part of a project, solved: its drawing, what it gives to later parts, its course over the cycle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from ..cycle import Cycle, Facts, cycle, facts
from ..designs.base import Design
from ..findings.study.from_pivots import from_pivots
from ..findings.study.study import Study
from ..foundation.slotted import replace
from ..mechanism.model import Mechanism
from ..names import Rel
from ..problem.problem import Problem
from ..solution import Solution
from .flywheel import Balance, balance
from .positions import Position
from .working import Working, Works, working

FINE = 721  # positions of a turn, both ends included: every half degree


@dataclass(frozen=True, eq=False)
class Told(Study):
    """The study of a part: its curves stand beside each other, for it is one of several."""

    @property
    def dense(self) -> bool:
        return True

    @cached_property
    def mech(self) -> Mechanism:
        """Its drive as its problem tells it: no equations stand beside."""
        return from_pivots(self.problem.mechanism)


@dataclass(frozen=True, kw_only=True)
class Part:
    """A part: `base` is the part whose linkage it takes, `taken` its lengths (mm) as rounded; others: positions
    drawn beside the given one; acting: where its loads act, where that is known already; unevenness: [δ]."""

    name: str
    solution: Solution
    base: Part | None = None
    taken: Mapping[str, float] = field(default_factory=dict)
    others: tuple[Position, ...] = ()
    works: Works | None = None
    acting: Working | None = None
    unevenness: float | None = None

    @property
    def problem(self) -> Problem:
        return self.solution.problem

    @property
    def moves(self) -> bool:
        """Whether it is a mechanism with a cycle."""
        return isinstance(self.problem.subject, Mechanism)

    @property
    def finds(self) -> bool:
        """Whether it is a synthesis."""
        return isinstance(self.problem.subject, Design)

    @cached_property
    def study(self) -> Study:
        """Its motion over the cycle, as a course report tells it; what acts is told apart (`working`)."""
        asks = tuple(ask for ask in self.problem.asks if isinstance(ask.rel, Rel))
        keys = {ask.rel.key for ask in asks}
        answers = {key: answer for key, answer in self.solution.answers.items() if key in keys}
        free = replace(self.solution, problem=replace(self.problem, loads=None, asks=asks), answers=answers)
        return Told(free, free)

    @property
    def positions(self) -> tuple[Position, ...]:
        """All that are drawn, the given one first."""
        return (Position(phi=self.problem.mechanism.drive.position, solution=self.solution), *self.others)

    @cached_property
    def turn(self) -> Cycle:
        """Its cycle on a fine grid."""
        return cycle(self.problem, FINE) if self.acting is None else self.acting.loaded

    @cached_property
    def facts(self) -> Facts:
        return facts(self.turn)

    @cached_property
    def working(self) -> Working:
        """Where its loads act."""
        return working(self.turn, self.works) if self.acting is None else self.acting

    @cached_property
    def balance(self) -> Balance | None:
        """The driving moment over the cycle; None where no moment on the crank balances the loads."""
        return balance(self.turn, self.working, self.unevenness)
