"""Dimension lines on the sketches of devices."""

from __future__ import annotations

from ...board.marks import Mark, Note, Role, Vector
from ...words import Words


def dimension(a: complex, b: complex, symbol: str) -> tuple[Mark, ...]:
    """A thin line with an arrowhead at both ends, and its symbol."""
    return (Vector(a=a, b=b, role=Role.CONSTRUCTION), Vector(a=b, b=a, role=Role.CONSTRUCTION), Note(at=(a + b) / 2, words=Words.same(f"${symbol}$")))
