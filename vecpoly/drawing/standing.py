"""Where the labels of a figure stand while they look for their places, and what they cost each other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .labels.obstacles import Complexes, Floats, Indices, clip, crossed
from .labels.want import Thing
from .scene import Rect

APART = 0.7  # mm between two labels
AS_ONE, MISREAD = 1.8, 39.0  # mm side by side below which two labels are read as one, and what that costs
STACK, STACKED = 1.3, 12.0  # mm one over the other below which they look like a fraction, and what that costs
FRACTION, READ_SO = 3.2, 30.0  # the same of the letter of a point and the number of a link: D over 4
TIGHT = 0.9  # mm one over the other below which they are taken for one
_OVER = {Thing.POINT: Thing.LINK, Thing.LINK: Thing.POINT}
OVERLAP, PER_AREA = 120.0, 8.0
LEADER_ON_LABEL, LEADERS_CROSS = 60.0, 80.0
NOWHERE = complex(np.nan, np.nan)
NEVER, AWAY = -2, -1  # of another label: not looked at yet; standing nowhere near


@dataclass(frozen=True, slots=True)
class Trial:
    """Places of one label: their middles, half its size, the feet of their leaders where they have any."""

    centre: Complexes
    half: complex
    foot: Complexes | None
    thing: Thing = Thing.OTHER

    @property
    def span(self) -> Rect:
        """The rectangle about them all."""
        (x, y), half = (self.centre.real, self.centre.imag), self.half
        about = Rect(x.min() - half.real, y.min() - half.imag, x.max() + half.real, y.max() + half.imag)
        if self.foot is None:
            return about
        x, y = self.foot.real, self.foot.imag
        return about | Rect(x.min(), y.min(), x.max(), y.max())


@dataclass(slots=True)
class Standing:
    """Each label's place now, by number (-1: none yet), its middle, half its size, the foot of its leader."""

    chosen: Indices
    centre: Complexes
    half: Complexes
    foot: Complexes
    low: Complexes  # lower left corner of all that belongs to it
    high: Complexes
    things: NDArray[np.object_]  # what each names

    @classmethod
    def nowhere(cls, things: Sequence[Thing]) -> Standing:
        """No label has a place yet."""
        named = np.array(things, dtype=object)
        centre, half, foot, low, high = np.full((5, len(things)), NOWHERE)
        return cls(np.full(len(things), AWAY), centre, half, foot, low, high, named)

    def put(self, i: int, place: int, centre: complex, half: complex, foot: complex) -> None:
        """Label i stands here; foot: of its leader, nan where it has none."""
        self.chosen[i], self.centre[i], self.half[i], self.foot[i] = place, centre, half, foot
        low, high = centre - half, centre + half
        self.low[i] = complex(np.fmin(low.real, foot.real), np.fmin(low.imag, foot.imag))
        self.high[i] = complex(np.fmax(high.real, foot.real), np.fmax(high.imag, foot.imag))

    def about(self, span: Rect, but: int) -> Indices:
        """Of each label, but this one, its place where that reaches into a rectangle, or nearly; else AWAY."""
        low, high = self.low, self.high
        across = (low.real < span.x1 + AS_ONE) & (high.real > span.x0 - AS_ONE)
        across &= (low.imag < span.y1 + FRACTION) & (high.imag > span.y0 - FRACTION)
        across[but] = False
        return np.where(across, self.chosen, AWAY)

    def clashes(self, trial: Trial, others: Indices) -> Floats:
        """What some places of a label cost for each of these others where they are now; shape (places, others)."""
        half = trial.half
        mine, c, size, led = trial.centre[:, None], self.centre[others], self.half[others], self.foot[others]
        apart = mine - c
        dx = size.real + half.real + APART - np.abs(apart.real)
        dy = size.imag + half.imag + APART - np.abs(apart.imag)
        level = dy > 0
        cost: Floats = np.where((dx > 0) & level, OVERLAP + PER_AREA * dx * dy, 0.0)
        cost += np.where((dx <= 0) & (dx > APART - AS_ONE) & level, MISREAD, 0.0)
        over = (dy <= 0) & (dx > APART)
        cost += np.where(over & (dy > APART - STACK), np.where(dy > APART - TIGHT, MISREAD, STACKED), 0.0)
        fraction = over & (dy > APART - FRACTION)
        cost += np.where(fraction & self._as_fraction(trial.thing, others), READ_SO, 0.0)
        if trial.foot is not None:
            cost += LEADER_ON_LABEL * _struck(trial.foot[:, None], mine, c, size)
        theirs = np.flatnonzero(~np.isnan(led.real))
        if len(theirs):
            cost[:, theirs] += LEADER_ON_LABEL * _struck(led[theirs], c[theirs], mine, half)
            if trial.foot is not None:
                cost[:, theirs] += LEADERS_CROSS * crossed(trial.foot[:, None], mine, led[theirs], c[theirs])
        return cost

    def _as_fraction(self, thing: Thing, others: Indices) -> NDArray[np.bool_]:
        """Which of them make a fraction with a label of this kind: a letter over a number, a number over a letter."""
        return np.asarray(self.things[others] == _OVER.get(thing), dtype=bool)


class Meeting:
    """What the places of label i cost for the other labels where it last saw them: only who moved is weighed again."""

    def __init__(self, trial: Trial, i: int, count: int) -> None:
        self._trial, self._i, self._span = trial, i, trial.span
        self._seen = np.full(count, NEVER)
        self._each = np.zeros((len(trial.centre), count))
        self.cost: Floats = np.zeros(len(trial.centre))

    def look(self, standing: Standing) -> bool:
        """Whether anybody who counts has moved since; their cost is then found anew."""
        now = standing.about(self._span, but=self._i)
        moved = np.flatnonzero(now != self._seen)
        if not len(moved):
            return False
        self._each[:, moved] = 0.0
        here = moved[now[moved] != AWAY]
        if len(here):
            self._each[:, here] = standing.clashes(self._trial, here)
        self._seen, self.cost = now, self._each.sum(axis=1)
        return True

    def whom(self, place: int) -> list[int]:
        """The other labels that make this place dear, as they were last seen."""
        return [int(k) for k in np.flatnonzero(self._each[place])]


def _struck(foot: Complexes, end: Complexes, centre: Complexes, half: Complexes | complex) -> Floats:
    """1 where a leader from foot to end runs through a label, else 0."""
    _, hit = clip(foot, end, centre, half.real + 0.4, half.imag + 0.4)
    return np.where(hit, 1.0, 0.0)
