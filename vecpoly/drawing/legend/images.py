"""The sample of the images of links: where polygons of several kinds have them, one in the tint of each."""

from __future__ import annotations

from collections.abc import Sequence

from ...board.construction import Figure
from ...board.paper.marks import ImageOf
from ...foundation.slotted import replace
from ...words import Lang
from ..scene import Item, TextBox, moved
from .entry import WIDE, Entry, drawn_as_on
from .samples import image

_MOST = 2  # tints beside each other
_SHARE = 0.48  # of a sample for one of two


def tinted(some: Sequence[Entry], figures: Sequence[Figure], lang: Lang) -> list[Entry]:
    """The entries; that of images with a triangle in each of their tints."""
    marks = [(one, mark) for one in figures for mark in one.marks if isinstance(mark, ImageOf)]
    looks = {drawn_as_on(figure, image(mark), lang): None for figure, mark in marks}
    if len(looks) < _MOST:
        return [*some]
    both = [*looks][:_MOST]
    items = (
        moved(_narrowed(item), complex(n * (1 - _SHARE) * WIDE, 0.0)) for n, one in enumerate(both) for item in one
    )
    sample = tuple(items)
    return [replace(one, sample=sample) if one.sample in both else one for one in some]


def _narrowed(item: Item) -> Item:
    """As high as it was."""
    if isinstance(item, TextBox):
        return item
    return replace(item, points=tuple(complex(_SHARE * z.real, z.imag) for z in item.points))
