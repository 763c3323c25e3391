"""Members of all families by lot: those that are solved, with nothing suspect in them."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from tests.generators.family import OnText, families, member
from vecpoly import loads, solve
from vecpoly.errors import VecpolyError

SELDOM = 4  # members are drawn for each that is wanted, at most: many are refused


def drawn_by_lot(start: str, count: int, seed: int) -> Mapping[str, str]:
    """Name → text of so many members of families whose names begin so."""
    rng = np.random.default_rng(seed)
    kinds = [one for one in families() if one.name.startswith(start) and not isinstance(one.also, OnText)]
    found: dict[str, str] = {}
    for number in range(SELDOM * count):
        one = kinds[int(rng.integers(len(kinds)))]
        name = f"{one.name}.{seed}.{number}"
        text = member(one, seed, number)
        if _is_sound(text):
            found[name] = text
        if len(found) == count:
            break
    return found


def _is_sound(text: str) -> bool:
    """Whether it is solved, and nothing in it is under an alarm."""
    try:
        solution = solve(loads(text), by="exact", repeats=0, precise=False)
    except VecpolyError:
        return False
    return not any(answer.suspect for answer in solution.answers.values())
