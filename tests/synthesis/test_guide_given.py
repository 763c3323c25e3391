"""The guide of a slider whose positions are given is part of what is given: its rail and block stand in the sketch."""

from __future__ import annotations

import pytest

from vecpoly.board.paper.marks import FixedGuide
from vecpoly.problem.load import load
from vecpoly.solution import solve


@pytest.mark.parametrize("name", ["8-9", "8-10", "8-13", "8-14"])
def test_the_block_on_its_guide_is_drawn_with_the_given_positions_and_once(name: str) -> None:
    marks = [
        mark for figure in solve(load(name), repeats=0, precise=False).construction.figures for mark in figure.marks
    ]
    blocks = [mark for mark in marks if mark.owner == "slider"]
    assert blocks and {mark.step for mark in blocks} == {1}
    assert any(isinstance(mark, FixedGuide) and mark.step == 1 for mark in marks)
