"""Where the labels of a figure stand while they look for their places, and what they cost each other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isnan

import numpy as np
from numpy.typing import NDArray

from .labels.clipping import enters
from .labels.obstacles import Complexes, Floats, Indices, crossed
from .labels.spots import ends
from .labels.want import Thing
from .scene import Rect

APART = 0.7  # mm between two labels
AS_ONE, MISREAD = 1.8, 39.0  # mm side by side below which two labels are read as one, and what that costs
STACK, STACKED = 1.3, 12.0  # mm one over the other below which they look like a fraction, and what that costs
FRACTION, READ_SO = 3.2, 30.0  # the same of the letter of a point and the number of a link: D over 4
TIGHT = 0.9  # mm one over the other below which they are taken for one
_OVER = {Thing.POINT: Thing.LINK, Thing.LINK: Thing.POINT}
OVERLAP, PER_AREA = 120.0, 8.0
LEADER_ON_LABEL, LEADERS_CROSS = 180.0, 80.0  # a letter struck through is read wrongly, dearer than one on a line
CLEAR = 0.4  # mm between a leader and lettering that is not its own
NOWHERE = complex(np.nan, np.nan)
AWAY = -1  # of another label: standing nowhere near


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
        middles, half = _about(self.centre), self.half
        about = Rect(middles.x0 - half.real, middles.y0 - half.imag, middles.x1 + half.real, middles.y1 + half.imag)
        return about if self.foot is None else about | _about(self.foot)


@dataclass(slots=True)
class Standing:
    """Each label's place now, by number (-1: none yet), its middle, half its size, the foot of its leader."""

    chosen: list[int]
    centre: Complexes
    half: Complexes
    foot: Complexes
    reach: list[Rect]  # of each label all that belongs to it
    things: NDArray[np.object_]  # what each names
    moves: list[int]  # the labels that were put somewhere, the last one last

    @classmethod
    def nowhere(cls, things: Sequence[Thing]) -> Standing:
        """No label has a place yet."""
        count, named = len(things), np.array(things, dtype=object)
        centre, half, foot = np.full((3, count), NOWHERE)
        return cls([AWAY] * count, centre, half, foot, [Rect(np.nan, np.nan, np.nan, np.nan)] * count, named, [])

    def put(self, i: int, place: int, centre: complex, half: complex, foot: complex) -> None:
        """Label i stands here; foot: of its leader, nan where it has none."""
        self.chosen[i], self.centre[i], self.half[i], self.foot[i] = place, centre, half, foot
        low, high = centre - half, centre + half
        reach = Rect(low.real, low.imag, high.real, high.imag)
        self.reach[i] = reach if isnan(foot.real) else reach | Rect(foot.real, foot.imag, foot.real, foot.imag)
        self.moves.append(i)

    def place_in(self, span: Rect, i: int) -> int:
        """The place of a label where that reaches into a rectangle, or nearly; else AWAY."""
        own = self.reach[i]
        level = own.x0 < span.x1 + AS_ONE and own.x1 > span.x0 - AS_ONE
        return self.chosen[i] if level and own.y0 < span.y1 + FRACTION and own.y1 > span.y0 - FRACTION else AWAY

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
            start, end = trial.foot[:, None], ends(trial.foot, trial.centre, half)[:, None]
            cost += LEADER_ON_LABEL * _struck(start, end, c, size)
        theirs = np.flatnonzero(~np.isnan(led.real))
        if len(theirs):
            feet, tips = led[theirs], ends(led[theirs], c[theirs], size[theirs])
            cost[:, theirs] += LEADER_ON_LABEL * _struck(feet, tips, mine, half)
            if trial.foot is not None:
                cost[:, theirs] += LEADERS_CROSS * crossed(start, end, feet, tips)
        return cost

    def _as_fraction(self, thing: Thing, others: Indices) -> NDArray[np.bool_]:
        """Which of them make a fraction with a label of this kind: a letter over a number, a number over a letter."""
        return np.asarray(self.things[others] == _OVER.get(thing), dtype=bool)


class Meeting:
    """What the places of label i cost for the other labels where it last saw them: only who moved is weighed again, and
    who came back to where it was seen before costs the same."""

    def __init__(self, trial: Trial, i: int, count: int) -> None:
        self._trial, self._i, self._span = trial, i, trial.span
        self._moves = 0  # that it knows of
        self._seen = [AWAY] * count
        self._each = np.zeros((len(trial.centre), count))
        self._known: dict[tuple[int, int], Floats] = {}  # by the other label and its place
        self.cost: Floats = np.zeros(len(trial.centre))

    def again(self) -> Meeting:
        """The same while nobody stands anywhere."""
        fresh = Meeting(self._trial, self._i, len(self._seen))
        fresh._known = self._known
        return fresh

    def look(self, standing: Standing) -> None:
        """See who has moved since; what those cost that count is then found anew."""
        moved = False
        fresh = list[int]()
        for k in {*standing.moves[self._moves :]} - {self._i}:
            now = standing.place_in(self._span, k)
            if now == self._seen[k]:
                continue
            self._seen[k], moved = now, True
            if now == AWAY:
                self._each[:, k] = 0.0
            elif (known := self._known.get((k, now))) is not None:
                self._each[:, k] = known
            else:
                fresh.append(k)
        self._moves = len(standing.moves)
        if fresh:
            self._weigh(standing, fresh)
        if moved:
            self.cost = self._each.sum(axis=1)

    def _weigh(self, standing: Standing, others: list[int]) -> None:
        found = self._each[:, others] = standing.clashes(self._trial, np.array(others))
        self._known |= {(k, self._seen[k]): one for k, one in zip(others, found.T.copy(), strict=True)}

    def whom(self, place: int) -> list[int]:
        """The other labels that make this place dear, as they were last seen."""
        return [int(k) for k in np.flatnonzero(self._each[place])]


def _about(points: Complexes) -> Rect:
    x, y = points.real, points.imag
    return Rect(float(x.min()), float(y.min()), float(x.max()), float(y.max()))


def _struck(foot: Complexes, end: Complexes, centre: Complexes, half: Complexes | complex) -> Floats:
    """1 where a leader from foot to end runs through a label, else 0."""
    return np.where(enters(foot, end, centre, half.real + CLEAR, half.imag + CLEAR), 1.0, 0.0)
