"""Problems solved and studied for the course report, once for all files that make claims about them."""

from __future__ import annotations

from functools import cache

from vecpoly.findings.study.study import Study, study
from vecpoly.problem.load import load
from vecpoly.solution import Solution, solve


@cache
def solved(name: str) -> Solution:
    """The problem of the library, drawn once and not repeated."""
    return solve(load(name), repeats=0)


@cache
def studied(name: str) -> Study:
    """What the course report of this problem is about."""
    return study(solved(name))
