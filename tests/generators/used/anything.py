"""Any member of any other family, and the dice by which a use is chosen: the same for the same text."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from functools import partial, wraps
from textwrap import dedent
from zlib import crc32

import numpy as np

from vecpoly.solution import Solution, solve

from ..family import Check, Make, families

Use = Callable[[Solution, np.random.Generator], str]
OTHERS = ("used", "retold", "library")
solved = partial(solve, by="exact", repeats=0, precise=False)  # again, as the judge did; its answers are known


def anything(use: str, *starts: str) -> Make:
    """What makes a member of a random family, of those whose names begin so; another for every use."""

    def make(rng: np.random.Generator) -> str:
        """Any member of any other family."""
        dice = np.random.default_rng([int(rng.integers(2**32)), crc32(use.encode())])
        known = [one for one in families() if one.name.startswith(starts or "") and not one.name.startswith(OTHERS)]
        return dedent(known[int(dice.integers(len(known)))].make(dice))

    return make


def used(use: Use) -> Check:
    """The use as a check; a warning that would stand on somebody's terminal is an error."""

    @wraps(use)
    def check(solution: Solution) -> str:
        with warnings.catch_warnings():
            warnings.simplefilter("error", RuntimeWarning)
            return use(solution, np.random.default_rng(crc32(solution.problem.text.encode())))

    return check


def unlike(one: Solution, other: Solution) -> str:
    """The first answer that is not the same to the bit; "" where all are."""
    if one.answers.keys() != other.answers.keys():
        return f"answered are {', '.join(other.answers)} and not {', '.join(one.answers)}"
    for key, answer in one.answers.items():
        here, there = _told(answer), _told(other.answers[key])
        if here != there:
            return f"{key} was {here}, and is {there}"
    return ""


def _told(answer: object) -> str:
    """Drawn and exact, with all digits: NaN is like NaN."""
    return ", ".join(repr(getattr(answer, name)) for name in ("drawn", "drawn_vector", "exact", "exact_vector"))
