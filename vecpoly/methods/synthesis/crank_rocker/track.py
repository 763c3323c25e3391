"""A here or there on its locus, on scratch paper: the linkage with its crank on the line of the frame, both ways."""

from __future__ import annotations

from functools import cached_property
from math import nan, pi
from typing import Any

import numpy as np

from ....designs.crank_rocker import NEAREST
from ....plane import Points, nominal
from ....words import Words
from ..draft import Draft
from ..eta import Eta, Locus, Straight
from ..limits.judged import useful
from .rocker import Rocker

_WHAT = Words("求 $A$", "finding $A$")


class Track:
    """The left half of a locus, from C₁ (0) to the bisector, or far away (1), in even ratios of the distance."""

    def __init__(self, rocker: Rocker, locus: Locus) -> None:
        self.locus, self._start = locus, rocker.c1
        self.d, self.c1, self.c2 = (complex(nominal(at)) for at in (rocker.d, rocker.c1, rocker.c2))
        self.c, self.chord = abs(self.c1 - self.d), abs(self.c2 - self.c1)

    @cached_property
    def _round(self) -> tuple[complex, float, float, float]:
        """The circle's centre and radius, the direction of C₁ from O, and the angle from there away from C₂ as far as
        the bisector."""
        assert isinstance(self.locus, Eta)
        centre = complex(nominal(self.locus.centre))
        start = float(np.angle(self.c1 - centre))
        sweep = (self.locus.side * pi / 2 - start) % (2 * pi)
        return centre, float(nominal(self.locus.radius)), start, sweep if sweep <= pi else sweep - 2 * pi

    def turn(self, t: Any) -> Any:
        """The direction of A from O."""
        _, radius, start, sweep = self._round
        least = NEAREST * self.chord / radius
        return start + np.copysign(least * (abs(sweep) / least) ** t, sweep)

    def at(self, t: Any) -> Any:
        """The place of A, or many."""
        if isinstance(self.locus, Straight):
            return self.c1 - (self.c2 - self.c1) * (NEAREST + t) / (1 - t)
        centre, radius, *_ = self._round
        return centre + radius * np.exp(1j * self.turn(t))

    def place(self, t: Any) -> Any:
        """How far A is from C₁ along the locus: the angle about O (deg), or the distance on a straight one (mm)."""
        if isinstance(self.locus, Straight):
            return abs(self.at(t) - self.c1)
        return np.degrees(abs(self.turn(t) - self._round[2]))

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

    def angles(self, t: Any) -> tuple[Any, Any]:
        """The transmission angle (rad) with the crank along the frame, and the other way; NaN where A is no use."""
        a = self.at(t)
        one, other, frame = abs(self.c1 - a), abs(self.c2 - a), abs(self.d - a)
        crank, coupler = abs(other - one) / 2, (one + other) / 2
        use = useful(a, self.d, self.c1, self.c2)
        near, far = (_transmission(base, coupler, self.c) for base in (frame - crank, frame + crank))
        return np.where(use, near, nan), np.where(use, far, nan)

    def least(self, t: Any) -> Any:
        """The lesser of both."""
        return np.minimum(*self.angles(t))


def _transmission(base: Any, coupler: Any, rocker: float) -> Any:
    """∠BCD, or its supplement, over the base BD: C by arcs about B and D."""
    along = (base * base + coupler * coupler - rocker * rocker) / (2 * base)
    c = along + 1j * np.sqrt(abs(coupler * coupler - along * along))
    angle = abs(np.angle((base - c) / -c))
    return np.minimum(angle, pi - angle)
