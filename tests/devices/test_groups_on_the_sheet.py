"""How a structure stands on its sheet: groups as they are put together, the frame's number, the arrows of drivers."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Block, LinkNumber, Role, Segment, TurnArrow


@pytest.mark.parametrize("name", ["2-4", "2-6", "2-9"])
def test_the_driver_stands_first_and_the_group_that_was_detached_first_stands_last(name: str) -> None:
    names = [figure.name for figure in drawn(name).figures(View.MECHANISM)]
    groups = [one for one in names if one.startswith("group ")]
    assert names.index("left 1") < names.index(groups[0])
    assert groups == sorted(groups, reverse=True) and groups[-1] == "group 1 1"


@pytest.mark.parametrize("name", ["2-1", "2-4", "2-11"])
def test_the_frame_has_its_number_on_the_diagram(name: str) -> None:
    first = drawn(name).figures(View.MECHANISM)[0]
    (number,) = (mark for mark in first.marks if isinstance(mark, LinkNumber) and mark.owner == "frame")
    assert number.number == {"2-11": "5"}.get(name, "0")


def test_drivers_that_share_a_pivot_have_an_arrow_each_with_its_name() -> None:
    first = drawn("2-8full").figures(View.MECHANISM)[0]
    arrows = [mark for mark in first.marks if isinstance(mark, TurnArrow)]
    assert [one.label for one in arrows] == ["ω_1", "ω_3"]
    assert len({one.at for one in arrows}) == 1 and len({one.radius for one in arrows}) == 2


def test_the_way_of_a_block_whose_guide_is_taken_away_is_longer_than_the_block() -> None:
    group = next(one for one in drawn("2-4").figures(View.MECHANISM) if one.name == "group 1 1")
    (block,) = (mark for mark in group.marks if isinstance(mark, Block))
    (way,) = (mark for mark in group.marks if isinstance(mark, Segment) and mark.role is Role.CENTRE)
    assert all(abs(end - block.at) > block.length for end in (way.a, way.b))
