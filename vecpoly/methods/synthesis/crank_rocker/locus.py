"""Where A of a crank-rocker with a given θ lies."""

from __future__ import annotations

from dataclasses import dataclass

from ....plane import Line, Points, Reals


@dataclass(frozen=True, slots=True, kw_only=True)
class Rocker:
    """D and the limit positions of the rocker on paper."""

    d: Points
    c1: Points
    c2: Points


@dataclass(frozen=True, slots=True, kw_only=True)
class Eta:
    """A circle from one arc of which C₁C₂ is seen under θ. side: −1 for the arc on the side of D, 1 for the other."""

    centre: Points
    radius: Reals
    side: int
    bisector: Line


@dataclass(frozen=True, slots=True, kw_only=True)
class Straight:
    """The line C₁C₂, where θ = 0."""

    line: Line


Locus = Eta | Straight
