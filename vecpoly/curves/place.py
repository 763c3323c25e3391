"""Lettering put where it covers nothing: each text tries places around its point and takes the freest."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..drawing.style import Hue
from ..typeset import layout_words
from . import style

Points = NDArray[np.complex128]
Spot = tuple[complex, complex, float]  # the middle of a text, and in which direction of its point and how far from it
WAYS = np.exp(2j * np.pi * np.arange(16) / 16)
_OWN = 1.3  # mm about a point of a curve: there runs the curve itself
NEAR = (1.5, 2.4, 3.6, 5.0)  # mm from the point to the text
STEP, AROUND = 0.5, complex(20.0, 20.0)  # mm: from point to point of a line; beyond the axes no line is looked at


class Placer:
    """Texts of one pair of axes (data to mm), with the lines and texts that are there already."""

    def __init__(self, at: Any, lines: list[Points]) -> None:
        self.at = at
        low, high = (complex(*at.transAxes.transform(corner)) for corner in ((0, 0), (1, 1)))
        self.low, self.high = low, high
        runs = [_dense(self.mm(line), low - AROUND, high + AROUND) for line in lines]
        self.taken = np.concatenate(runs) if runs else np.zeros(0, np.complex128)
        self.boxes: list[tuple[complex, complex]] = []

    def mm(self, places: Points) -> Points:
        """Data to mm on the figure."""
        spots = self.at.transData.transform(np.stack([np.real(places), np.imag(places)], axis=-1))
        return np.asarray(spots[..., 0] + 1j * spots[..., 1], np.complex128)

    def keep_clear(self, places: Points, radius: float) -> None:
        """Round marks that no text may cover (mm)."""
        self.boxes += [(z - complex(radius, radius), z + complex(radius, radius)) for z in self.mm(places)]

    def is_free(self, low: complex, words: str, size: float) -> bool:
        """Whether nothing stands where a text would, of which this is the lower left corner (data)."""
        box = layout_words(words, size)
        half = complex(box.width / 2, (box.ascent + box.descent) / 2)
        return self._cost(complex(self.mm(np.array([low]))[0]) + half, half) == 0.0

    def put(
        self, place: complex, words: str, outward: complex, size: float, *, most: float = inf, hue: Hue = Hue.BLACK
    ) -> bool:
        """The text beside the place; of equally free spots that nearest to the outward direction.

        most: what it may cover; where it would cover more, it is left out. Gives whether it stands.
        """
        box = layout_words(words, size)
        half = complex(box.width / 2, (box.ascent + box.descent) / 2)
        here = complex(self.mm(np.array([place]))[0])
        spots = [
            (here + way * gap + complex(half.real * way.real, half.imag * way.imag), way, gap)
            for gap in NEAR
            for way in WAYS
        ]
        outward = outward / abs(outward) if abs(outward) else 1.0
        wishes = [0.4 * s[2] - 0.5 * (np.conj(outward) * s[1]).real for s in spots]
        costs = [self._cost(s[0], half) for s in spots]
        if most < inf:  # a text that may be left out never stands beyond another curve
            self._cross(costs, wishes, here, spots)
        best = min(range(len(spots)), key=lambda i: costs[i] + wishes[i])
        if costs[best] > most:
            return False
        spot = spots[best][0]
        self.boxes.append((spot - half, spot + half))
        style.clear(self.at, spot.real - half.real, spot.imag - half.imag, 2 * half.real, 2 * half.imag)
        style.text(self.at, spot.real - half.real, spot.imag - half.imag + box.descent, words, size=size, hue=hue)
        return True

    def _cross(self, costs: list[float], wishes: list[float], here: complex, spots: Sequence[Spot]) -> None:
        """Raise the costs of those spots that lie beyond something, as far as they could be the best."""
        best = inf
        for i in sorted(range(len(spots)), key=lambda i: costs[i] + wishes[i]):
            if costs[i] + wishes[i] > best:
                break
            costs[i] += self._crossed(here, spots[i][1], spots[i][2])
            best = min(best, costs[i] + wishes[i])

    def _crossed(self, here: complex, way: complex, gap: float) -> float:
        """What stands between a point and a text so far from it."""
        between = here + way * np.arange(_OWN, gap, 0.4)
        return 20.0 * any(bool((np.abs(self.taken - z) < 0.4).any()) for z in between)

    def _cost(self, spot: complex, half: complex) -> float:
        grown = half + complex(0.5, 0.5)
        away = self.taken - spot
        hits = np.count_nonzero((np.abs(away.real) < grown.real) & (np.abs(away.imag) < grown.imag))
        low, high = spot - grown, spot + grown
        laps = sum(
            a.real < high.real and low.real < b.real and a.imag < high.imag and low.imag < b.imag for a, b in self.boxes
        )
        out = (
            low.real < self.low.real
            or low.imag < self.low.imag
            or high.real > self.high.real
            or high.imag > self.high.imag
        )
        return float(hits) + 20.0 * laps + 100.0 * out


def _dense(line: Points, low: complex, high: complex) -> Points:
    """Points every 0.5 mm along a line, which may be interrupted, where it runs between these corners."""
    parts = [line[np.isfinite(line)]]
    for p, q in pairwise(line):
        if np.isfinite(p) and np.isfinite(q) and abs(q - p) > STEP:
            start, end = _between(complex(p), complex(q), low, high)
            if start < end:
                parts.append(p + (q - p) * np.linspace(start, end, int((end - start) * abs(q - p) / STEP) + 1))
    return np.concatenate(parts)


def _between(p: complex, q: complex, low: complex, high: complex) -> tuple[float, float]:
    """Which share of the way from p to q lies between two corners of a rectangle; none where the end is not behind the
    start."""
    start, end = 0.0, 1.0
    for a, b, least, most in ((p.real, q.real, low.real, high.real), (p.imag, q.imag, low.imag, high.imag)):
        if a == b:
            end = end if least <= a <= most else start
            continue
        first, last = sorted(((least - a) / (b - a), (most - a) / (b - a)))
        start, end = max(start, first), min(end, last)
    return start, end
