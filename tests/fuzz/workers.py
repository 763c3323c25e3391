"""Worker processes with a limit of time: a worker that hangs is ended, and another takes its place."""

from __future__ import annotations

import multiprocessing as mp
from collections.abc import Callable, Iterable, Iterator
from multiprocessing.connection import Connection

from .outcome import End, Outcome

LIMIT = 5.0  # s


def _work(pipe: Connection, act: Callable[[str], Outcome]) -> None:
    while True:
        task = pipe.recv()
        if task is None:
            return
        pipe.send(act(task))


class Worker:
    """One process that does one task after another."""

    def __init__(self, act: Callable[[str], Outcome]) -> None:
        self.act = act
        self._start()

    def _start(self) -> None:
        self.pipe, inner = mp.Pipe()
        self.process = mp.get_context("fork").Process(target=_work, args=(inner, self.act), daemon=True)
        self.process.start()
        inner.close()

    def outcome(self, task: str, limit: float = LIMIT) -> Outcome:
        """What became of the task."""
        self.pipe.send(task)
        if not self.pipe.poll(limit):
            self._restart()
            return Outcome(End.HANG, f"more than {limit:g} s")
        try:
            found: Outcome = self.pipe.recv()
            return found
        except EOFError:
            self._restart()
            return Outcome(End.TRACEBACK, "the process died")

    def _restart(self) -> None:
        self.process.kill()
        self.process.join()
        self._start()

    def close(self) -> None:
        """End it."""
        self.process.kill()
        self.process.join()


def outcomes(act: Callable[[str], Outcome], tasks: Iterable[str], limit: float = LIMIT) -> Iterator[tuple[str, Outcome]]:
    """Each task with what became of it."""
    worker = Worker(act)
    try:
        for task in tasks:
            yield task, worker.outcome(task, limit)
    finally:
        worker.close()
