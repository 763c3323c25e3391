"""The whole cycle of any mechanism: its row at the given position is the solution; a drive that turns right round ends
where it began; no row is beyond the extremes; what is found is told in words, tables and curves are written."""

from __future__ import annotations

import numpy as np

from vecpoly.curves import curves
from vecpoly.cycle import (
    Cycle,
    csv_bytes,
    cycle,
    extremes,
    facts,
    force_sentences,
    path,
    path_sentences,
    sentences,
    xlsx_bytes,
)
from vecpoly.cycle import table as tabled
from vecpoly.errors import UnknownNameError
from vecpoly.mechanism.model import Mechanism, Rolling
from vecpoly.problem.problem import Problem
from vecpoly.solution import Solution

from ..family import family
from ..judge import AGREE
from ..nearby import largest, natural, slack
from .anything import anything, used

ROWS = 37
MOTIONS = ("linkage", "class-iii", "cylinder", "motor", "roller", "offset", "pin-in", "forces", "any-forces", "machine")


@used
def over_the_cycle(solution: Solution, rng: np.random.Generator) -> str:
    """Here, at both ends, between the extremes, and in words."""
    mech = solution.problem.subject
    if not isinstance(mech, Mechanism):
        return ""
    turn = cycle(solution.problem, ROWS)
    keys = [column.key for column in turn.columns if column.key != turn.drive.key]
    some = [str(key) for key in rng.permutation(keys)[:3]]
    written = tabled(turn)
    xlsx_bytes(written, turn.name, "zh")
    csv_bytes(written)
    curves(turn, tuple(some), "en").svg()
    found = facts(turn)
    words = [*sentences(turn, found), *force_sentences(turn)]
    for key in keys:
        if key.startswith("p_"):
            words += path_sentences(turn, path(turn, key.removeprefix("p_")))
            break
    if unsaid := [one.en for one in words if not one.zh or "nan" in one.en]:
        return f"it is said that {unsaid[0]}"
    return _here(solution, mech) or _closed(turn, keys, mech) or _within(turn, some, solution.problem)


def _here(solution: Solution, mech: Mechanism) -> str:
    """The row at the given position beside the solution."""
    here, near, floor = cycle(solution.problem, over=[mech.drive.position]), slack(solution), natural(mech)
    for key, answer in solution.answers.items():
        if answer.undefined or answer.reading.unit == "rad":
            continue
        try:
            row = here.column(key)[0]
        except UnknownNameError:
            continue
        exact: complex = answer.exact if answer.exact_vector is None else answer.exact_vector
        if np.iscomplexobj(row) != isinstance(exact, complex):
            row, exact = abs(row), abs(exact)
        if not abs(row - exact) <= AGREE * largest(solution, answer.reading.unit, floor) + near.get(key, 0.0):
            return f"{key} is {exact}, and {row} in the cycle"
    return ""


def _closed(turn: Cycle, keys: list[str], mech: Mechanism) -> str:
    """First and last row are one position, where no gear brings others and no change point leads elsewhere."""
    if (
        not turn.whole
        or any(isinstance(joint, Rolling) for joint in mech.joints)
        or mech.contacts
        or facts(turn).changes
    ):
        return ""
    floor = natural(mech)
    for key in keys:
        values = turn.column(key)
        first, last = complex(values[0]), complex(values[-1])
        if turn.info(key).turns:
            first, last = np.exp(1j * first), np.exp(1j * last)
        if not np.isfinite(values).any() or (np.isnan(first) and np.isnan(last)):
            continue
        size = max(float(np.nanmax(np.abs(values))), floor.get(turn.info(key).unit, 0.0), 1e-9)
        if not abs(first - last) <= 1e-6 * size:
            return f"{key} begins with {first} and ends with {last}"
    return ""


def _within(turn: Cycle, keys: list[str], problem: Problem) -> str:
    """Every row lies between the lowest and the highest value, but for the rounding of what is nothing."""
    assert isinstance(problem.subject, Mechanism)
    acting = [abs(one.size) for one in problem.loads.forces if one.size] if problem.loads is not None else []
    floor = natural(problem.subject) | {"N": max(acting, default=0.0)}
    for key in keys:
        rows, found = turn.real(key), extremes(turn, key)
        rows = rows[np.isfinite(rows)]
        if not rows.size or found.highest is None or found.lowest is None:
            continue
        spare = AGREE * max(float(np.abs(rows).max()), floor.get(turn.info(key).unit, 0.0), 1e-9)
        if rows.max() > found.highest.value + spare or rows.min() < found.lowest.value - spare:
            low, high = found.lowest.value, found.highest.value
            return f"{key} is between {low} and {high}, its rows between {rows.min()} and {rows.max()}"
    return ""


family("used-cycle", also=over_the_cycle, often=1, first=2)(anything("cycle", *MOTIONS))
