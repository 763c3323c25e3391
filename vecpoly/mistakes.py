"""The mistakes that can be made with a problem."""

from __future__ import annotations

from .board.hand import hand
from .board.otherwise.amended import AS_DRAWN
from .board.otherwise.possible import slips_of
from .board.otherwise.slip import Slip
from .problem.problem import Problem
from .solution import constructed


def slips(problem: Problem) -> tuple[Slip, ...]:
    """Every mistake that can be made in the solution, each once; `solve(problem, slip=...)` draws the solution of one
    who makes it."""
    return slips_of(constructed(problem, hand("exact"), AS_DRAWN).construction.acts)
