"""Drawing the values of a variant: what stands still in the mechanism first, then the places of the drive that are
worth drawing."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass

from ..errors import VecpolyError
from ..grading.key import AnswerKey
from ..problem.problem import Problem
from ..problem.values.vary import vary
from .apart import Taken
from .conditions import Condition
from .judge import Standard, failing, looked_at
from .look import Look
from .seeds import Seed
from .sweep import Swept, drive_range, sweep

ATTEMPTS = 300  # sets of values that are drawn for one student, at most
NOBODY = Taken(0.0)
TRIALS = 3  # places of the drive that are drawn of each set
Drawn = tuple[Mapping[str, str], Look | Condition]
Draws = Callable[[Problem, Mapping[str, str], Standard, bool], Drawn]


@dataclass(frozen=True, slots=True, kw_only=True)
class Variant:
    """One student's problem: with its values and scales, the key, and what was drawn by."""

    seed: Seed
    attempt: int
    values: Mapping[str, str]
    problem: Problem
    key: AnswerKey


@dataclass(frozen=True, slots=True, kw_only=True)
class Trial:
    """One set of values: which places of the drive passed the oracle, and what became of those that were drawn."""

    attempt: int
    swept: Swept
    drawn: Iterable[Drawn]  # one after another, as they are asked for


def variants(
    problem: Problem, seed: Seed, standard: Standard, taken: Taken = NOBODY, start: int = 0, attempts: int = ATTEMPTS
) -> Iterator[Variant]:
    """The variants of a student from this attempt on, until so many are used up; too near to those who have theirs is
    left out."""
    graded = standard.graded(problem)
    for attempt in range(start, start + attempts):
        for values, look in tried(problem, seed, attempt, standard, graded, taken, good=True).drawn:
            if isinstance(look, Look) and failing(look, standard) is None:
                yield Variant(seed=seed, attempt=attempt, values=values, problem=look.problem, key=look.key)


def tried(
    problem: Problem,
    seed: Seed,
    attempt: int,
    standard: Standard,
    graded: frozenset[str],
    taken: Taken = NOBODY,
    *,
    good: bool = False,
    draws: Draws | None = None,
) -> Trial:
    """One set of values, by the stream of this attempt. good: only those that pass are of interest; of the others less
    is drawn, or nothing. draws: who draws them."""
    draws = draws or draws_each
    stream, along = seed.stream(attempt), drive_range(problem)
    values = {one.name: one.at(stream.below(one.count)) for one in problem.ranges}
    if along is None:
        return Trial(attempt=attempt, swept=Swept((0,), Counter(), {}), drawn=(draws(problem, values, standard, good),))
    try:
        swept = sweep(vary(problem, values | {along.name: along.at(0)}), along, standard.signs, graded)
    except VecpolyError:
        return Trial(attempt=attempt, swept=Swept((), Counter({Condition.REFUSED: 1}), {}), drawn=())
    places = [number for number in stream.shuffled(swept.passed) if taken.leaves(swept.answers(number))][:TRIALS]
    some = [number for number in places if not (good and number in swept.short)]
    drawn = (draws(problem, values | {along.name: along.at(number)}, standard, good) for number in some)
    return Trial(attempt=attempt, swept=swept, drawn=drawn)


def draws_each(problem: Problem, values: Mapping[str, str], standard: Standard, good: bool) -> Drawn:
    """The problem with these values, looked at."""
    try:
        return values, looked_at(vary(problem, values), standard, good=good)
    except VecpolyError:
        return values, Condition.REFUSED


def draws_once() -> Draws:
    """Who draws what has the same values once, however often it is drawn by lot."""
    known: dict[tuple[tuple[str, str], ...], Drawn] = {}

    def draws(problem: Problem, values: Mapping[str, str], standard: Standard, good: bool) -> Drawn:
        key = tuple(values.items())
        if key not in known:
            known[key] = draws_each(problem, values, standard, good)
        return known[key]

    return draws
