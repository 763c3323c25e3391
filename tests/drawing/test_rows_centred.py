"""Figures of a row stand about the middle of its height, and their titles on one line."""

from __future__ import annotations

import pytest

from tests.drawn_sheets import laid
from vecpoly.drawing.scene import TextBox
from vecpoly.drawing.sheets.lifting import LOW
from vecpoly.drawing.sheets.sheet import Sheet


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
            marks = [m for m in one.figure.marks if type(m).__name__ == "Segment"]
            placed = [m.a + one.origin for m in marks]
            assert not placed or any(round(z.real, 3) + 1j * round(z.imag, 3) in ends for z in placed)
