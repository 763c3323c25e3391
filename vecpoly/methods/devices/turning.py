"""Curved arrows about shafts: the senses of ω and of moments."""

from __future__ import annotations

from cmath import phase

from ...board.board import Board
from ...board.construction import Place
from ...board.paper.marks import TURN


def arrow_about(board: Board, place: Place, at: complex, radius: float, middle: complex, ccw: bool, label: str) -> None:
    """A curved arrow about a point, the middle of which stands in a direction."""
    half = TURN / 2 if ccw else -TURN / 2
    board.curved_arrow(place, at, radius, phase(middle) - half, ccw, label)
