"""A sheet with its marks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import floor
from typing import Any

from ...board.otherwise.slip import Slip
from ...words import Words
from ..compare.outcome import Finding, Outcome
from ..equations.mark import EquationMark
from ..key import AnswerKey
from ..told.message import Message
from .lines import LineMark

TINY = 1e-6  # points


@dataclass(frozen=True, slots=True, kw_only=True)
class Marked:
    """findings: one for each quantity of the key that was answered, or is worth something; stated: points for scales.

    lost: points lost for units, once. lines: what a drawing that was handed in earns; equations: what their ticked rows
    do. slips: root → the mistake of the catalogue behind it. messages: of the whole sheet.
    """

    key: AnswerKey
    findings: tuple[Finding, ...]
    stated: Mapping[str, float] = field(default_factory=dict)
    lost: float = 0.0
    lines: tuple[LineMark, ...] = ()
    equations: tuple[EquationMark, ...] = ()
    slips: Mapping[str, Slip] = field(default_factory=dict)
    roots: tuple[str, ...] = ()
    messages: tuple[Message, ...] = ()
    faults: tuple[Words, ...] = ()

    def __getitem__(self, key: str) -> Finding:
        """The finding of this quantity."""
        return next(one for one in self.findings if one.key == key)

    @property
    def total(self) -> float:
        """The points, to the nearest half; never below zero, and all of them only where nothing was lost."""
        points = halves(max(0.0, self.exactly))
        return points if self.exactly > self._best - TINY else min(points, max(0.0, self.worth - 0.5))

    @property
    def exactly(self) -> float:
        """The points before they are rounded."""
        drawn = sum(one.earned for one in self.lines) + sum(one.earned for one in self.equations)
        return sum(one.earned.total for one in self.findings) + drawn + sum(self.stated.values()) - self.lost

    @property
    def worth(self) -> float:
        """All points that can be had."""
        return halves(self._best)

    @property
    def _best(self) -> float:
        beside = sum(one.worth for one in self.lines) + sum(one.worth for one in self.equations)
        return self.key.worth + beside

    @property
    def doubts(self) -> tuple[tuple[Words, Words], ...]:
        """Figures of the drawing, and rows of equations, that a person must look at, each with why."""
        figures = dict.fromkeys((one.figure, one.doubt) for one in self.lines if one.doubt is not None)
        rows = ((one.title, one.messages[0].words) for one in self.equations if one.outcome.for_a_person)
        return (*figures, *rows)

    @property
    def waiting(self) -> int:
        """How much a person must look at."""
        return len(self.queue) + len(self.doubts)

    @property
    def queue(self) -> tuple[Finding, ...]:
        """What a person must look at."""
        return tuple(one for one in self.findings if one.for_a_person)

    def as_json(self) -> dict[str, Any]:
        """Plain data."""
        return {
            "problem": self.key.problem, "total": self.total, "worth": self.worth, "roots": list(self.roots),
            "slips": {root: str(slip) for root, slip in self.slips.items()},
            "stated": dict(self.stated), "lost": self.lost, "messages": [one.as_json() for one in self.messages],
            "answers": [_finding(one) for one in self.findings],
            **({"equations": [one.as_json() for one in self.equations]} if self.equations else {}),
            **({"lines": [one.as_json() for one in self.lines]} if self.lines else {}),
        }  # fmt: skip


def halves(points: float) -> float:
    """To the nearest half point, a quarter upwards."""
    return floor(2 * points + 0.5 + 1e-9) / 2


def _finding(one: Finding) -> dict[str, Any]:
    unread = one.outcome in (Outcome.UNREADABLE, Outcome.AMBIGUOUS)
    return {
        "key": one.key, "written": one.written.raw, "outcome": one.outcome.value, "basis": one.basis.value,
        "value": None if unread else one.value, "off": one.off, "points": one.earned.total,
        "messages": [said.as_json() for said in one.messages],
    }  # fmt: skip
