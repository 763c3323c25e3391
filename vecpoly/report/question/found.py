"""In what order the quantities of a kind are found."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain

from ...algebra.formula import plain
from ...solution import Solution

_NUMBERED = ("P_", "omega_", "alpha_")  # centres and links stand by their numbers, as they are asked


def as_found(keys: Sequence[str], solution: Solution) -> list[str]:
    """Those of one kind in the order of the lines that give them; what no line gives stays behind the one before it."""
    if all(key.startswith(_NUMBERED) for key in keys):
        return [*keys]
    every = chain.from_iterable(step.formulas for step in solution.construction.steps)
    lines = {plain(line): n for n, line in enumerate(every)}
    places, last = dict[str, int](), -1
    for key in keys:
        formula = solution.construction.readings[key].formula
        last = lines.get(plain(formula), last) if formula is not None else last
        places[key] = last
    return sorted(keys, key=places.__getitem__)
