"""Letters of a place that a detail shows: what finds no place beside its own there is left to the detail."""

from __future__ import annotations

import re

from ..board.construction import Figure
from ..board.paper.marks import Arc
from .labels.want import Thing
from .symbols.around import RING
from .weighing.placed import Placed

_DETAIL = re.compile(r"(^| )detail \d+$")  # as figures of details are named
FAR = 7.0  # mm from a point to the middle of its letter beyond which a leader tells less than the detail


def is_astray(figure: Figure, label: Placed) -> bool:
    """Whether it is the letter of a point in the ring of a detail, that stands far from it on a leader."""
    if label.foot is None or _DETAIL.search(figure.name):
        return False
    if label.want.thing is not Thing.POINT or abs(label.centre - label.want.own[0]) < FAR:
        return False  # another thing, or near to its own
    rings = (mark for mark in figure.marks if isinstance(mark, Arc) and mark.owner == RING)
    return any(abs(label.want.own[0] - ring.centre) < ring.radius for ring in rings)
