"""A force on a link as it is known while forces are being found:
its vector on the polygon, where it acts, where it stands on paper."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from ...algebra.quantity import Quantity
from ...board.construction import Place
from ...foundation.slotted import replace
from ...names import Named
from ...plane import Line, Points, Reals, nominal
from ...vector.equation import KNOWN
from ...words import Words

NO_LETTER = "—"  # of an end of a force that stands on no polygon
OTHER_END = "′"  # behind the name of a cylinder's thrust, or a spring's force: the opposite one
ROUNDING = 1e-13  # of the largest part: a smaller sum is rounding


def summed(parts: Iterable[Reals]) -> Reals:
    """The sum; zero where the nominal hand's parts cancel but for rounding."""
    every = list(parts)
    total: Reals = sum(every, 0.0)
    return (
        total
        if abs(float(nominal(total))) > ROUNDING * max((abs(float(nominal(part))) for part in every), default=0.0)
        else 0.0
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawn:
    """Where a force stands on a polygon: figure, start, end, letters; laid: of one that was laid off as it had been
    computed, and is not read, its size (N)."""

    place: Place
    start: Points
    end: Points
    letters: str
    laid: Quantity | None = None

    def reversed(self) -> Drawn:
        """The opposite force."""
        first, last = self.letters.split()
        return replace(self, start=self.end, end=self.start, letters=f"{last} {first}")


@dataclass(frozen=True, slots=True, kw_only=True)
class Acting:
    """A force on a link: its name, its vector on the polygon, a point of its line of action; its two table entries.

    couple: what a slide passes on beside a force of zero (N·m). computed:
    the size (N) of a force that stands on no polygon.
    """

    named: Named
    vector: Points
    at: Points
    direction: Words = KNOWN
    size: str = "✓"
    drawn: Drawn | None = None
    tangent: int = 0  # sense of its moment about a pin whose friction circle it touches
    couple: Reals = 0.0
    computed: Reals | None = None

    @property
    def line(self) -> Line:
        """The line of action, along the force."""
        return Line(self.at, self.vector / np.abs(self.vector))
