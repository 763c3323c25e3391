"""Figures of a sheet drawn together: no nearer to the frame than to each other, their titles on their lines."""

from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.drawing.rect import Rect
from vecpoly.drawing.sheets.mounting.evening import ASUNDER, MARGIN, evened
from vecpoly.drawing.sheets.mounting.spreading import sunk

PAGE = (190.0, 260.0)


def moved(boxes: list[Rect], moves: list[complex]) -> list[Rect]:
    return [box.moved(by) for box, by in zip(boxes, moves, strict=True)]


def white(a: Rect, b: Rect) -> float:
    return max(b.x0 - a.x1, a.x0 - b.x1, b.y0 - a.y1, a.y0 - b.y1)


def test_two_figures_have_as_much_white_to_the_frame_as_between_them() -> None:
    boxes = [Rect(40, 165, 150, 255), Rect(40, 5, 150, 95)]
    upper, lower = moved(boxes, evened(boxes, [165, 5], PAGE))
    assert min(lower.y0, PAGE[1] - upper.y1) >= MARGIN - 1e-6
    assert lower.y0 == pytest.approx(PAGE[1] - upper.y1)


def test_figures_whose_titles_stand_on_one_line_keep_it() -> None:
    boxes = [Rect(3, 150, 80, 255), Rect(110, 170, 187, 240), Rect(4, 4, 186, 80)]
    lines = [155.0, 155.0, 9.0]
    moves = evened(boxes, lines, PAGE)
    assert moves[0].imag == pytest.approx(moves[1].imag)
    left, right, _ = moved(boxes, moves)
    assert min(left.x0, PAGE[0] - right.x1) > 10


@given(st.lists(st.tuples(st.floats(10, 60), st.floats(10, 50)), min_size=1, max_size=9))
def test_figures_drawn_together_keep_clear_of_each_other_and_stay_on_the_page(sizes: list[tuple[float, float]]) -> None:
    cells = [(i % 3, i // 3) for i in range(len(sizes))]
    tops = [complex(62 * i, 260 - 80 * j) for i, j in cells]
    boxes = [Rect(at.real, at.imag - h, at.real + w, at.imag) for at, (w, h) in zip(tops, sizes, strict=True)]
    made = moved(boxes, evened(boxes, [box.y0 for box in boxes], PAGE))
    assert all(b.x0 >= -1e-6 and b.x1 <= PAGE[0] + 1e-6 and b.y0 >= -1e-6 and b.y1 <= PAGE[1] + 1e-6 for b in made)
    for (a, b), (c, d) in zip(combinations(made, 2), combinations(boxes, 2), strict=True):
        assert white(a, b) >= min(white(c, d), ASUNDER) - 1e-6


def test_a_figure_does_not_come_nearer_to_the_results_that_stand_still() -> None:
    boxes, still = [Rect(5, 200, 60, 255), Rect(5, 5, 60, 60)], Rect(64, 3, 187, 60)
    lower = moved(boxes, evened(boxes, [200, 5], PAGE, (still,)))[1]
    assert white(lower, still) >= 4 - 1e-6


def test_a_title_that_stands_alone_goes_up_where_it_cannot_go_down() -> None:
    boxes = [Rect(0, 40, 50, 100), Rect(60, 75, 100, 135), Rect(60, 0, 100, 45)]
    falls = sunk(boxes, [41, 76, 2], (Rect(0, 0, 50, 39),), 2.0)
    assert falls == pytest.approx([-35, 0, 0])
