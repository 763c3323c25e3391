"""What a problem is about, in words: its own statement, or what its subject says of its task where it has none."""

from __future__ import annotations

from ...designs.base import Design
from ...devices.base import Device
from ...problem.problem import Problem
from ...words import Words


def task(problem: Problem) -> Words:
    """The statement; of a device and of a synthesis without one its own sentence; of a mechanism, which is drawn,
    nothing."""
    subject = problem.subject
    if problem.statement.zh or problem.statement.en or not isinstance(subject, Device | Design):
        return problem.statement
    return subject.task([ask.rel.key for ask in problem.asks])
