"""Figures of a row stand about the middle of its height, and their titles on one line."""

from __future__ import annotations

import cmath

import pytest

from tests.drawn_library import drawn
from tests.drawn_sheets import laid
from tests.label_faults import text_of
from vecpoly.board.paper.marks import AngleMark, Segment
from vecpoly.drawing.figure import drawing
from vecpoly.drawing.scene import TextBox
from vecpoly.drawing.sheets.mounting.lifting import LOW
from vecpoly.drawing.sheets.sheet import Sheet
from vecpoly.drawing.symbols.angles import draw_angle


def _titles(sheet: Sheet) -> list[float]:
    """On which height the title of each figure stands."""
    found = []
    for one, scene in sheet.parts:
        titles = 2 if one.figure is not None and one.figure.scale.symbol else 1
        title = scene.items[-titles]
        assert isinstance(title, TextBox)
        found.append(title.y)
    return found


@pytest.mark.parametrize("name", ["5-2", "6-3b", "4-4"])
def test_a_low_figure_of_a_row_stands_about_the_middle_of_its_height(name: str) -> None:
    """They stood at the foot of their rows, at as many heights as there were figures."""
    raised = 0
    for sheet in laid(name):
        lines = _titles(sheet)
        boxes = [one.extents for one in sheet.figures]
        assert not any(a is not b and a.overlaps(b) for a in boxes for b in boxes)
        for (_one, scene), line in zip(sheet.parts, lines, strict=True):
            body = [item for item in scene.items[:-2] if not isinstance(item, TextBox)]
            lowest = min(z.imag for item in body for z in getattr(item, "points", ()))
            raised += lowest - line > LOW
    assert raised


@pytest.mark.parametrize("name", ["5-2", "6-3b"])
def test_a_figure_that_is_raised_keeps_its_origin_on_it(name: str) -> None:
    """By the origin of a figure its points are found on the sheet."""
    for sheet in laid(name):
        for one, scene in sheet.parts:
            if one.figure is None:
                continue
            ends = {round(z.real, 3) + 1j * round(z.imag, 3) for i in scene.items for z in getattr(i, "points", ())}
            marks = [m for m in one.figure.marks if isinstance(m, Segment)]
            placed = [m.a + one.origin for m in marks]
            assert not placed or any(round(z.real, 3) + 1j * round(z.imag, 3) in ends for z in placed)


def test_two_narrow_angles_side_by_side_have_arcs_alone_with_their_letters_beside_them() -> None:
    """Arrowheads of both lay on the line between them: φ of a friction cone could not be read."""
    cones = next(one for one in drawn("5-2").construction.figures if one.name == "cones")
    angles = [mark for mark in cones.marks if isinstance(mark, AngleMark)]
    assert len(angles) == 4
    assert all(len(draw_angle(mark, angles)) == 1 < len(draw_angle(mark)) for mark in angles)
    letters = [label for label in drawing(cones).labels if text_of(label) == "φ"]
    ends = [mark.at + cmath.rect(mark.radius, mark.start + part * mark.sweep) for mark in angles for part in (0, 1)]
    assert all(min(abs(label.centre - end) for end in ends) < 4.5 for label in letters)
