"""The room that a figure takes in its frame: its lines, and the feet of pivots that stand out from them."""

from __future__ import annotations

from ....board.construction import Figure
from ....board.paper.extent import bounds, box_of
from ....board.paper.marks import Ground
from ....drawing.symbols.bodies import foot_of
from .through import Box

_OUT = 2.0  # mm by which a hatched foot may come nearer to the frame than lines do


def outline(figure: Figure) -> Box:
    """The box about a figure, its pivots with their feet."""
    low, high = bounds(figure.marks)
    feet = (
        mark.at + _pulled(end - mark.at) for mark in figure.marks if isinstance(mark, Ground) for end in foot_of(mark)
    )
    return box_of([low, high, *feet])


def _pulled(way: complex) -> complex:
    return way * max(0.0, 1.0 - _OUT / abs(way))
