"""CPU time of the best of several runs, two candidates taken in turn so that both see the same machine."""

from __future__ import annotations

import time
from collections.abc import Callable


def best(*candidates: Callable[[], object], runs: int = 15) -> list[float]:
    """Smallest CPU seconds of each candidate over `runs` interleaved runs."""
    seconds = [float("inf")] * len(candidates)
    for _ in range(runs):
        for i, candidate in enumerate(candidates):
            start = time.process_time()
            candidate()
            seconds[i] = min(seconds[i], time.process_time() - start)
    return seconds
