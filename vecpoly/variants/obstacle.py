"""Why somebody got no variant."""

from __future__ import annotations

from collections import Counter

from ..problem.problem import Problem
from .conditions import Condition
from .draw import tried
from .judge import Standard, failing
from .look import Look
from .seeds import Seed

SETS = 12  # of values that are looked at


def obstacle(problem: Problem, seed: Seed, standard: Standard) -> Condition:
    """What most of the first draws of a student fail on; that others are too near, where one of them is good."""
    graded = frozenset(ask.rel.key for ask in problem.asks) - standard.demoted
    failed = Counter[Condition]()
    for attempt in range(SETS):
        trial = tried(problem, seed, attempt, standard, graded)
        failed.update(trial.swept.failed)
        for _, look in trial.drawn:
            verdict = failing(look, standard) if isinstance(look, Look) else look
            if verdict is None:
                return Condition.APART
            failed[verdict] += 1
    return failed.most_common(1)[0][0] if failed else Condition.REFUSED
