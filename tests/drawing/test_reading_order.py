"""Figures on one sheet are read row by row; what a caption and a letter tell is told once."""

from __future__ import annotations

from itertools import pairwise

import pytest

from tests.drawn_library import drafted
from tests.drawn_sheets import laid
from tests.studies import solved
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Curve, Point, Role, Segment
from vecpoly.drawing.details.apart import is_detail
from vecpoly.drawing.figure import titled
from vecpoly.drawing.sheets.packing import packed
from vecpoly.drawing.sheets.slicing import Cut, Slicing, is_read
from vecpoly.drawing.style import THIN, Hue, pen
from vecpoly.methods.forces.lines.letters import foot_letter


def test_a_column_before_another_is_not_read_row_by_row() -> None:
    row, column = Cut(False, (0, 1)), Cut(True, (0, 1))
    assert is_read(Cut(True, (row, 2))) and is_read(Cut(False, (0, Cut(True, (1, 2)))))
    assert not is_read(Cut(False, (column, 2)))


def test_of_four_like_figures_the_second_stands_beside_the_first() -> None:
    sizes = [(60.0, 50.0), (60.0, 49.0), (60.0, 50.0), (60.0, 49.0)]
    made = packed(Slicing([(w + 2.5, h + 2.5) for w, h in sizes], (187.5, 171.5)), 0, 4, sizes, (190.0, 174.0))
    assert made is not None
    tops = [at.imag + h for at, (_, h) in zip(made.corners, sizes, strict=True)]
    assert all(high >= low - 25.0 for high, low in pairwise(tops))


@pytest.mark.parametrize("name", ["8-4", "2-5"])
def test_a_solution_stands_before_the_next(name: str) -> None:
    for sheet in laid(name):
        boxes = [one.extents for one in sheet.figures if one.figure is None or not is_detail(one.name, one.figure)]
        for one, other in pairwise(boxes):
            assert other.y0 < one.y1


@pytest.mark.parametrize("name", ["cam-knife-load", "two-trains-one-sun", "4-3c"])
def test_a_diagram_on_which_lines_stand_for_forces_says_so(name: str) -> None:
    diagram = next(one for one in solved(name).construction.figures if one.view is View.MECHANISM)
    assert titled(diagram).zh.endswith("力的作用线") and titled(diagram).en.endswith("lines of action")


def test_a_diagram_without_forces_has_its_plain_title() -> None:
    diagram = next(one for one in solved("planet-drive").construction.figures if one.view is View.MECHANISM)
    assert titled(diagram) == View.MECHANISM.title


def test_the_foot_of_a_velocity_has_no_letter_of_a_point_of_a_link() -> None:
    assert foot_letter("d", "F_{3}") == "d_{F3}" and foot_letter("b", "F") == "b_{F}"
    assert foot_letter("s_2", "F_{I2}") == "s_{2,I2}"


def test_the_normal_of_the_driving_link_has_its_number() -> None:
    figures = solved("planet-drive").construction.figures
    letters = {m.label for one in figures for m in one.marks if isinstance(m, Point) and m.label[:1] == "n"}
    assert {"n_1^′", "n_2^′", "n_3^′"} <= letters and "n′" not in letters


def test_the_places_of_a_rack_are_lighter_than_the_tooth_that_they_leave() -> None:
    solution = drafted("gear-shifted")
    assert solution is not None
    (one,) = solution.construction.figures
    assert any(isinstance(m, Segment) and m.role is Role.PLACE for m in one.marks)
    light = pen(Role.PLACE, Hue.BLACK)
    assert light.width < THIN and light.hue.value > Hue.GREY.value
    tooth = [z for m in one.marks if isinstance(m, Curve) and m.role is Role.LINK for z in m.points]
    root = min(map(abs, tooth))
    assert sum(abs(abs(z) - root) < 0.05 for z in tooth) >= 4
