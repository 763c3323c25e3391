"""A here or there on its locus, on scratch paper: the linkage with its crank on the line of the frame, both ways."""

from __future__ import annotations

from math import pi

import numpy as np

from ....designs.crank_rocker import NEAREST
from ....designs.verdict import Verdict
from ....plane import Points, nominal
from ....words import Words
from ..draft import Draft
from ..eta import Eta, Locus, Straight
from ..limits.judged import judged
from .rocker import Rocker

_WHAT = Words("求 $A$", "finding $A$")
NOTHING = (float("nan"), float("nan"))


class Track:
    """The left half of a locus, from C₁ (0) to the bisector, or far away (1), in even ratios of the distance."""

    def __init__(self, rocker: Rocker, locus: Locus) -> None:
        self.locus, self._start = locus, rocker.c1
        self.d, self.c1, self.c2 = (complex(nominal(at)) for at in (rocker.d, rocker.c1, rocker.c2))
        self.c, self.chord = abs(self.c1 - self.d), abs(self.c2 - self.c1)

    def turn(self, t: float) -> float:
        """From C₁ the angle about O, away from C₂, as far as the bisector."""
        assert isinstance(self.locus, Eta)
        start = float(np.angle(self.c1 - complex(nominal(self.locus.centre))))
        sweep = (self.locus.side * pi / 2 - start) % (2 * pi)
        sweep = sweep if sweep <= pi else sweep - 2 * pi
        least = NEAREST * self.chord / float(nominal(self.locus.radius))
        return start + float(np.copysign(least * (abs(sweep) / least) ** t, sweep))

    def at(self, t: float) -> complex:
        """The place of A."""
        if isinstance(self.locus, Straight):
            return self.c1 - (self.c2 - self.c1) * (NEAREST + t) / (1 - t)
        return complex(nominal(self.locus.centre) + nominal(self.locus.radius) * np.exp(1j * self.turn(t)))

    def place(self, t: float) -> float:
        """How far A is from C₁ along the locus: the angle about O (deg), or the distance on a straight one (mm)."""
        if isinstance(self.locus, Straight):
            return abs(self.at(t) - self.c1)
        centre = complex(nominal(self.locus.centre))
        return float(np.degrees(abs(self.turn(t) - float(np.angle(self.c1 - centre)))))

    def on_sheet(self, draft: Draft, t: float) -> Points:
        """A there, set out on the sheet."""
        if isinstance(self.locus, Straight):
            line = self.locus.line
            return draft.board.lay_off(line.at, -line.along, abs(self.at(t) - self.c1))
        if self.locus.flat:  # by its distance from C₁, for no angle is set off about a centre off the paper
            there, centre = self.at(t), self.locus.centre
            pair = draft.board.arcs(self._start, abs(there - self.c1), centre, self.locus.radius, _WHAT)
            return min(pair, key=lambda at: abs(complex(nominal(at)) - there))
        return draft.board.lay_off(self.locus.centre, np.exp(1j * self.turn(t)), self.locus.radius)

    def angles(self, t: float) -> tuple[float, float]:
        """The transmission angle (rad) with the crank along the frame, and the other way; NaN where A is no use."""
        a = self.at(t)
        if judged(a, self.d, self.c1, self.c2) is not Verdict.VALID:
            return NOTHING
        near, far = sorted((abs(self.c1 - a), abs(self.c2 - a)))
        crank, coupler, frame = (far - near) / 2, (far + near) / 2, abs(self.d - a)
        return _transmission(frame - crank, coupler, self.c), _transmission(frame + crank, coupler, self.c)


def _transmission(base: float, coupler: float, rocker: float) -> float:
    """∠BCD, or its supplement, over the base BD: C by arcs about B and D."""
    along = (base * base + coupler * coupler - rocker * rocker) / (2 * base)
    c = complex(along, abs(coupler * coupler - along * along) ** 0.5)
    angle = abs(float(np.angle((base - c) / -c)))
    return min(angle, pi - angle)
