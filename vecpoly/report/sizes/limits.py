"""In the frame of what is given: the lines of the coupler in both limits of a crank-rocker, with their directions."""

from __future__ import annotations

from collections.abc import Sequence

from ...board.paper.marks import Dot, Mark, Point
from ...designs.limit_lines import LimitLines
from .lines import AXIS, angle, ray

_LONG, _ARC = 1.5 * AXIS, 0.6 * AXIS  # mm of a line, and to its arc


def lines_of_limits(subject: LimitLines, marks: Sequence[Mark]) -> tuple[Mark, ...]:
    """A thin line in each direction that is given, short enough to tell nothing of where they meet."""
    spots = {mark.label: mark.at for mark in marks if isinstance(mark, Point) and mark.dot is not Dot.NONE}
    found = list[Mark]()
    for number, line in enumerate((subject.line_1, subject.line_2), 1):
        if (at := spots.get(f"C_{number}")) is not None:
            found += ray(at, line.si, _LONG)
            found += angle(at, line.si, f"δ_{number}", _ARC)
    return tuple(found)
