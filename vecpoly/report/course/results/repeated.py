"""Figures that are the same in every position: the circle diagram, limit positions; they stand on the first sheet."""

from __future__ import annotations

from math import prod

from ....board.construction import Construction, Figure
from ....board.paper.extent import bounds, extent
from ....board.paper.marks import Point
from ....drawing.sheets.space import room_inside
from ....foundation.slotted import replace
from ....foundation.stock import Format

_SAME = 0.05  # mm, and less than a hand reads
_FILLED = 0.35  # of a sheet


def without_repeated(drawn: Construction, first: Construction, of: Format) -> Construction:
    """A drawing without the figures that the first one has too; whole where what is left would not fill a sheet."""
    if drawn is first:
        return drawn
    before = {(one.view, one.name): one for one in first.figures}
    own = tuple(one for one in drawn.figures if not _is_same(one, before.get((one.view, one.name))))
    taken = sum(wide * high for wide, high in (extent(one.marks) for one in own))
    return replace(drawn, figures=own) if taken >= _FILLED * prod(room_inside(False, of)) else drawn


def _is_same(one: Figure, other: Figure | None) -> bool:
    if other is None or one.scale.value != other.scale.value or len(one.marks) != len(other.marks):
        return False
    ends = zip(bounds(one.marks), bounds(other.marks), strict=True)
    return _letters(one) == _letters(other) and all(abs(a - b) < _SAME for a, b in ends)


def _letters(figure: Figure) -> list[tuple[str, complex]]:
    """The letters with their places, to a tenth of a millimetre."""
    points = (mark for mark in figure.marks if isinstance(mark, Point))
    return [(mark.label, complex(round(mark.at.real, 1), round(mark.at.imag, 1))) for mark in points]
