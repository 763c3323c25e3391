"""Moments over an angle: the work that a square millimetre is, and the constant moment of equal area."""

from __future__ import annotations

from itertools import count

from ...algebra.quantity import Expr, Quantity, Sum
from ...board.acts import Way
from ...board.board import Board
from ...board.construction import Place
from ...board.otherwise.slip import Chance, Mistake
from ...board.paper.marks import Dot
from ...plane import nominal
from .graph import Graph, axis
from .lobes import Lobe, lobes_between, middle_of


def work_scale(board: Board, place: Place) -> Quantity:
    """μ_A = μ_M μ_φ (J/mm²), μ_φ in radians."""
    return board.compute("μ_A", board.mu(place) * board.mu_across(place), "J/mm^2", chances=(Chance(Mistake.DEGREES),))


def equal_height(board: Board, place: Place, graph: Graph, way: Way) -> Expr:
    """The height of a rectangle over the whole period that has the area under a curve: M = μ_M Σ ± S / OT."""
    under = lobes_between(board, place, graph, axis(graph), (), way, "S")
    for lobe, number in zip(under.lobes, count(1), strict=False):
        board.plot(place, middle_of(lobe.outline), f"S_{number}", Dot.NONE)
    for end, letter in ((under.ends[0], "O"), (under.ends[-1], "T")):
        board.plot(place, end, letter, Dot.NONE)
    long = board.measure(under.ends[0], under.ends[-1], "O T")
    return board.mu(place) * _whole(under.lobes) / long


def _whole(lobes: tuple[Lobe, ...]) -> Expr:
    """What lies above the axis less what lies below it."""
    if len(lobes) == 1 and nominal(lobes[0].sign) > 0:
        return lobes[0].area
    return Sum(tuple(lobe.area for lobe in lobes), tuple(1 if nominal(lobe.sign) > 0 else -1 for lobe in lobes))
