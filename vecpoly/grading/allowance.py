"""How far off a right drawing may be: the scatter of a student's hand, and the bounds of a tolerance."""

from __future__ import annotations

from dataclasses import dataclass
from math import radians, sqrt

import numpy as np

from ..board.hand import EXACT, Hand, Skill

UNIFORM_TWICE = sqrt(
    6.0
)  # graduation over σ of what is read by it: jitter and rounding, each uniform over one graduation
REPEATS = 300


@dataclass(frozen=True, slots=True, kw_only=True)
class Allowance:
    """σ of plotting (mm), of a direction (deg), of a reading (mm);
    T = k σ, at least `floor` (mm), at most `cap` (mm) and `share`.

    A value beyond `wrong` T is wrong; direction: what a vector's direction may be off (deg), where it is at least
    `short` mm long. arithmetic: share of a value that is found by formula alone. reading: ruler (mm), of own mm × own
    μ. squares: σ of an area (mm²) over the root of its perimeter (mm); 0: a program measures it.
    """

    plot: float = 0.25
    set_square: float = 0.5
    read: float = 0.25
    k: float = 2.0
    floor: float = 1.0
    cap: float = 5.0
    share: float = 0.15
    wrong: float = 1.5
    direction: float = 2.5
    short: float = 5.0
    arithmetic: float = 0.01
    reading: float = 0.5
    squares: float = 0.3

    def hand(self, repeats: int = REPEATS) -> Hand:
        """An exact hand, and beside it as many students' hands."""
        student = Skill(
            reading=UNIFORM_TWICE * self.read,
            protractor=UNIFORM_TWICE * radians(self.set_square),
            dividers=self.plot,
            square=radians(self.set_square),
            squares=self.squares,
            whole=1.0 if self.squares else 0.0,
            planimeter=10.0 if self.squares else 0.0,
        )
        return Hand("exact", EXACT, student, repeats, np.random.Generator(np.random.PCG64(0)))


STUDENT = Allowance()  # with pencil, rule and set squares
CAD = Allowance(
    plot=0.02, set_square=0.05, read=0.02, floor=0.1, direction=0.2, reading=0.05, arithmetic=0.005, squares=0.0
)
