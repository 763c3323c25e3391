"""The member of another family that is told otherwise:
its data as texts, its solution, and the comparison with the retold one.

The title of the retold problem names the original, so that it is found again when the solution is looked at.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from vecpoly import loads
from vecpoly.errors import VecpolyError
from vecpoly.mechanism.model import Mechanism
from vecpoly.solution import Answer, Solution, solve

from ..family import families, member
from ..judge import AGREE
from ..library import Data
from ..nearby import largest, natural, slack

SEED = 5
PLENTY = (
    "change-points",
    "cylinder-lever",
    "cylinder-offset",
    "cylinder-slider",
    "forces",
    "forces-couples",
    "forces-elsewhere",
    "forces-friction",
    "forces-masses",
    "four-bar",
    "gears-arms",
    "gears-pivots",
    "gears-rolling",
    "gears-trains",
    "linkage-prp",
    "linkage-rpp",
    "linkage-rpr",
    "linkage-rrp",
    "linkage-rrr",
    "linkage-slide",
    "offset-slot-drives",
    "pin-in-two-slots",
    "roller",
    "linkage-cam",
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Change:
    """What becomes of an answer: of its key, of a vector, of the sign of a turning."""

    key: Callable[[str], str] = str
    vector: Callable[[complex], complex] = complex
    turn: int = 1


def original(rng: np.random.Generator, names: tuple[str, ...] = PLENTY) -> tuple[str, str]:
    """The mark of a member that is solved, for the title; and its text."""
    while True:
        mark = f"{names[int(rng.integers(len(names)))]} {SEED} {rng.integers(10**6)}"
        try:
            solved(text := text_of(mark))
        except VecpolyError:
            continue
        return mark, text


def text_of(mark: str) -> str:
    """The original's text."""
    name, seed, number = mark.split()
    return member(next(one for one in families() if one.name == name), int(seed), int(number))


def told(data: Data, mark: str) -> str:
    """The problem as text (JSON is YAML), its title the mark."""
    return json.dumps(data | {"title": mark}, ensure_ascii=False, indent=1)


@lru_cache(maxsize=4)
def solved(text: str) -> Solution:
    """Solved by the exact hand."""
    return solve(loads(text), by="exact", repeats=0)


def compared(solution: Solution, change: Change, mark: str = "") -> str:
    """The first answer that is not the original's, changed; "" where all are."""
    return against(solution, solved(text_of(mark or str(solution.problem.title.en))), change)


def against(solution: Solution, first: Solution, change: Change) -> str:
    """The first answer that is not that of another solution, changed; "" where all are."""
    near = slack(first)
    floor = natural(first.problem.subject) if isinstance(first.problem.subject, Mechanism) else {}
    for key, answer in first.answers.items():
        other, back = _found(solution, change.key(key))
        if other is None:
            return f"{key} is not answered as {change.key(key)}, but {', '.join(solution.answers)}"
        if answer.undefined and other.undefined:
            continue
        size = largest(first, answer.reading.unit, floor)
        if not _gap(answer, other, change, back) <= AGREE * size + near.get(answer.key, 0.0):
            return f"{key} was {_value(answer)}, as {change.key(key)} it is {_value(other)}"
    return (
        ""
        if len(first.answers) == len(solution.answers)
        else f"{len(solution.answers)} answers in the place of {len(first.answers)}"
    )


def _value(answer: Answer) -> complex:
    return answer.exact if answer.exact_vector is None else answer.exact_vector


def _found(solution: Solution, key: str) -> tuple[Answer | None, int]:
    """An answer, or the counterforce R_31 of R_13, and its sign."""
    if key in solution.answers or not (m := re.fullmatch(r"R_(\d)(\d)(_0)?", key)):
        return solution.answers.get(key), 1
    return solution.answers.get(f"R_{m[2]}{m[1]}{m[3] or ''}"), -1


def _gap(one: Answer, other: Answer, change: Change, back: int) -> float:
    if one.undefined or other.undefined:
        return float("inf")
    if (one.exact_vector is None) != (other.exact_vector is None):
        return float("inf")
    if one.exact_vector is None or other.exact_vector is None:
        return abs((change.turn if one.turns else 1) * one.exact - other.exact)
    return abs(change.vector(one.exact_vector) - back * other.exact_vector)
