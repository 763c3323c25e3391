"""The room that a figure takes in its frame: its lines, and the feet of pivots that stand out from them; whether a
place in it is free."""

from __future__ import annotations

from collections.abc import Sequence

from ....board.construction import Figure
from ....board.paper.extent import bounds, box_of
from ....board.paper.marks import Ground, Mark
from ....drawing.symbols.bodies import foot_of
from .through import Box

_OUT = 2.0  # mm by which a hatched foot may come nearer to the frame than lines do
_HATCHED = 3.0  # mm about a mark that its hatching or its letter may take


def outline(figure: Figure) -> Box:
    """The box about a figure, its pivots with their feet."""
    low, high = bounds(figure.marks)
    feet = (
        mark.at + _pulled(end - mark.at) for mark in figure.marks if isinstance(mark, Ground) for end in foot_of(mark)
    )
    return box_of([low, high, *feet])


def _pulled(way: complex) -> complex:
    return way * max(0.0, 1.0 - _OUT / abs(way))


def is_free(low: complex, high: complex, marks: Sequence[Mark]) -> bool:
    """Whether none of these marks stands in the box between these corners, no foot of a pivot either."""
    boxes = [box_of([*bounds([mark]), *(foot_of(mark) if isinstance(mark, Ground) else ())]) for mark in marks]
    return not any(
        a.real - _HATCHED < high.real
        and b.real + _HATCHED > low.real
        and a.imag - _HATCHED < high.imag
        and b.imag + _HATCHED > low.imag
        for a, b in boxes
    )
