"""Curves of a cycle in one restrained style: quantities over the drive's position, hodographs, paths of points, the
mechanism in several positions.

    plot = curves(turn, ("omega_4", "omega_5"), "zh")
    plot.scene                                   # a drawing of the house: into a report, true to size, fonts embedded
    plot.svg(), plot.pdf(), plot.png(), plot.figure   # bytes, or the matplotlib Figure (1 pixel = 1 mm)

Import this part inside a function: it brings matplotlib along.
"""

from __future__ import annotations

from .given import given_values
from .hodograph import hodograph
from .over import curves
from .plot import Plot
from .poses import poses
from .trace import trace

__all__ = ["Plot", "curves", "given_values", "hodograph", "poses", "trace"]
