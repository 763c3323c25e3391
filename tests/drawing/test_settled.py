"""The figures of a page where they cost a reader least: white in one piece, titles, order, margins."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.drawn_sheets import laid
from vecpoly.board.construction import View
from vecpoly.drawing.rect import Rect
from vecpoly.drawing.scene import Scene, Stroke
from vecpoly.drawing.sheets.packing import Layout, pack
from vecpoly.drawing.sheets.paging import Drawn, even, lined, standing
from vecpoly.drawing.sheets.settling.cost import SAME, standing_cost
from vecpoly.drawing.sheets.settling.settled import WHITE, settled
from vecpoly.drawing.sheets.settling.white import CELL, inked, white
from vecpoly.drawing.sheets.space import room_inside

PAGE = room_inside(False)
SIDES = st.floats(15.0, 100.0)
KINDS = (View.MECHANISM, View.VELOCITY, View.ACCELERATION, View.FORCE)


def _crossed(wide: float, high: float) -> Scene:
    """A rectangle with its diagonals."""
    around = Rect(0.0, 0.0, wide, high)
    a, b, c, d = around.corners
    return Scene((Stroke(points=(a, b, c, d, a, c, b, d), width=0.5),), around)


def _group(sizes: Sequence[tuple[float, float]]) -> list[Drawn]:
    return [Drawn(kind, "", _crossed(*size)) for kind, size in zip(KINDS, sizes, strict=False)]


def _cost(group: Sequence[Drawn], layout: Layout) -> float:
    ink = [inked((one.scene,), one.extents) for one in group]
    share = white([some + at for some, at in zip(ink, layout.corners, strict=True)], layout.page)
    return standing_cost(*standing(group, layout), layout) + WHITE * share


def test_white_is_the_largest_rectangle_that_nothing_touches() -> None:
    page = (20 * CELL, 10 * CELL)
    wall = inked(
        (Scene((Stroke(points=(0j, 10j * CELL), width=0.5),), Rect(0.0, 0.0, 1.0, 10 * CELL)),), Rect(0, 0, 1, 1)
    )
    assert white([], page) == 1.0
    assert white([wall + 5.5 * CELL], page) == pytest.approx(14 / 20)
    assert white([wall + 5.5 * CELL, wall + 12.5 * CELL], page) == pytest.approx(7 / 20)


@given(st.lists(st.tuples(SIDES, SIDES), min_size=2, max_size=4))
def test_figures_settle_nowhere_worse_and_keep_clear_of_each_other(sizes: Sequence[tuple[float, float]]) -> None:
    layout = pack(sizes, PAGE)
    assume(layout is not None)
    assert layout is not None
    group = _group(sizes)
    made, plain = settled(group, layout), even(group, lined(group, layout))
    assert _cost(group, made) <= _cost(group, plain) + 1e-9
    boxes, _ = standing(group, made)
    assert all(min(box.x0, box.y0) >= 0 and box.x1 <= PAGE[0] and box.y1 <= PAGE[1] for box in boxes)
    assert not any(a.overlaps(b) for a, b in combinations(boxes, 2))


def test_a_title_that_stands_with_no_other_and_an_order_that_goes_back_up_cost() -> None:
    boxes = [Rect(10, 10, 80, 100), Rect(100, 10, 180, 100)]
    layout = Layout(PAGE, (10 + 10j, 100 + 10j), 12.0)
    level = standing_cost(boxes, [15.0, 15.0], layout)
    assert standing_cost(boxes, [15.0, 20.0], layout) > level
    stacked = [Rect(10, 140, 180, 240), Rect(10, 10, 180, 110)]
    assert standing_cost(stacked[::-1], [15.0, 145.0], layout) > standing_cost(stacked, [145.0, 15.0], layout)


@pytest.mark.parametrize("name", ["2-12", "6-4"])
def test_titles_of_a_row_stand_on_one_line(name: str) -> None:
    (sheet,) = laid(name)
    feet = [one.extents.y0 + one.line for one in sheet.groups]
    assert all(sum(abs(one - other) < SAME for other in feet) > 1 for one in feet)
