"""The same class on a Dask cluster of two workers, one of which is killed, has the same bytes."""

from __future__ import annotations

import os
import signal
from pathlib import Path

from distributed import LocalCluster

from tests.batch.homework import TEXT, files, made, people
from vecpoly.batch.classwork import Order, make_class
from vecpoly.batch.runners import Cluster, runner
from vecpoly.problem.assignment import load_assignment
from vecpoly.words import Words

CLASS = people(range(24))


def test_a_worker_that_is_killed_takes_no_sheet_with_it(tmp_path: Path) -> None:
    made(tmp_path / "alone" / "hw", CLASS)
    file = tmp_path / "hw3.yaml"
    file.write_text(TEXT, encoding="utf-8")
    order = Order(assignment=load_assignment(file), students=CLASS, out=tmp_path / "many", lang="zh", version="test")
    killed: list[int] = []
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:

        def told(_: Words, done: int, of: int) -> None:
            if done and not killed:
                killed.append(next(iter(cluster.workers.values())).pid)
                os.kill(killed[0], signal.SIGKILL)

        with runner(1, cluster.scheduler_address) as run:
            assert isinstance(run, Cluster)
            make_class(order, run, told)
    assert killed
    assert files(tmp_path / "many") == files(tmp_path / "alone" / "hw")
