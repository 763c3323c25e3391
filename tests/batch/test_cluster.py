"""The same class on a Dask cluster of two workers, one of which is killed, has the same bytes."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import dask.config
from distributed import LocalCluster

from tests.batch.homework import FOUR, files, ordered, piloted
from vecpoly.batch.classwork import Made, make_class
from vecpoly.batch.run.runners import Cluster, runner
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
