"""The direction of a vector about the shaft, as its angle is told."""

from __future__ import annotations

from cmath import phase
from math import degrees

WHOLE = 360.0  # degrees
EAST = 1e-9  # degrees below a whole turn: nothing but the rounding of 0


def direction(vector: complex) -> float:
    """From 0° and below 360°: east is 0 however it was rounded."""
    return turned_to(degrees(phase(vector)))


def turned_to(angle: float) -> float:
    """An angle in degrees within one turn."""
    turn = angle % WHOLE
    return 0.0 if turn > WHOLE - EAST else turn
