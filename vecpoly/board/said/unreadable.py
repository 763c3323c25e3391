"""What is said of a quantity whose lines on paper have no length."""

from __future__ import annotations

from ...errors import NotAskedError
from ...words import Words


def unreadable(symbol: str) -> NotAskedError:
    """That it cannot be read, and what to do."""
    return NotAskedError(
        Words(
            f"{symbol} 无从量取：图上相应的线段没有长度；请检查各长度是否相差过大，或用 vecpoly exact",
            f"{symbol} cannot be read: its lines on paper have no length; check whether the given "
            "lengths are too unlike, or use 'vecpoly exact'",
        ),
        code="unreadable",
    )
