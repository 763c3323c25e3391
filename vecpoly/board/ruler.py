"""Ruler and protractor: a segment is read once, from whichever end,
and that reading is used wherever the segment is meant again."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..plane import Points, Reals
from ..plane.geometry import dot
from ..plane.traced import bare
from .hand import Hand

READABLE = 3.0  # mm: what is shorter on paper is too short to be measured
Ends = frozenset[bytes]  # the two ends of a segment, by every hand


class Ruler:
    """The readings of one sheet."""

    def __init__(self, hand: Hand) -> None:
        self._hand = hand
        self._lengths: dict[Ends, Reals] = {}
        self._bearings: dict[Ends, Points] = {}

    def length(self, a: Points, b: Points, noted: Callable[[Reals], Reals]) -> Reals:
        """|b − a| as read (mm), and noted when it is read for the first time."""
        segment = _ends(a, b)
        if segment not in self._lengths:
            self._lengths[segment] = noted(self._hand.read(np.abs(bare(b) - bare(a))))
        return self._lengths[segment]

    def bearing(self, a: Points, b: Points, noted: Callable[[Points], Points]) -> Points:
        """The direction from a to b as read, a unit vector, and noted when it is read for the first time."""
        segment = _ends(a, b)
        if segment not in self._bearings:
            self._bearings[segment] = noted(np.exp(1j * self._hand.gauge(np.angle(bare(b) - bare(a)))))
        read: Points = self._bearings[segment] * np.where(
            dot(bare(self._bearings[segment]), bare(b) - bare(a)) < 0, -1, 1
        )
        return read


def _ends(a: Points, b: Points) -> Ends:
    return frozenset(np.asarray(bare(end) + 0j, dtype=np.complex128).tobytes() for end in (a, b))
