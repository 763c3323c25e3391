"""Dimensions of devices: as quantities in formulas, as lines on sketches."""

from __future__ import annotations

from ....algebra.quantity import Quantity, magnitude
from ....board.construction import Place
from ....board.paper.marks import Dot, Role
from ..bench import Bench


def millimetres(symbol: str, metres: float) -> Quantity:
    """A given length as a factor of formulas, in mm."""
    return magnitude(symbol, metres * 1e3, "mm")


def dimension(bench: Bench, place: Place, a: complex, b: complex, symbol: str) -> None:
    """A thin line with an arrowhead at both ends, and its symbol."""
    bench.board.arrow(place, a, b, Role.CONSTRUCTION)
    bench.board.arrow(place, b, a, Role.CONSTRUCTION)
    bench.board.plot(place, (a + b) / 2, symbol, Dot.NONE)
