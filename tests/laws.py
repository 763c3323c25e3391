"""How often a law is tried whose examples are dear: seldom in `make test`, twenty times as often in `make soak`."""

from __future__ import annotations

from hypothesis import settings

HOUSE, SOAK = 25, 1000  # examples of a law that names no number, in `make test` and in `make soak`
MORE = 20  # times as many of a dear one in the soak


def often(count: int) -> int:
    """So many examples in `make test`, twenty times as many in the soak."""
    return count * (MORE if settings().max_examples >= SOAK else 1)
