"""Dimensions of devices: as quantities in formulas, as lines on sketches."""

from __future__ import annotations

from ....algebra.quantity import Quantity, magnitude
from ....board.paper.marks import Dot, Mark, Point, Role, Vector


def millimetres(symbol: str, metres: float) -> Quantity:
    """A given length as a factor of formulas, in mm."""
    return magnitude(symbol, metres * 1e3, "mm")


def dimension(a: complex, b: complex, symbol: str) -> tuple[Mark, ...]:
    """A thin line with an arrowhead at both ends, and its symbol."""
    return (
        Vector(a=a, b=b, role=Role.CONSTRUCTION),
        Vector(a=b, b=a, role=Role.CONSTRUCTION),
        Point(at=(a + b) / 2, label=symbol, dot=Dot.NONE),
    )
