"""Two speeds of one machine: that of the drive in the given position, and the mean one over a period."""

from __future__ import annotations

from ..mechanism.model import Mechanism
from ..problem.problem import Problem
from ..words import Words

DELTA, CLOSE = 0.2, 1e-3  # a machine is hardly less even; speeds that differ by so little are one, rounded


def paced(problem: Problem) -> tuple[Words, ...]:
    """A remark where the drive runs at a speed that the machine, as even as is allowed, never has."""
    subject, machine = problem.subject, problem.machine
    if not isinstance(subject, Mechanism) or machine is None or machine.steady is None:
        return ()
    run, drive = machine.steady, subject.drive
    given = next((datum for datum in problem.given.motion if datum.symbol == f"ω_{drive.link}"), None)
    allowed = (run.delta if run.delta is not None else DELTA) / 2 + CLOSE
    if given is None or abs(abs(drive.rate) - run.speed) <= allowed * run.speed:
        return ()
    n = next(datum for datum in problem.given.loads if datum.symbol == "n")
    return (
        Words(
            f"原动件在题设位置的转速为 {given.text}，而机器的平均转速为 {n.text}，相差超过速度波动；请核对",
            f"in the given position the drive runs at {given.text}, but the machine at {n.text} on the average, "
            "farther apart than its speed fluctuates; check them",
        ),
    )
