"""Who does the work: this process, several on this machine, or a Dask cluster; all give the same results."""

from __future__ import annotations

import multiprocessing
import os
import threading
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from ...errors import ArgumentError, MissingPackageError
from ...foundation.running.rubbish import seldom_looked_for
from ...words import Words

Done = tuple[int, Any]  # the number of a task, and its result
RETRIES = 3


class Task(Protocol):
    """A piece of work that can be sent elsewhere, and is the same wherever it is done."""

    @property
    def address(self) -> str: ...

    def run(self, out: Path) -> Any:
        """Do it, and keep the result under the address."""
        ...


class Runner(Protocol):
    """Does tasks, in whatever order."""

    def each(self, tasks: Sequence[Task], out: Path) -> Iterator[Done]:
        """The results as they come."""
        ...


@dataclass(frozen=True, slots=True)
class Here:
    """One after another, in this process."""

    def each(self, tasks: Sequence[Task], out: Path) -> Iterator[Done]:
        """The results in order."""
        for number, task in enumerate(tasks):
            yield number, task.run(out)


@dataclass(frozen=True, slots=True)
class Processes:
    """On several processors of this machine."""

    pool: ProcessPoolExecutor

    def each(self, tasks: Sequence[Task], out: Path) -> Iterator[Done]:
        """The results as they come."""
        waiting: dict[Future[Any], int] = {self.pool.submit(_run, task, out): n for n, task in enumerate(tasks)}
        yield from _as_done(waiting)


@dataclass(frozen=True, slots=True)
class Cluster:
    """On the workers of a Dask scheduler, who must see the same folder; what a lost worker did is done again
    elsewhere."""

    client: Any

    def each(self, tasks: Sequence[Task], out: Path) -> Iterator[Done]:
        """The results as they come."""
        from distributed import as_completed

        where = out.resolve()
        futures = {
            self.client.submit(_run, task, where, key=f"vecpoly-{task.address}", retries=RETRIES): n
            for n, task in enumerate(tasks)
        }
        for future in as_completed(list(futures)):
            yield futures[future], future.result()


def _as_done(waiting: dict[Future[Any], int]) -> Iterator[Done]:
    left = set(waiting)
    while left:
        done, left = wait(left, return_when=FIRST_COMPLETED)
        yield from ((waiting[one], one.result()) for one in done)


def _run(task: Task, out: Path) -> Any:
    return task.run(out)


@contextmanager
def runner(jobs: int, dask: str | None = None) -> Iterator[Runner]:
    """The runner for so many processes, or for the scheduler at this address. Raises MissingPackageError where Dask is
    not installed."""
    if dask is not None:
        with _client(dask) as client:
            yield Cluster(client)
    elif jobs <= 1:
        yield Here()
    else:
        context = multiprocessing.get_context("forkserver" if hasattr(os, "fork") else "spawn")
        if hasattr(os, "fork"):
            context.set_forkserver_preload(["vecpoly.batch.run.tasks"])
        with ProcessPoolExecutor(jobs, mp_context=context, initializer=_begun_by, initargs=(os.getpid(),)) as pool:
            try:
                yield Processes(pool)
            except (KeyboardInterrupt, BrokenProcessPool):
                pool.shutdown(wait=False, cancel_futures=True)
                raise


def _client(address: str) -> Any:
    try:
        from distributed import Client
    except ImportError:
        raise MissingPackageError(
            Words(
                '--dask 需要 Dask：pip install "vecpoly[cluster]"；不用 --dask 则在本机运行',
                '--dask needs Dask: pip install "vecpoly[cluster]"; without --dask this machine does the work',
            )
        ) from None
    try:
        return Client(address)
    except (ValueError, TypeError, OSError) as error:
        raise ArgumentError(
            Words(
                f"--dask {address}：连不上调度器（{error}）；请写它的地址，如 tcp://10.0.0.1:8786",
                f"--dask {address}: there is no scheduler ({error}); write its address, as tcp://10.0.0.1:8786",
            ),
            code="dask",
        ) from None


def _begun_by(parent: int) -> None:
    """A worker looks for rubbish seldom, and leaves when its master was killed instead of waiting for ever."""
    seldom_looked_for()

    def watch() -> None:
        while _lives(parent):
            time.sleep(1.0)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


def _lives(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    return True
