"""Where a box stands in the room about a figure: the figure grows as little as it can."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.drawing.details.room import CELL, FAR, WHITE, Grow, Room, filled, reach_of
from vecpoly.drawing.rect import Rect

SIDES = st.integers(20, 90).map(float)
SHARES = st.floats(0.0, 1.0)


def put(figure: Rect, box: Rect, wanted: complex, grow: Grow) -> Rect:
    """The box beside a figure that is ink all over."""
    return Room.about(figure, [filled(figure)], reach_of([box])).put(box, wanted, grow)


def growth(figure: Rect, found: Rect) -> tuple[float, float]:
    """How much wider, and how much higher."""
    whole = figure | found
    return whole.width - figure.width, whole.height - figure.height


@pytest.mark.parametrize("grow", list(Grow))
@given(wide=SIDES, high=SIDES, box=st.tuples(st.floats(0.3, 0.8), st.floats(0.3, 0.8)))
def test_a_full_figure_grows_for_a_box_in_the_one_direction_in_which_that_is_worth_less(
    grow: Grow, wide: float, high: float, box: tuple[float, float]
) -> None:
    figure, size = Rect(0.0, 0.0, wide, high), Rect(0.0, 0.0, box[0] * wide, box[1] * high)
    wider, higher = growth(figure, put(figure, size, figure.centre, grow))
    assert min(wider, higher) <= CELL < max(wider, higher)
    along, up, level = grow.value
    sideways, upwards = along * (size.width + WHITE) * high, up * (size.height + WHITE) * wide
    slack = level * wide * high + FAR * wide * high * max(wide, high) + 2 * CELL * (wide + high)  # level, near, cells
    taken, left = (sideways, upwards) if wider > CELL else (upwards, sideways)
    assert taken <= left + slack


@given(wide=SIDES, high=SIDES, free=st.tuples(SHARES, SHARES), grow=st.sampled_from(list(Grow)))
def test_a_box_that_has_room_within_its_figure_stands_there(
    wide: float, high: float, free: tuple[float, float], grow: Grow
) -> None:
    hole, figure = 12.0 + 2 * WHITE + 3 * CELL, Rect(0.0, 0.0, wide + 40.0, high + 40.0)
    x, y = free[0] * (figure.width - hole), free[1] * (figure.height - hole)
    ink = filled(figure)
    within = (abs(ink.real - x - hole / 2) < hole / 2) & (abs(ink.imag - y - hole / 2) < hole / 2)
    room = Room.about(figure, [np.asarray(ink[~within])], 30.0)
    found = room.put(Rect(0.0, 0.0, 12.0, 12.0), complex(x, y) + complex(hole, hole) / 2, grow)
    assert growth(figure, found) == (0.0, 0.0)
    assert room.extents == figure
