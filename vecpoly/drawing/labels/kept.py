"""Places once found for letters are kept by what they stand among: a sketch beside the statement, a sheet in colours or
in black, both languages of a report often letter one figure."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import lru_cache
from typing import Any

from ...foundation.slotted import dataclass, replace
from ..scene import Fill, Item, Rect, Stroke
from ..weighing.placed import Placed
from ..weighing.prices import Around
from .about.obstacles import Obstacles, is_solid
from .ground import gives_way, is_ground
from .placing import place
from .want import Line, Spot, Want

KEPT = 64  # figures
Key = tuple[Any, ...]


@dataclass(frozen=True, slots=True)
class Lettering:
    """The labels of a figure before they have places, among its lines; two are equal where all that tells where the
    labels go is: of what colour anything is and what the letters are, if they are as large, does not."""

    wanted: tuple[Want, ...] = field(compare=False)
    items: tuple[Item, ...] = field(compare=False)
    drawn: Rect
    frame: Rect | None
    unnamed: tuple[Spot, ...]
    grounds: tuple[Line, ...]
    polygon: bool
    known_by: Key = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "known_by", (*map(_asks, self.wanted), *map(_stands, self.items)))

    @property
    def placed(self) -> tuple[Placed, ...]:
        """Each label at its place, the same whenever it is asked for; what a crowd spares is left out."""
        return tuple(_as_wanted(self.wanted[i], found) for i, found in _placed(self).items())


@lru_cache(maxsize=KEPT)
def _placed(one: Lettering) -> Mapping[int, Placed]:
    obstacles = Obstacles.of(one.items)
    return place(Around(obstacles, one.wanted, one.drawn, one.frame, one.unnamed, one.grounds, one.polygon))


def places_forgotten() -> None:
    """From here on all are sought again."""
    _placed.cache_clear()


def _as_wanted(want: Want, found: Placed) -> Placed:
    """A label where one that is as large was placed."""
    if found.want is want:
        return found
    said = want.in_brief if want.brief and not found.want.brief else want
    own = replace(said, farther=True) if found.want.farther and not want.farther else said
    return Placed(own, found.centre, found.cost, found.foot)


def _asks(want: Want) -> Key:
    """What tells where a label may go, and whether it may be left out or say less."""
    size = (want.width, want.height, want.radius)
    flags = (want.one_sided, want.thing, want.farther, want.level, want.is_number)
    less = _asks(want.in_brief) if want.brief else ()
    return (*size, *flags, want.feet, want.normals, want.own, want.bow, less)


def _stands(item: Item) -> Key:
    """What tells how far labels keep clear of a line or an area."""
    match item:
        case Stroke(points=points, width=width, closed=closed):
            return points, width, closed, is_ground(item), gives_way(item)
        case Fill(points=points):
            return points, is_solid(item)
        case _:
            return (item.rect,)
