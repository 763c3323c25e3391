"""How often a law is tried whose examples are dear: seldom in `make test`, twenty times as often in `make soak`."""

from __future__ import annotations

from hypothesis import settings

HOUSE = 50  # examples of a law in `make test`: tests/conftest.py


def often(count: int) -> int:
    """So many examples in `make test`, as many times more in the soak as any other law has there."""
    return count * settings().max_examples // HOUSE
