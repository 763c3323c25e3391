"""The letter of an angle is of its arc, whether it stands beside that or, where the angle is narrow, outside of it."""

from __future__ import annotations

import pytest

from vecpoly.board.paper.marks import AngleMark
from vecpoly.drawing.labels import wants as module
from vecpoly.drawing.labels.want import Thing


@pytest.mark.parametrize("sweep", [0.1, -0.15, 1.2, -2.0])
def test_the_letter_of_an_angle_names_the_arc_and_so_is_told_from_another_angle_at_the_same_corner(
    sweep: float,
) -> None:
    mark = AngleMark(at=3 + 4j, radius=14.0, start=0.7, sweep=sweep, label="α")
    want = module._angle(mark, (mark,))
    assert want.thing is Thing.ARC and len(want.course) > 2
    assert [abs(z - mark.at) for z in want.course] == pytest.approx([mark.radius] * len(want.course))
    other = module._angle(AngleMark(at=3 + 4j, radius=22.0, start=0.7, sweep=sweep, label="β"), (mark,))
    assert other.course != want.course
