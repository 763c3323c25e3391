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
from .fitting import fitted
from .numbers import Span, numbers

ENOUGH = 0.15  # of the draws must pass
MOST = 4  # numbers that differ from student to student
TRIES = 10  # numbers that are tried
GAIN = 1.2  # times as many students must have room by one more
FEW = 3  # students: where fewer have room, another number by itself may serve better


@dataclass(frozen=True, slots=True, kw_only=True)
class Proposal:
    """The ranges of a problem, and what the pilot says of them."""

    ranges: tuple[Span, ...]
    pilot: Pilot


def proposal(problem: Problem, students: int) -> Proposal:
    """Ranges by which so many students have numbers of their own, as far as there are such.

    Numbers that the text of the problem tells stay as they are, and those that are bound to others, as the radii of
    gears to the distance of their axes. Raises VecpolyError where none can be varied.
    """
    found, why = None, None
    for tried, spans in enumerate(free(problem)):
        if tried == TRIES or (found is not None and (len(found.ranges) == MOST or found.pilot.room >= students)):
            break
        for span in spans:
            try:
                better = _with(problem, found, span)
            except VecpolyError as error:
                why = why or error
                continue
            if better is not None:
                found = better
                break
    if found is None:
        raise _nothing(problem, why)
    return found


def _with(problem: Problem, found: Proposal | None, span: Span) -> Proposal | None:
    """What this number makes better: by itself, where what varies already hardly tells two students apart, or with it;
    None where it does not."""
    before = None if found is None else found.pilot
    if found is None or found.pilot.room < FEW:
        alone = _tried(problem, (span,), before)
        if alone is not None or found is None:
            return alone
    return _tried(problem, (*found.ranges, span), before)


def _tried(problem: Problem, spans: tuple[Span, ...], before: Pilot | None) -> Proposal | None:
    now = pilot(ranged(problem, spans))
    return Proposal(ranges=spans, pilot=now) if _serves(now, before) else None


def ranged(problem: Problem, spans: Sequence[Span]) -> Problem:
    """The problem with these ranges, at scales that are chosen for each variant."""
    data = {key: value for key, value in data_of(problem).items() if key not in ("scales", "vary", "printed", "tables")}
    return made(data | {"vary": {one.name: one.text for one in spans}}, name=problem.id)


def _serves(now: Pilot, before: Pilot | None) -> bool:
    """Whether enough draws pass; where some numbers vary already, nothing more is demoted, and more students differ."""
    if now.passed < ENOUGH or before is None:
        return now.passed >= ENOUGH
    return now.standard.demoted <= before.standard.demoted and now.room >= GAIN * before.room


def free(problem: Problem) -> Iterator[Sequence[Span]]:
    """The numbers that may vary and that the text of the problem does not tell, each as far as it can."""
    for spans in numbers(data_of(problem)):
        if free := dict.fromkeys(fit for span in spans if (fit := _varied(problem, span)) is not None):
            yield tuple(free)


def _varied(problem: Problem, span: Span) -> Span | None:
    try:
        one = ranged(problem, [span])
    except VecpolyError:
        return None
    return None if any(said_already(one)) else fitted(one, span)


def _nothing(problem: Problem, why: VecpolyError | None) -> VecpolyError:
    cause = Words("其数据都写在题目正文中，或不是数", "its numbers are all told by its text, or are none")
    if why is not None:
        cause = why.words
    return VecpolyError(
        Words(f"没有可因人而异的数据：{cause.zh}", f"no number can be varied: {cause.en}"), code="nothing-to-vary"
    )
