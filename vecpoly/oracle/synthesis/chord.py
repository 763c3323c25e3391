"""The limit positions of a rocker, and the linkages whose crank sees them under θ."""

from __future__ import annotations

from math import cos, nan, pi, sin, sqrt
from typing import Any

import numpy as np

from ...designs.crank_rocker import NEAREST, CrankRocker
from ...designs.verdict import Verdict
from .four_bar import NEAR, found
from .registry import Linkage

SIDES = (-1, 1)  # A below the chord C₁C₂, where D is, or above it


class Chord:
    """The limit positions, evenly beside the y axis with D in the origin: C₁, C₂ = (∓s/2, m)."""

    def __init__(self, design: CrankRocker) -> None:
        assert design.swing is not None
        self.c, self.theta = design.CD.si, design.theta
        self.s, self.m = 2 * self.c * sin(design.swing.si / 2), self.c * cos(design.swing.si / 2)
        self.ends = complex(-self.s / 2, self.m), complex(self.s / 2, self.m)

    def at(self, a_pin: complex, verdict: Verdict | None = None) -> Linkage:
        """The candidate with this A."""
        return found(a_pin, 0j, *self.ends, verdict)

    def pivot(self, a: Any, b: Any, side: int) -> Any:
        """A of the crank a and coupler b, or of many, on the left: 2 s x = AC₁² − AC₂² = −4 a b."""
        x = -2 * a * b / self.s
        if not self.theta:
            return x + 1j * self.m
        return x + 1j * (self.m + side * np.sqrt(np.maximum((b - a) ** 2 - (x + self.s / 2) ** 2, 0.0)))

    def coupler(self, a: float) -> float:
        """b of a crank by the law of chords; NaN where there is none."""
        square = self.s**2 - (2 * a * cos(self.theta / 2)) ** 2
        return sqrt(square) / (2 * sin(self.theta / 2)) if square > 0 else nan

    def of_crank(self, a: float, side: int) -> Linkage:
        """The candidate with this crank."""
        return self.at(complex(self.pivot(a, self.coupler(a), side)))

    def tried(self, t: Any, side: int) -> Any:
        """A of a candidate of all, t from 0 to 1: from A in C₁ to A on the bisector, or far away where K = 1.

        a = s cos u / (2 cos(θ/2)), b = s sin u / (2 sin(θ/2)), u from θ/2 to 90° in even ratios.
        """
        if self.theta:
            return self._at(self.theta / 2 * (pi / self.theta) ** t, side)
        return self.pivot(self.s / 2, self.s / 2 / (1 - t), -1)

    def near(self, t: Any, side: int) -> Any:
        """The same in even ratios of AC₁ = C₁C₂ sin(u − θ/2) / sin θ, from the nearest that is sought."""
        if not self.theta:
            return self.tried(2 * NEAREST + (1 - 2 * NEAREST) * t, side)
        half, least = self.theta / 2, NEAREST * sin(self.theta)
        return self._at(half + least * ((pi / 2 - half) / least) ** t, side)

    def _at(self, u: Any, side: int) -> Any:
        half = self.theta / 2
        return self.pivot(self.s / 2 * np.cos(u) / cos(half), self.s / 2 * np.sin(u) / sin(half), side)

    def sees(self, a_pin: complex, side: int) -> Verdict | None:
        """That from A the chord is seen under π − θ, where it is."""
        return None if side * (a_pin.imag - self.m) > NEAR * self.c else Verdict.FAR_ARC
