"""What is done otherwise than the hand would do it: somebody's own readings and points, with which the construction
goes on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from ...foundation.frozen import FrozenMap
from ...plane import Points, Reals
from ...plane.traced import acts_of, bare, traced
from ..place import Place, named
from .slip import Mistake, Slip

T = TypeVar("T")
V = TypeVar("V", Points, Reals)


@dataclass(frozen=True, slots=True, kw_only=True)
class Amended:
    """readings: letters of a length (``pc``, ``bc2``, or with its figure ``velocity:bc``) → mm; points: a letter → its
    place in mm.

    A reading, or a point, by many hands keeps its scatter: all are moved together. slip: one mistake.
    """

    readings: Mapping[str, float] = FrozenMap({})
    points: Mapping[str, complex] = FrozenMap({})
    slip: Slip | None = None

    def reading(self, place: Place | None, letters: str, read: Reals) -> Reals:
        """The length to go on with."""
        own = _of(self.readings, place, plain_letters(letters), plain_letters(" ".join(reversed(letters.split()))))
        return read if own is None else _moved(read, own)

    def point(self, place: Place, letter: str, at: Points) -> Points:
        """The point to go on with."""
        own = _of(self.points, place, plain_letters(letter))
        return at if own is None else _moved(at, own)

    def mistake(self, place: Place | None, key: str) -> Mistake | None:
        """What is done wrongly with this quantity, or at this letter."""
        slip = self.slip
        return slip.mistake if slip is not None and key and slip.key in named(place, key) else None


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
