"""On which side of its point a force is drawn."""

from __future__ import annotations

from collections.abc import Iterable

from .marks import Mark, Vector


def pulls(marks: Iterable[Mark], symbol: str, at: complex) -> bool | None:
    """Whether the arrow of this symbol begins at the place rather than ends there; None where there is none."""
    arrow = next((mark for mark in marks if isinstance(mark, Vector) and mark.label == symbol), None)
    return None if arrow is None else abs(arrow.a - at) < abs(arrow.b - at)
