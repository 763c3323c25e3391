"""How the motion of a machine ends, in words: that it stalls, or swings to and fro, is an answer too."""

from __future__ import annotations

from ..problem.problem import Problem
from ..words import Words


def ending_of(problem: Problem) -> Words | None:
    """Of a problem that follows a machine from a state; nothing of any other. Raises EquilibriumError."""
    machine = problem.machine
    if machine is None or machine.started is None:
        return None
    from ..oracle.machine import ending, motion_of

    return ending(motion_of(problem.mechanism, machine), problem.mechanism.drive.lead)
