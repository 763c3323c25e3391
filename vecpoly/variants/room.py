"""How many students the ranges of a problem can tell apart, about: by how often two good variants are too near to each
other."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from math import inf, log

import numpy as np

from ..foundation.slotted import replace
from ..grading.key import AnswerKey
from .apart import Apart, Taken, answers

FEWEST = 4  # good variants from which anything can be told


def room(keys: Sequence[AnswerKey], least: float, attempts: int) -> float:
    """How many students get values where two must be so many T apart, and each may draw so many times.

    With a share p of pairs too near, a draw is far from n others with (1 − p)ⁿ; the last to be served finds one among
    his draws: n = ln(attempts) / −ln(1 − p). Where variants differ in one way alone, they fill their range sooner: the
    smaller of both. Infinite where no pair is too near, or too few are known.
    """
    if len(keys) < FEWEST:
        return inf
    pairs = list(combinations(keys, 2))
    near = sum(_near(one, other, least) for one, other in pairs)
    if not near:
        return inf
    by_chance = 1.0 if near == len(pairs) else log(attempts) / -log(1.0 - near / len(pairs))
    return min(by_chance, _filled(keys, least, attempts, by_chance))


def _filled(keys: Sequence[AnswerKey], least: float, attempts: int, most: float) -> float:
    """How many fit in between these, when nobody finds a place any more; infinite where more than so many do.

    Between two good variants lie others: with answers between theirs, and tolerances between theirs.
    """
    sizes, allowed = (np.array(rows) for rows in zip(*map(answers, keys), strict=True))
    rng, taken, refused = np.random.default_rng(len(keys)), Taken(least), 0
    while refused < attempts and len(taken.sizes) <= most:
        first, second = rng.choice(len(keys), 2, replace=False)
        share = rng.random()
        mine, its = (tuple(share * rows[first] + (1.0 - share) * rows[second]) for rows in (sizes, allowed))
        fits = taken.far_from(mine, its)
        refused = 0 if fits else refused + 1
        if fits:
            taken = replace(taken, sizes=(*taken.sizes, mine), allowed=(*taken.allowed, its))
    return len(taken.sizes) if refused >= attempts else inf


def _near(one: AnswerKey, other: AnswerKey, least: float) -> bool:
    both = Apart(least)
    return not (both.takes(one) and both.takes(other))
