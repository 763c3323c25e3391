"""The same class on a Dask cluster of two workers, one of which is killed, has the same bytes."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import dask.config
import pytest
from distributed import LocalCluster

from tests.batch.homework import FOUR, files, ordered, piloted
from vecpoly.batch.classwork import Made, make_class
from vecpoly.batch.run.runners import Cluster, runner
from vecpoly.errors import ArgumentError
from vecpoly.words import Words


def test_a_worker_that_is_killed_takes_no_sheet_with_it(whole: tuple[Path, Made], tmp_path: Path) -> None:
    killed: list[int] = []
    with (
        dask.config.set({"distributed.worker.multiprocessing-method": "forkserver"}),  # all import Dask once
        LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
    ):

        def told(_: Words, done: int, of: int) -> None:
            if done and not killed:
                killed.append(next(iter(cluster.workers.values())).pid)
                os.kill(killed[0], signal.SIGKILL)

        with runner(1, cluster.scheduler_address) as run, piloted():
            assert isinstance(run, Cluster)
            make_class(ordered(tmp_path / "hw", FOUR), run, told)
    assert killed
    assert files(tmp_path / "hw") == files(whole[0])


@pytest.mark.parametrize("address", ["nonsense", "http://10.0.0.1:8786", ""])
def test_what_is_no_scheduler_is_refused_with_how_one_is_named(address: str) -> None:
    """It ended in a traceback of Dask."""
    with pytest.raises(ArgumentError, match=r"there is no scheduler .*tcp://10\.0\.0\.1:8786"), runner(1, address):
        pass
