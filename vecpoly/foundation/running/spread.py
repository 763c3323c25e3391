"""Work spread over processes: each result in its turn, each error where its result would have been."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import TypeVar

A = TypeVar("A")
B = TypeVar("B")


def spread(work: Callable[[A], B], items: Sequence[A], jobs: int) -> Iterator[Callable[[], B]]:
    """For every item, in order, what gives its result or raises its error: done when called where there is one job or
    one item, else by so many processes at once."""
    if jobs < 2 or len(items) < 2:
        yield from (partial(work, item) for item in items)
        return
    from concurrent.futures import ProcessPoolExecutor

    with ProcessPoolExecutor(min(jobs, len(items))) as pool:
        yield from (future.result for future in [pool.submit(work, item) for item in items])
