"""What the places of a label cost by themselves; those on a leader are priced only where nearer ones are dear."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .labels.leading import alongside
from .labels.obstacles import Complexes, Floats, Indices, Obstacles
from .labels.rivals import Named, misled
from .labels.spots import Spots, beside, ends, on_leaders, price_of_leader
from .labels.want import Line, Spot, Want
from .scene import Rect
from .standing import Trial

OUTSIDE, BEYOND_FRAME = 0.25, 60.0  # a mm beyond the drawn lines, beyond the allowed frame
IN_CROWD = 0.3  # so much of its price has what a leader crosses in a crowd: better that than a letter on a line
BROAD, WIDENS = 8.5, 1.5  # mm: what a label so broad costs a mm beyond the drawn lines, as it may ask for another page
BATCH = 96  # places that are weighed together, the cheapest first
FREE = 6.0  # dearer than the cheapest place by less than this is free to choose


@dataclass(frozen=True, slots=True)
class Around:
    """What stands about the labels of a figure: lines and solids, other things to name, the drawn extents, a frame."""

    obstacles: Obstacles
    wanted: tuple[Want, ...]
    drawn: Rect
    frame: Rect | None
    unnamed: tuple[Spot, ...] = ()  # points without a letter
    grounds: tuple[Line, ...] = ()  # edges of hatching, beside which a number is taken for the frame's


@dataclass(frozen=True, slots=True, eq=False)
class Batch:
    """Places of a label that cost about the same by themselves."""

    numbers: Indices  # of each place among all of the label
    total: Floats
    trial: Trial  # as they are weighed against the other labels

    @property
    def least(self) -> float:
        """None of them costs less, wherever the other labels stand."""
        return float(self.total[0])


@dataclass(eq=False)
class Places:
    """Some places of a label, all beside what it names or all on a leader; `first`: the number of the first of them."""

    want: Want
    first: int
    led: bool
    around: Around
    _hard: Floats | None = None

    @cached_property
    def spots(self) -> Spots:
        """Where they are."""
        return on_leaders(self.want) if self.led else beside(self.want, self.around.drawn.centre)

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
        return (self.led and price_of_leader(self.want) >= price) or self._least >= price

    @cached_property
    def _least(self) -> float:
        return float((self.spots.cost + self._outside).min())

    @property
    def known(self) -> bool:
        """Whether it was found already what they stand on."""
        return self._hard is not None

    @property
    def hard(self) -> Floats:
        """What each place stands on."""
        if self._hard is None:
            price((self,))
        assert self._hard is not None
        return self._hard

    @cached_property
    def total(self) -> Floats:
        """The same with preference."""
        result: Floats = self.hard + self.spots.cost + self._outside
        return result

    @cached_property
    def _by_price(self) -> Indices:
        return np.argsort(self.total, kind="stable")

    @cached_property
    def batches(self) -> tuple[Batch, ...]:
        """All of them, the cheapest first."""
        parted = (self._by_price[k : k + BATCH] for k in range(0, len(self.total), BATCH))
        return tuple(Batch(some + self.first, self.total[some], self._trial(some)) for some in parted)

    def _trial(self, some: Indices) -> Trial:
        return Trial(self.spots.centre[some], self.half, self.spots.foot[some] if self.led else None, self.want.thing)

    def cheapest(self, below: float, count: int) -> list[int]:
        """So many of the cheapest places by themselves, those that cost less than this."""
        return [int(at) for at in self._by_price[:count] if self.total[at] < below] if not self.above(below) else []

    def among(self, at: int) -> tuple[int, int]:
        """In which batch a place is, and which of its places it is there."""
        return divmod(self._rank[at], BATCH)

    @cached_property
    def _rank(self) -> list[int]:
        rank = np.empty_like(self._by_price)
        rank[self._by_price] = np.arange(len(rank))
        found: list[int] = rank.tolist()
        return found

    @property
    def leaders(self) -> tuple[Complexes, Complexes]:
        """Where the leader of each place starts and ends."""
        return self.spots.foot, ends(self.spots.foot, self.spots.centre, self.half)


@dataclass(frozen=True, slots=True)
class Row:
    """All places of one label."""

    near: Places
    led: Places

    @property
    def parts(self) -> tuple[Places, Places]:
        """Beside what the label names, and on a leader."""
        return self.near, self.led

    @classmethod
    def of(cls, want: Want, around: Around) -> Row:
        """Not priced yet."""
        near = Places(want, 0, False, around)
        return cls(near, Places(want, len(near.spots.centre), True, around))

    def eased(self, want: Want, around: Around) -> Row:
        """With the places on a leader that the label has in a crowd; those beside what it names are the same."""
        return Row(self.near, Places(want, self.led.first, True, around))

    def of_number(self, k: int) -> tuple[Places, int]:
        """Among which places this one is, and its number there."""
        part = self.led if k >= self.led.first else self.near
        return part, k - part.first

    @property
    def dear(self) -> bool:
        """Whether a leader is to be thought of, too, before it is said how free the label is."""
        return not self.led.above(float(self.near.total.min()) + FREE)

    @property
    def freedom(self) -> int:
        """How many places are about as good as the best."""
        total = np.concatenate([part.total for part in self.parts]) if self.dear else self.near.total
        return int((total < total.min() + FREE).sum())


def price(places: Sequence[Places]) -> None:
    """Find what each of these places stands on, of many labels of one figure together."""
    if not places:
        return
    around = places[0].around
    costs = priced(around.obstacles, [(part.want, part.spots.centre) for part in places])
    led = [part for part in places if part.led]
    crossed = dict(zip(map(id, led), _crossed(around.obstacles, led), strict=True))
    near = [part for part in places if not part.led]
    named = Named.by(around.wanted, around.unnamed, around.grounds)
    parted = dict(zip(map(id, near), _parted(around.obstacles, near), strict=True))
    for part, cost in zip(places, costs, strict=True):
        if part.led:
            cost += crossed[id(part)] + alongside(part.want, around.obstacles, part.spots)
        else:
            cost += parted[id(part)] + misled(part.want, named, part.spots.centre)
        if around.frame is not None:
            cost += BEYOND_FRAME * beyond(part.want, part.spots.centre, around.frame)
        part._hard = cost


def priced(obstacles: Obstacles, places: Sequence[tuple[Want, Complexes]]) -> list[Floats]:
    """What the lines and solids of a figure cost each label at each of its places."""
    counts = [len(centre) for _, centre in places]
    own = _repeated([want.own for want, _ in places], counts)
    size = _repeated([(want.width, want.height) for want, _ in places], counts).real
    centre = np.concatenate([centre for _, centre in places])
    groups = _groups(counts)
    cost = obstacles.cost(centre, size[:, 0], size[:, 1], (own[:, 0], own[:, 1]), groups)
    return [cost[some] for some in groups]


def _parted(obstacles: Obstacles, near: Sequence[Places]) -> list[Floats]:
    """What stands between each place and what is named."""
    if not near:
        return []
    counts = [len(part.spots.centre) for part in near]
    own, groups = _repeated([part.want.own for part in near], counts), _groups(counts)
    keep = np.repeat([part.want.radius for part in near], counts)
    root, centre = (np.concatenate(ends) for ends in zip(*((p.spots.root, p.spots.centre) for p in near), strict=True))
    cost = obstacles.parted(root, keep, centre, (own[:, 0], own[:, 1]), groups)
    return [cost[some] for some in groups]


def _crossed(obstacles: Obstacles, led: Sequence[Places]) -> list[Floats]:
    """What the leader of each place crosses."""
    if not led:
        return []
    counts = [len(part.spots.centre) for part in led]
    own, groups = _repeated([part.want.own for part in led], counts), _groups(counts)
    foot, end = (np.concatenate(ends) for ends in zip(*(part.leaders for part in led), strict=True))
    cost = obstacles.crossings(foot, end, (own[:, 0], own[:, 1]), groups)
    return [cost[some] * (IN_CROWD if part.want.farther else 1.0) for part, some in zip(led, groups, strict=True)]


def _repeated(pairs: Sequence[tuple[complex, complex]], counts: Sequence[int]) -> Complexes:
    return np.repeat(np.array(pairs, dtype=complex), counts, axis=0)


def _groups(counts: Sequence[int]) -> list[slice]:
    ends = np.cumsum(counts).tolist()
    return [slice(end - count, end) for count, end in zip(counts, ends, strict=True)]


def beyond(want: Want, centre: Complexes, rect: Rect) -> Floats:
    """How far a label at each of these places sticks out of a rectangle, mm."""
    x, y, w, h = centre.real, centre.imag, want.width / 2, want.height / 2
    out: Floats = np.maximum(rect.x0 - (x - w), 0.0)
    for side in (x + w - rect.x1, rect.y0 - (y - h), y + h - rect.y1):
        out += np.maximum(side, 0.0)
    return out
