"""Why somebody got no variant."""

from __future__ import annotations

from collections import Counter

from ..problem.problem import Problem
from .conditions import Condition
from .draw import tried
from .judge import Standard, verdict
from .seeds import Seed

SETS = 12  # of values that are looked at


def obstacle(problem: Problem, seed: Seed, standard: Standard) -> Condition:
    """What most of the first draws of a student fail on; that others are too near, where one of them is good."""
    graded = standard.graded(problem)
    failed = Counter[Condition]()
    for attempt in range(SETS):
        trial = tried(problem, seed, attempt, standard, graded)
        failed.update(trial.swept.failed)
        for _, look in trial.drawn:
            why = verdict(look, standard)
            if why is None:
                return Condition.APART
            failed[why] += 1
    return failed.most_common(1)[0][0] if failed else Condition.REFUSED
