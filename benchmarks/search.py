"""A million candidates of each search, scored on two processes. Aim: 20 s on two idle cores.

Run: python -m benchmarks.search
"""

from __future__ import annotations

import resource
from time import perf_counter

from vecpoly.foundation.running.spread import spread
from vecpoly.search.base import Search
from vecpoly.search.run import BLOCK, Block, scored
from vecpoly.search.spec import load_search

COUNT, JOBS, AIM = 1_000_000, 2, 20.0


def seconds(search: Search) -> tuple[float, float]:
    """Of the clock, and of both processors together."""
    blocks = [Block(search, BLOCK, (1, i)) for i in range(COUNT // BLOCK)]
    start, used = perf_counter(), _used()
    for one in spread(scored, blocks, JOBS):
        one()
    return perf_counter() - start, _used() - used


def _used() -> float:
    both = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(one.ru_utime + one.ru_stime for one in both)


def run() -> str:
    """One line of the report."""
    told = []
    for name in ("path", "dwell", "transmission"):
        clock, used = seconds(load_search(f"search-{name}")[0])
        told.append(f"{name} {clock:.1f} s ({used:.1f} s of CPU)")
    return f"search, {COUNT:,} candidates on {JOBS} processes: {', '.join(told)}; aim {AIM:g} s of two idle cores"


if __name__ == "__main__":
    print(run())
