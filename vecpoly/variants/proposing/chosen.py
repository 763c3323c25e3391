"""Ranges that work: one number after another is varied, as long as enough of the draws pass, until a class has room."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ...errors import VecpolyError
from ...problem.problem import Problem
from ...problem.values.made import problem as made
from ...problem.values.vary import data_of
from ...words import Words
from ..pilot import Pilot, pilot
from ..told import said_already
from .numbers import Span, numbers

ENOUGH = 0.15  # of the draws must pass
MOST = 4  # numbers that differ from student to student
TRIES = 10  # numbers that are tried
GAIN, FEW = 1.2, 3  # times as many students must have room by one more, where it is more than a few


@dataclass(frozen=True, slots=True, kw_only=True)
class Proposal:
    """The ranges of a problem, and what the pilot says of them."""

    ranges: tuple[Span, ...]
    pilot: Pilot


def proposal(problem: Problem, students: int) -> Proposal:
    """Ranges by which so many students have numbers of their own, as far as there are such.

    Numbers that the text of the problem tells stay as they are. Raises VecpolyError where none can be varied.
    """
    chosen, found, why = tuple[Span, ...](), None, None
    for tried, spans in enumerate(_free(problem)):
        if tried == TRIES or len(chosen) == MOST or (found is not None and found.room >= students):
            break
        for span in spans:
            try:
                now = pilot(ranged(problem, (*chosen, span)))
            except VecpolyError as error:
                why = why or error
                continue
            if _serves(now, found):
                chosen, found = (*chosen, span), now
                break
    if found is None:
        raise _nothing(problem, why)
    return Proposal(ranges=chosen, pilot=found)


def ranged(problem: Problem, spans: Sequence[Span]) -> Problem:
    """The problem with these ranges, at scales that are chosen for each variant."""
    data = {key: value for key, value in data_of(problem).items() if key not in ("scales", "vary", "printed", "tables")}
    return made(data | {"vary": {one.name: one.text for one in spans}}, name=problem.id)


def _serves(now: Pilot, before: Pilot | None) -> bool:
    """Whether enough draws pass; where some numbers vary already, nothing more is demoted, and more students differ."""
    if now.passed < ENOUGH or before is None:
        return now.passed >= ENOUGH
    return now.standard.demoted <= before.standard.demoted and (before.room < FEW or now.room >= GAIN * before.room)


def _free(problem: Problem) -> Iterator[Sequence[Span]]:
    """The numbers that may vary and that the text of the problem does not tell."""
    for spans in numbers(data_of(problem)):
        if free := [span for span in spans if _varies(problem, span)]:
            yield free


def _varies(problem: Problem, span: Span) -> bool:
    try:
        return not any(said_already(ranged(problem, [span])))
    except VecpolyError:
        return False


def _nothing(problem: Problem, why: VecpolyError | None) -> VecpolyError:
    cause = Words("其数据都写在题目正文中，或不是数", "its numbers are all told by its text, or are none")
    if why is not None:
        cause = why.words
    return VecpolyError(
        Words(f"没有可因人而异的数据：{cause.zh}", f"no number can be varied: {cause.en}"), code="nothing-to-vary"
    )
