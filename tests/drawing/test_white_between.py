"""Bands that are white between the figures of a page are seen as well as those about them."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import pytest

from tests.drawn_sheets import laid
from vecpoly.board.construction import View
from vecpoly.drawing.sheets.packing import Layout, pack
from vecpoly.drawing.sheets.pages import FULLER, INKED, covered, inked, plated
from vecpoly.drawing.sheets.slicing import Size
from vecpoly.drawing.sheets.space import is_page

PAGE = (190.0, 261.0)


@dataclass(frozen=True)
class Sketch:
    """A figure of this size."""

    size: Size
    view: View = View.MECHANISM
    name: str = ""


def _on_page(*sizes: Size) -> tuple[list[Sketch], Layout]:
    layout = pack(sizes, PAGE)
    assert layout is not None
    return [Sketch(one) for one in sizes], layout


def test_two_low_figures_that_a_broad_band_parts_have_a_plate_as_high_as_they_are() -> None:
    figures, layout = _on_page((164.0, 95.0), (150.0, 75.0))
    made = plated(figures, layout)
    assert covered(figures, layout) > 0.7 and inked(figures, layout) < INKED
    assert not is_page(made.page) and inked(figures, made) > inked(figures, layout) + FULLER


@pytest.mark.parametrize("sizes", [((170.0, 125.0), (165.0, 118.0)), ((180.0, 240.0),)])
def test_a_page_that_figures_fill_stays_a_page(sizes: tuple[Size, ...]) -> None:
    figures, layout = _on_page(*sizes)
    assert plated(figures, layout) is layout


@pytest.mark.parametrize("name", ["straight-roberts", "5-5", "C-inertia"])
def test_on_a_first_sheet_no_band_between_figures_takes_a_fifth_of_it(name: str) -> None:
    sheet = laid(name)[0]
    boxes = [one.extents for one in sheet.figures]
    ends = sorted({y for box in boxes for y in (box.y0, box.y1)})
    bands = (high - low for low, high in pairwise(ends) if not any(b.y0 < high and b.y1 > low for b in boxes))
    assert max(bands, default=0.0) < sheet.room[1] / 5
