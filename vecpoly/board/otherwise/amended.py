"""What is done otherwise than the hand would do it:
somebody's own readings and points, with which the construction goes on."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TypeVar

import numpy as np

from ...foundation.frozen import FrozenMap
from ...foundation.slotted import dataclass
from ...plane import Points, Reals, nominal
from ...plane.traced import acts_of, bare, traced
from ..place import Place, named
from .slip import Slip

T = TypeVar("T")
V = TypeVar("V", Points, Reals)


@dataclass(frozen=True, slots=True, kw_only=True)
class Own:
    """What somebody goes on with: lengths read (mm) by their letters, results computed (SI) by their keys, points by
    their letters: how far from the right place they lie (mm)."""

    readings: Mapping[str, float] = FrozenMap({})
    values: Mapping[str, float] = FrozenMap({})
    shifts: Mapping[str, complex] = FrozenMap({})


@dataclass(frozen=True, slots=True, kw_only=True)
class Amended:
    """readings: letters of a length (``pc``, ``bc2``, or with its figure ``velocity:bc``) → mm;
    points: a letter → its place in mm.

    values: key of what is computed on the way → the size of somebody's own result (SI), negative where its sense is the
    other one.
    A reading, or a point, by many hands keeps its scatter: all are moved together. slip: one mistake,
    by every hand. each: one mistake by each of the repeated hands, the first by the first; the nominal sheet makes
    none.
    own: the readings and values of further hands, each with its own.
    """

    readings: Mapping[str, float] = FrozenMap({})
    points: Mapping[str, complex] = FrozenMap({})
    values: Mapping[str, float] = FrozenMap({})
    slip: Slip | None = None
    each: tuple[Slip, ...] = ()
    own: tuple[Own, ...] = ()

    def reading(self, place: Place | None, letters: str, read: Reals) -> Reals:
        """The length to go on with."""
        names = plain_letters(letters), plain_letters(" ".join(reversed(letters.split())))
        own = _of(self.readings, place, *names)
        read = read if own is None else _moved(read, own)
        return self.altered(read, self._by_others([one.readings for one in self.own], place, *names))

    def point(self, place: Place, letter: str, at: Points) -> Points:
        """The point to go on with."""
        own = _of(self.points, place, plain_letters(letter))
        at = at if own is None else _moved(at, own)
        shifts = self._by_others([one.shifts for one in self.own], place, plain_letters(letter))
        return self.altered(at, ((hand, at + by) for hand, by in shifts))

    def value(self, place: Place | None, key: str, found: Reals) -> Reals:
        """The result to go on with."""
        own = _of(self.values, place, key)
        if own is None and not self.own:
            return found
        sense = -1.0 if nominal(found) < 0 else 1.0
        found = found if own is None else _moved(found, sense * own)
        mine = self._by_others([one.values for one in self.own], place, key)
        return self.altered(found, ((hand, sense * size) for hand, size in mine))

    def _by_others(self, given: Sequence[Mapping[str, T]], place: Place | None, *names: str) -> Iterator[tuple[int, T]]:
        """The numbers of the hands that have their own under one of these names, each with it."""
        for hand, mine in enumerate(given, 1 + len(self.each)):
            if (own := _of(mine, place, *names)) is not None:
                yield hand, own

    def wrong(self, place: Place | None, key: str) -> tuple[tuple[int | None, Slip], ...]:
        """Who makes a mistake with this quantity, and which: the number of the hand, None for all of them."""
        slip = self.slip
        if (slip is None and not self.each) or not key:
            return ()
        names = named(place, key)
        all_of_them = ((None, slip),) if slip is not None and slip.key in names else ()
        return (*all_of_them, *((i, one) for i, one in enumerate(self.each, 1) if one.key in names))

    def altered(self, value: V, others: Iterable[tuple[int | None, V]]) -> V:
        """The value where these hands have another one instead."""
        for hand, other in others:
            if hand is None:
                value = other
                continue
            every = np.array(np.broadcast_to(bare(value), (1 + len(self.each) + len(self.own),)))
            every[hand] = bare(other)[hand] if np.ndim(bare(other)) else bare(other)
            value = traced(every, acts_of(value, other))
        return value


AS_DRAWN = Amended()


def _moved(found: V, own: complex) -> V:
    """What was found by every hand, moved so that the nominal sheet has somebody's own."""
    alone = bare(found)
    if np.ndim(alone) == 0:
        return traced(type(alone)(own), acts_of(found))  # type: ignore[no-any-return]
    moved = alone + (own - alone[0])
    moved[0] = own
    return traced(moved, acts_of(found))  # type: ignore[no-any-return]


def _of(given: Mapping[str, T], place: Place | None, *letters: str) -> T | None:
    """The value given under any of these letters, with the figure before them or without."""
    if not given:
        return None
    return next((given[key] for name in letters for key in named(place, name) if key in given), None)


def plain_letters(letters: str) -> str:
    """The letters of a length as one types them: ``p c_2`` → ``pc2``, ``n_3^′ c^′`` → ``n3'c'``."""
    return letters.translate(_PLAIN)


_PLAIN = str.maketrans({" ": None, "_": None, "^": None, "{": None, "}": None, "′": "'"})
