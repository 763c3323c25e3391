"""A problem drawn again after a small change, scales held and letters carried on, against its solution alone; and the
same problem drawn by another hand, its scales remembered."""

from __future__ import annotations

from dataclasses import replace
from itertools import count

from vecpoly.live import redraw
from vecpoly.problem.load import load
from vecpoly.problem.problem import Problem
from vecpoly.solution import solve

from .timing import best

PROBLEMS = {"3-12": 12, "six-bar-dynamic": 30}  # a six-bar with polygons, one with forces: milliseconds aimed at


def run() -> str:
    """One line of the report."""
    return "drawn again, warm: " + "; ".join(_one(load(name), aim) for name, aim in PROBLEMS.items())


def _one(problem: Problem, aim: int) -> str:
    steps = count(1)
    last = redraw(solve(problem, repeats=0, precise=False), problem)
    again, alone, known = best(
        lambda: redraw(last, turned(problem, 1e-4 * next(steps))),
        lambda: solve(turned(problem, 1e-4 * next(steps)), repeats=0, precise=False),
        lambda: solve(problem, repeats=0, precise=False),
        runs=20,
    )
    return (
        f"{problem.id} {again * 1e3:.1f} ms (aim ≤ {aim}) = {again / alone:.2f} × solving it alone "
        f"({alone * 1e3:.1f} ms), solved once more {known / alone:.2f} ×"
    )


def turned(problem: Problem, by: float) -> Problem:
    """The problem with its drive a little further on."""
    mech = problem.mechanism
    return replace(
        problem,
        subject=replace(mech, drives=(replace(mech.drive, position=mech.drive.position + by), *mech.drives[1:])),
    )


if __name__ == "__main__":
    print(run())
