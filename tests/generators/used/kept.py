"""Written as JSON and as data, and read again: the same solution, to the bit."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np

from vecpoly import problem
from vecpoly.problem.values.vary import data_of
from vecpoly.record import from_json, to_json
from vecpoly.solution import Solution

from ..family import family
from .anything import anything, solved, unlike, used


@used
def read_again(solution: Solution, rng: np.random.Generator) -> str:
    """A record holds all that there is, and its problem is solved as before."""
    text = to_json(solution)
    again = from_json(text, Solution)
    if to_json(again) != text or again.problem != solution.problem or not _same(again, solution):
        return "the record holds something else"
    json.dumps(solution.as_json(), allow_nan=False)
    return unlike(solution, solved(again.problem))


def _same(again: Solution, solution: Solution) -> bool:
    """Whether all that was drawn is there again: equal, or, where a number is undefined (η = 0/0) and so equals
    nothing, written alike to the last digit."""
    one, other = again.construction, solution.construction
    return one == other or ("nan" in repr(one) and repr(one) == repr(other))


@used
def made_again(solution: Solution, rng: np.random.Generator) -> str:
    """`problem.data` makes the same problem; drawn at the scales at which it was."""
    again = replace(problem(data_of(solution.problem)), scales=solution.problem.scales)
    return unlike(solution, solved(again))


family("used-record", also=read_again, often=2)(anything("record"))
family("used-data", also=made_again, often=2, first=2)(anything("data"))
