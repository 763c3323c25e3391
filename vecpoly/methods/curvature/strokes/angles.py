"""An angle carried with the compass to another line through the pole."""

from __future__ import annotations

import numpy as np

from ....plane import Points, nominal, unit
from ....words import Words
from ..state import CurvatureFigure

ARC, STEP = 14.0, 5.0  # mm: radius of the first pair of arcs; that of the next is larger
TINY = 1e-7  # rad: no angle at all


def carry_angle(fig: CurvatureFigure, between: tuple[Points, Points], onto: Points, label: str) -> Points:
    """The direction to which `onto` makes the angle of the two lines `between`: equal arcs, the chord carried over."""
    board, pole = fig.board, fig.pole
    first, second = between
    if float(nominal(np.real(np.conj(first) * second))) < 0:  # the smaller of the two angles of the lines
        second = -second
    turned = float(np.angle(nominal(np.conj(first) * second)))
    if abs(turned) < TINY:
        return board.turn(onto)
    radius = ARC + STEP * sum(1 for name in fig.taken if name.startswith("ψ"))
    fig.taken.add(label)
    start, end, corner = pole + radius * first, pole + radius * second, pole + radius * onto
    left, right = board.arcs(pole, radius, corner, np.abs(end - start), Words("移取角度", "carrying the angle over"))
    found = unit(board.locate(fig.pane, label, left if turned > 0 else right, found_on=True) - pole)
    pane, ratio = fig.sheet(name=fig.p)
    for base in (first, onto):
        board.angle(pane, pole * ratio, base, turned, radius, label)
    return found
