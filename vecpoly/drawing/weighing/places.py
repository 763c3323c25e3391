"""All places of a label; those farther off on a leader are priced only where nearer ones are dear."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate

import numpy as np

from ...foundation.slotted import replace
from ..labels.about.bounds import Floats, Indices
from ..labels.spots import DIRECTIONS, LED, PER_DISTANCE, Spots, beside, on_leaders, price_of_leader, rings
from ..labels.want import Want
from .clashes import Trial
from .prices import Around, Stand, beyond, stands

OUTSIDE = 0.25  # a mm beyond the drawn lines
BROAD, WIDENS = 8.5, 1.5  # mm: what a label so broad costs a mm beyond the drawn lines, as it may ask for another page
BATCH = 96  # places that are weighed together, the cheapest first
FREE = 6.0  # dearer than the cheapest place by less than this is free to choose


@dataclass(frozen=True, slots=True, eq=False)
class Batch:
    """Places of a label that cost about the same by themselves."""

    numbers: list[int]  # of each place among all of the label
    total: Floats
    trial: Trial  # as they are weighed against the other labels

    @property
    def least(self) -> float:
        """None of them costs less, wherever the other labels stand."""
        return float(self.total[0])


@dataclass(eq=False)
class Places:
    """Some places of a label, all beside what it names or all on leaders of about one length; `first`: the number of
    the first of them; `ring`: how far off they are on their leaders."""

    want: Want
    first: int
    ring: tuple[float, ...]
    around: Around
    stand: Stand | None = None  # what they stand on, where it is known

    @property
    def led(self) -> bool:
        """Whether they are on leaders."""
        return bool(self.ring)

    @cached_property
    def spots(self) -> Spots:
        """Where they are."""
        return on_leaders(self.want, self.ring) if self.led else beside(self.want, self.around.drawn.centre)

    @cached_property
    def alike(self) -> tuple[Indices, Indices]:
        """Of places on leaders those that differ, and which of these each is: several may start at one foot."""
        numbers = np.arange(len(self.spots.centre)).reshape(len(self.ring), -1, len(DIRECTIONS))
        first = self.spots.some(numbers[0, :, 0])  # of each foot
        feet = [*zip(first.centre.tolist(), first.foot.tolist(), strict=True)]
        found, which = np.unique(numbers[:, [feet.index(foot) for foot in feet]].ravel(), return_inverse=True)
        return found, which

    @cached_property
    def half(self) -> complex:
        """Half the width and height of the label."""
        return complex(self.want.width / 2, self.want.height / 2)

    @cached_property
    def _outside(self) -> Floats:
        price = OUTSIDE if self.want.width < BROAD else WIDENS
        return price * beyond(self.want, self.spots.centre, self.around.drawn)

    def above(self, price: float) -> bool:
        """Whether no place here costs less than this, even where it stands on nothing; of leaders that is mostly known
        before their places are."""
        return (self.led and self._leader >= price) or self._least >= price

    @cached_property
    def _leader(self) -> float:
        return price_of_leader(self.want) + PER_DISTANCE * self.ring[0]

    @cached_property
    def _least(self) -> float:
        return float((self.spots.cost + self._outside).min())

    @cached_property
    def hard(self) -> Floats:
        """What each place stands on."""
        price((self,))
        assert self.stand is not None
        return self.stand.price(self.want, self.spots, self.led, self.around.frame)

    @cached_property
    def total(self) -> Floats:
        """The same with preference."""
        result: Floats = self.hard + self.spots.cost + self._outside
        return result

    @cached_property
    def least(self) -> float:
        """What the cheapest place costs by itself."""
        return float(self.total.min())

    @cached_property
    def _by_price(self) -> Indices:
        return np.argsort(self.total, kind="stable")

    @cached_property
    def batches(self) -> tuple[Batch, ...]:
        """All of them, the cheapest first."""
        parted = (self._by_price[k : k + BATCH] for k in range(0, len(self.total), BATCH))
        return tuple(Batch((some + self.first).tolist(), self.total[some], self._trial(some)) for some in parted)

    def _trial(self, some: Indices) -> Trial:
        return Trial(self.spots.centre[some], self.half, self.spots.foot[some] if self.led else None, self.want.thing)

    def cheapest(self, below: float, count: int) -> list[tuple[float, int]]:
        """So many of the cheapest places by themselves, those that cost less than this: price and number."""
        if self.above(below):
            return []
        found = self._by_price[:count]
        costs = self.total[found].tolist()
        return [one for one in zip(costs, (found + self.first).tolist(), strict=True) if one[0] < below]

    def among(self, at: int) -> tuple[Batch, int]:
        """In which batch a place is, and which of its places it is there."""
        n, place = divmod(self._rank[at], BATCH)
        return self.batches[n], place

    @cached_property
    def _rank(self) -> list[int]:
        rank = np.empty_like(self._by_price)
        rank[self._by_price] = np.arange(len(rank))
        found: list[int] = rank.tolist()
        return found


@dataclass(frozen=True, slots=True)
class Row:
    """All places of one label: beside what it names, then on leaders, ever longer ones."""

    want: Want
    parts: tuple[Places, ...]

    @classmethod
    def of(cls, want: Want, around: Around) -> Row:
        """Not priced yet."""
        near = Places(want, 0, (), around)
        return cls(want, (near, *_led(want, len(near.spots.centre), around, ())))

    def eased(self) -> Row:
        """With the places on a leader that the label has in a crowd; those beside what it names are the same."""
        (near, *led), want = self.parts, replace(self.want, farther=True)
        return Row(want, (near, *_led(want, led[0].first, near.around, [part.stand for part in led])))

    @property
    def near(self) -> Places:
        """Beside what the label names."""
        return self.parts[0]

    @property
    def led(self) -> tuple[Places, ...]:
        """On a leader."""
        return self.parts[1:]

    def of_number(self, number: int) -> tuple[Places, int]:
        """Among which places this one is, and its number there."""
        part = next(part for part in reversed(self.parts) if number >= part.first)
        return part, number - part.first

    def where(self, number: int) -> tuple[Batch, int]:
        """In which batch a place is, and which one there."""
        k = len(self.parts) - 1
        while number < self.parts[k].first:
            k -= 1
        return self.parts[k].among(number - self.parts[k].first)

    @property
    def freedom(self) -> int:
        """How many places are about as good as the best."""
        totals, least = [self.near.total], self.near.least
        for part in self.led:
            if not part.above(least + FREE):
                totals.append(part.total)
                least = min(least, part.least)
        return sum(int((total < least + FREE).sum()) for total in totals)


def _led(want: Want, first: int, around: Around, known: Sequence[Stand | None]) -> Iterable[Places]:
    """The places on leaders, from this number on; known: what the shortest of them stand on."""
    ways = rings(want)
    sizes = [len(ring) * len(want.feet[:LED]) * len(DIRECTIONS) for ring in ways]
    firsts = accumulate(sizes[:-1], initial=first)
    stand = (*known, *[None] * (len(ways) - len(known)))
    return [Places(want, start, ring, around, one) for start, ring, one in zip(firsts, ways, stand, strict=True)]


def cheapest(parts: Sequence[Places], below: float, count: int) -> list[int]:
    """So many of the cheapest places by themselves, those that cost less than this, of equal ones the first."""
    found: list[tuple[float, int]] = []
    for part in parts:
        found = sorted((*found, *part.cheapest(below, count)))[:count]
        below = found[-1][0] if len(found) == count else below
    return [number for _, number in found]


def price(places: Sequence[Places]) -> None:
    """Find what each of these places stands on, of many labels of one figure together."""
    new = [part for part in places if part.stand is None]
    near, led = ([part for part in new if part.led is led] for led in (False, True))
    if new:
        leading = [(part.want, part.spots.some(part.alike[0])) for part in led]
        found = stands(new[0].around, [(part.want, part.spots) for part in near], leading)
        for part, stand in zip((*near, *led), found, strict=True):
            part.stand = stand.some(part.alike[1]) if part.led else stand


def price_all(rows: Sequence[Row]) -> None:
    """Price what tells how free each label is: all beside what it names; on leaders where these may be as good."""
    price([row.near for row in rows])
    least = [row.near.least for row in rows]
    for k in range(1, max((len(row.parts) for row in rows), default=0)):
        there = [n for n, row in enumerate(rows) if k < len(row.parts) and not row.parts[k].above(least[n] + FREE)]
        price([rows[n].parts[k] for n in there])
        for n in there:
            least[n] = min(least[n], rows[n].parts[k].least)
