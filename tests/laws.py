"""How often a law is tried whose examples are dear, and of how many cases a dear claim is made: of few in `make test`,
of many in `make soak`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from hypothesis import settings

Case = TypeVar("Case")
HOUSE, SOAK = 8, 1000  # examples of a law that names no number, in `make test` and in `make soak`
MORE = 40  # times as many of a dear one in the soak


def soaking() -> bool:
    """Whether this is the soak."""
    return settings().max_examples >= SOAK


def often(count: int, soaked: int = 0) -> int:
    """So many examples in `make test`; forty times as many in the soak, or what is said where that is more."""
    return max(count * MORE, soaked) if soaking() else count


def few(cases: Sequence[Case], every: int) -> Sequence[Case]:
    """The first of these cases and every so many-th after it in `make test`, all of them in the soak."""
    return cases if soaking() else cases[::every]
