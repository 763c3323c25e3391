"""Worker processes with a limit of time: a worker that hangs is ended, and another takes its place.

A hang is told by the time that the processor spends on the task, which does not depend on what else the machine does;
the clock on the wall only catches what sleeps.
"""

from __future__ import annotations

import multiprocessing as mp
import signal
from collections.abc import Callable, Iterable, Iterator
from multiprocessing.connection import Connection

from .outcome import End, Outcome

LIMIT = 5.0  # s of the processor
PATIENCE = 120.0  # s of the clock


def _work(pipe: Connection, act: Callable[[str], Outcome], limit: float) -> None:
    signal.signal(signal.SIGPROF, signal.SIG_DFL)  # it ends the process, whatever it is busy with
    while True:
        task = pipe.recv()
        signal.setitimer(signal.ITIMER_PROF, limit)
        found = act(task)
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        pipe.send(found)


class Worker:
    """One process that does one task after another."""

    def __init__(self, act: Callable[[str], Outcome], limit: float = LIMIT) -> None:
        self.act, self.limit = act, limit
        self._start()

    def _start(self) -> None:
        self.pipe, inner = mp.Pipe()
        self.process = mp.get_context("fork").Process(target=_work, args=(inner, self.act, self.limit))
        self.process.start()
        inner.close()

    def outcome(self, task: str, patience: float = PATIENCE) -> Outcome:
        """What became of the task."""
        self.pipe.send(task)
        if not self.pipe.poll(patience):
            self._restart()
            return Outcome(End.HANG, f"more than {patience:g} s by the clock")
        try:
            found: Outcome = self.pipe.recv()
            return found
        except EOFError:
            return self._died()

    def _died(self) -> Outcome:
        self.process.join()
        hung = self.process.exitcode == -signal.SIGPROF
        self._start()
        return (
            Outcome(End.HANG, f"more than {self.limit:g} s of the processor")
            if hung
            else Outcome(End.TRACEBACK, "the process died")
        )

    def _restart(self) -> None:
        self.process.kill()
        self.process.join()
        self._start()

    def close(self) -> None:
        """End it."""
        self.process.kill()
        self.process.join()


def outcomes(
    act: Callable[[str], Outcome], tasks: Iterable[str], limit: float = LIMIT
) -> Iterator[tuple[str, Outcome]]:
    """Each task with what became of it."""
    worker = Worker(act, limit)
    try:
        for task in tasks:
            yield task, worker.outcome(task)
    finally:
        worker.close()
