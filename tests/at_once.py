"""Problems drawn once, at scales that are given: what the exact hand draws is right at any,
and to choose them takes two more drawings."""

from __future__ import annotations

from dataclasses import replace

from vecpoly.mechanism.model import Mechanism
from vecpoly.methods.scaling import provisional
from vecpoly.problem.problem import Problem, Scales
from vecpoly.solution import Solution, solve


def scaled(problem: Problem) -> Problem:
    """The same problem with scales of about the right size, but for those that it gives itself; as it is where it is
    about no mechanism."""
    if not isinstance(problem.subject, Mechanism):
        return problem
    likely = {view.mu.key: value for view, value in provisional(problem).items()}
    return replace(problem, scales=Scales(likely | dict(problem.scales.given)))


def exactly(problem: Problem) -> Solution:
    """Its solution by the exact hand."""
    return solve(scaled(problem), by="exact", repeats=0, precise=False)
