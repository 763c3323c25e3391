"""Places once found for letters are kept by what they stand among: a sketch beside the statement, a sheet in colours or
in black, both languages of a report often letter one figure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field
from functools import lru_cache
from typing import Any

from ...foundation.slotted import dataclass, replace
from ..scene import Fill, Item, Rect, Stroke
from .about.obstacles import Obstacles, is_solid
from .ground import gives_way, is_ground
from .placing import Placed, place
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
    known_by: Key

    @classmethod
    def of(
        cls,
        wanted: tuple[Want, ...],
        items: tuple[Item, ...],
        drawn: Rect,
        frame: Rect | None = None,
        unnamed: tuple[Spot, ...] = (),
        grounds: tuple[Line, ...] = (),
    ) -> Lettering:
        """Of a figure without its letters."""
        return cls(wanted, items, drawn, frame, unnamed, grounds, (*map(_asks, wanted), *map(_stands, items)))

    @property
    def placed(self) -> tuple[Placed, ...]:
        """Each label at its place, the same whenever it is asked for."""
        return tuple(map(_as_wanted, self.wanted, _placed(self)))


@lru_cache(maxsize=KEPT)
def _placed(one: Lettering) -> Sequence[Placed]:
    return place(one.wanted, Obstacles.of(one.items), one.drawn, one.frame, one.unnamed, one.grounds)


def places_forgotten() -> None:
    """From here on all are sought again."""
    _placed.cache_clear()


def _as_wanted(want: Want, found: Placed) -> Placed:
    """A label where one that is as large was placed."""
    if found.want is want:
        return found
    own = replace(want, farther=True) if found.want.farther and not want.farther else want
    return Placed(own, found.centre, found.cost, found.foot)


def _asks(want: Want) -> Key:
    """What tells where a label may go."""
    size = (want.width, want.height, want.radius)
    flags = (want.one_sided, want.thing, want.farther, want.level)
    return (*size, *flags, want.feet, want.normals, want.own, want.bow)


def _stands(item: Item) -> Key:
    """What tells how far labels keep clear of a line or an area."""
    match item:
        case Stroke(points=points, width=width, closed=closed):
            return points, width, closed, is_ground(item), gives_way(item)
        case Fill(points=points):
            return points, is_solid(item)
        case _:
            return (item.rect,)
