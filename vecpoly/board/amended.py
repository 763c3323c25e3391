"""What is done otherwise than the hand would do it: somebody's own readings and points, with which the construction goes on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypeVar

from ..frozen import FrozenMap
from ..plane import Points, Reals, nominal
from .place import Place, view_of

T = TypeVar("T")


@dataclass(frozen=True, slots=True, kw_only=True)
class Amended:
    """readings: letters of a length (``pc``, ``bc2``, or with its figure ``velocity:bc``) → mm; points: a letter → its place in mm.

    A reading, or a point, by many hands keeps its scatter: all are moved together.
    """

    readings: Mapping[str, float] = FrozenMap({})
    points: Mapping[str, complex] = FrozenMap({})

    def reading(self, place: Place | None, letters: str, read: Reals) -> Reals:
        """The length to go on with."""
        own = _of(self.readings, place, plain_letters(letters), plain_letters(" ".join(reversed(letters.split()))))
        return read if own is None else read + (own - float(nominal(read)))

    def point(self, place: Place, letter: str, at: Points) -> Points:
        """The point to go on with."""
        own = _of(self.points, place, letter)
        return at if own is None else at + (own - complex(nominal(at)))


AS_DRAWN = Amended()


def _of(given: Mapping[str, T], place: Place | None, *letters: str) -> T | None:
    """The value given under any of these letters, with the figure before them or without."""
    if not given:
        return None
    figure = "" if place is None else f"{view_of(place).value}:"
    return next((given[key] for name in letters for key in (f"{figure}{name}", name) if key in given), None)


def plain_letters(letters: str) -> str:
    """The letters of a length as one types them: ``p c_2`` → ``pc2``, ``n_3^′ c^′`` → ``n3'c'``."""
    return letters.translate(_PLAIN)


_PLAIN = str.maketrans({" ": None, "_": None, "^": None, "{": None, "}": None, "′": "'"})
