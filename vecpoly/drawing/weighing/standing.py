"""Where the labels of a figure stand while they look for their places, and what they cost each other there."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..labels.about.bounds import Floats, Indices
from .clashes import Others, Trial, clashes
from .stood import Stood

AWAY = -1  # of another label: standing nowhere near
PAIRS = 24  # of places and other labels that are weighed one by one, before all of a batch are
ROUNDING = 1e-6

Pair = tuple[int, int, int, int]  # two labels, each with the number of its place


@dataclass(slots=True)
class Standing:
    """Each label's place now, by number (-1: none yet), and the label there."""

    chosen: list[int]
    stood: list[Stood | None]
    moves: list[int]  # the labels that were put somewhere, the last one last

    @classmethod
    def nowhere(cls, count: int) -> Standing:
        """No label has a place yet."""
        return cls([AWAY] * count, [None] * count, [])

    def put(self, i: int, place: int, one: Stood) -> None:
        """Label i stands here."""
        self.chosen[i], self.stood[i] = place, one
        self.moves.append(i)

    def place_in(self, low: complex, high: complex, i: int) -> int:
        """The place of a label where that reaches into a rectangle, or nearly; else AWAY."""
        one = self.stood[i]
        return self.chosen[i] if one is not None and one.nears(low, high) else AWAY


@dataclass(eq=False)
class Meeting:
    """What the places of label i cost for the other labels where it last saw them: only who moved is weighed again, who
    came back to where it was seen before costs the same, and at most places it is clear without that that they are
    too dear.

    pairs: what labels cost each other, of all meetings of a figure; known: what each of the others, by its number and
    that of its place, costs these places, or None if it costs none of them anything.
    """

    trial: Trial
    numbers: list[int]  # of each place
    i: int
    count: int
    pairs: dict[Pair, float] = field(default_factory=dict)
    known: dict[tuple[int, int], Floats | None] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._low, self._high = self.trial.span
        self._moves = 0  # that it knows of
        self._last: list[Stood | None] = [None] * self.count
        self._seen = [AWAY] * self.count
        self._each = np.zeros((len(self.numbers), self.count))
        self._new, self._dear = set[int](), set[int]()  # the others that are not weighed yet; that cost anything
        self._sum: Floats | None = np.zeros(len(self.numbers))

    def look(self, standing: Standing) -> None:
        """See who has moved since."""
        if self._moves == len(standing.moves):
            return
        for k in {*standing.moves[self._moves :]}:
            one = standing.stood[k]
            if one is self._last[k] or k == self.i:
                continue
            self._last[k], now = one, standing.place_in(self._low, self._high, k)
            if now == self._seen[k]:
                continue
            self._seen[k] = now
            self._new.discard(k)
            if k in self._dear:
                self._each[:, k], self._sum = 0.0, None
                self._dear.remove(k)
            if now != AWAY and (k, now) not in self.known:
                self._new.add(k)
            elif now != AWAY and (known := self.known[k, now]) is not None:
                self._set(k, known)
        self._moves = len(standing.moves)

    def _set(self, k: int, known: Floats) -> None:
        self._each[:, k], self._sum = known, None
        self._dear.add(k)

    @property
    def least(self) -> Floats:
        """What the places cost at least: those are not counted that are not weighed yet."""
        if self._sum is None:
            self._sum = self._each.sum(axis=1)
        return self._sum

    def cost(self, standing: Standing) -> Floats:
        """What the places cost."""
        new = sorted(self._new)
        if new:
            found = clashes(self.trial, Others.of([one for k in new if (one := standing.stood[k]) is not None]))
            for k, column in zip(new, found.T.copy(), strict=True):
                known = self.known[k, self._seen[k]] = column if column.any() else None
                if known is not None:
                    self._set(k, known)
            self._new.clear()
        return self.least

    def at(self, place: int, standing: Standing) -> float:
        """What one of the places costs."""
        return float(self._row(place, standing).sum() if self._new else self.least[place])

    def whom(self, place: int, standing: Standing) -> list[int]:
        """The other labels that make this place dear."""
        found: list[int] = np.flatnonzero(self._row(place, standing)).tolist()
        return found

    def _row(self, place: int, standing: Standing) -> Floats:
        row: Floats = self._each[place]
        if self._new:
            row = row.copy()
            for k in self._new:
                row[k] = self._pair(place, k, standing)
        return row

    def _pair(self, place: int, k: int, standing: Standing) -> float:
        mine, other = (self.i, self.numbers[place]), (k, self._seen[k])
        key = (*mine, *other) if self.i < k else (*other, *mine)
        if (found := self.pairs.get(key)) is None:
            one = standing.stood[k]
            found = self.pairs[key] = 0.0 if one is None else self.trial.one(place).meets(one)
        return found

    def cheapest(self, total: Floats, best: tuple[float, int], standing: Standing) -> tuple[float, int]:
        """The price and the number of the cheapest place, of equal ones the first; total: what each costs by itself;
        best: the same of a place elsewhere, where that is no dearer."""
        bound = total + self.least
        if self._new:
            found = self._one_by_one(total, bound, best, standing)
            if found is not None:
                return found
            bound = total + self.cost(standing)
        low = float(bound.min())
        return min(best, (low, min(self.numbers[at] for at in np.flatnonzero(bound == low))))

    def _one_by_one(
        self, total: Floats, bound: Floats, best: tuple[float, int], standing: Standing
    ) -> tuple[float, int] | None:
        """The same by what few places cost, if the others cost more in any case; None where they may not."""
        left = PAIRS
        order: Indices = bound.argsort()
        for at in order.tolist():
            if bound[at] > best[0] + ROUNDING:
                return best
            left -= len(self._new)
            if left < 0:
                return None
            best = min(best, (float(total[at]) + self.at(at, standing), self.numbers[at]))
        return best
