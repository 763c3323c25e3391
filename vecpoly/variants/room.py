"""How many students the ranges of a problem can tell apart, about: by how often two good variants are too near to each
other."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from math import inf, log

from ..grading.key import AnswerKey
from .apart import Apart

FEWEST = 4  # good variants from which anything can be told


def room(keys: Sequence[AnswerKey], least: float, attempts: int) -> float:
    """How many students get values where two must be so many T apart, and each may draw so many times.

    With a share p of pairs too near, a draw is far from n others with (1 − p)ⁿ; the last to be served finds one among
    his draws: n = ln(attempts) / −ln(1 − p). Infinite where no pair is too near, or too few are known.
    """
    if len(keys) < FEWEST:
        return inf
    pairs = list(combinations(keys, 2))
    near = sum(_near(one, other, least) for one, other in pairs)
    if not near:
        return inf
    return 1.0 if near == len(pairs) else log(attempts) / -log(1.0 - near / len(pairs))


def _near(one: AnswerKey, other: AnswerKey, least: float) -> bool:
    both = Apart(least)
    return not (both.takes(one) and both.takes(other))
