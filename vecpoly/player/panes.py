"""How large the pane of each figure is: its polygons and its links are seen at every place; far points of a
construction may remain outside."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from math import sqrt

import numpy as np

from ..board.construction import Figure, View
from ..board.paper.extent import bounds
from ..board.paper.marks import (
    Block,
    FrictionCircle,
    GearMark,
    Ground,
    LinkNumber,
    Passing,
    Plate,
    RackMark,
    Role,
    Segment,
    Slot,
    Weld,
)
from ..drawing.scene import Rect
from ..drawing.style import LETTER
from .fitting import SIDE

Places = Sequence[Figure | None]
AROUND = 12.0  # mm that lettering and title take round a figure
LEGIBLE = 0.022  # letters that are this part of the sheet's width can be read
BODIES = (Block, FrictionCircle, GearMark, Ground, LinkNumber, Passing, Plate, RackMark, Slot, Weld)
BESIDE = 22.0  # mm beside the links, for letters, arrows, angles and guides
FAR = 0.1  # of a mechanism's size: what its construction may take beyond it
AWAY = 1.5  # of a mechanism's size: links that go farther, towards a dead point, are let out of the pane
OFTEN = 10  # per cent of the places whose construction may leave the pane on a side


def pane(given: Rect, seen: Sequence[Rect], figures: Places) -> Rect:
    """The pane of a figure that takes `given` at the given place, and `seen` at all."""
    whole, drawn = reduce(Rect.__or__, seen, given), [figure for figure in figures if figure is not None]
    if drawn[0].view is not View.MECHANISM:
        return _within(whole, given.grown(2 * SIDE))
    own = [_box(figure, links=True) for figure in drawn]
    usual = _often(own)
    size = max(usual.width, usual.height)
    links = reduce(Rect.__or__, own)
    links = (links if _within(links, usual.grown(AWAY * size)) == links else usual).grown(BESIDE)
    return _within(whole, links | _within(_often(seen), links.grown(FAR * size)))


def _often(boxes: Sequence[Rect]) -> Rect:
    """What most of them take on each side."""
    sides = zip(("x0", "y0", "x1", "y1"), (OFTEN, OFTEN, 100 - OFTEN, 100 - OFTEN), strict=True)
    return Rect(*(float(np.percentile([getattr(one, side) for one in boxes], share)) for side, share in sides))


def magnified(places: Sequence[Places], start: int) -> float:
    """How much larger letters must be so that they can be read where all figures are seen at once."""
    area = 0.0
    for figures in places:
        given = figures[start]
        if given is not None:
            room = pane(_box(given), [_box(one) for one in figures if one is not None], figures).grown(AROUND)
            area += room.width * room.height
    return min(max(LEGIBLE * sqrt(area) / LETTER, 1.0), 1.6)


def _box(figure: Figure, links: bool = False) -> Rect:
    """What a figure's points take (mm); or its links' alone, if it has any."""
    bodies = [
        mark
        for mark in figure.marks
        if isinstance(mark, BODIES) or (isinstance(mark, Segment) and mark.role is Role.LINK)
    ]
    low, high = bounds(bodies if links and bodies else figure.marks)
    return Rect(low.real, low.imag, high.real, high.imag)


def _within(one: Rect, other: Rect) -> Rect:
    return Rect(max(one.x0, other.x0), max(one.y0, other.y0), min(one.x1, other.x1), min(one.y1, other.y1))
