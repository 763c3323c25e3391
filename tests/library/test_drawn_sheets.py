"""Sheets of the library are filled: figures reach the margins, or stand on a plate; scales are as large as will do."""

from __future__ import annotations

from statistics import median

import numpy as np
import shapely

from tests.drawn_library import DRAFTED, LIBRARY, drawn
from tests.drawn_sheets import laid, share, span
from tests.each import Later, each
from tests.laws import few
from vecpoly.board.construction import Figure
from vecpoly.board.paper.scales import finer
from vecpoly.drawing.scene import TextBox
from vecpoly.drawing.sheets.sheet import Sheet
from vecpoly.report.picture import diagram

FILLED, USUAL = 0.6, 0.75  # share of a sheet that its figures take at least, and as a rule
HULL = 0.6  # share of a sheet inside the convex hull of all ink, as a rule
SHEETS = Later(lambda: (name for name in DRAFTED if diagram(drawn(name).construction) is None))  # others have none
MORE = Later(
    lambda: (name for name in few(LIBRARY, 3) if diagram(drawn(name).construction) is None)
)  # for what is usual


def figures_of(name: str, sheet: Sheet) -> list[Figure]:
    """What stands on a sheet, without enlarged details."""
    there = {(placed.view, placed.name) for placed in sheet.figures}
    return [figure for figure in drawn(name).construction.figures if (figure.view, figure.name) in there]


def free(name: str, sheet: Sheet) -> bool:
    """Whether all its figures have a scale, which the file does not give, and which is tied to no other, as of a
    curve."""
    given, scales = drawn(name).problem.scales.given, [figure.scale for figure in figures_of(name, sheet)]
    told = any(figure.view.mu.key in given for figure in figures_of(name, sheet))
    return not told and all(scale.symbol and scale.across is None for scale in scales)


def step(name: str, sheet: Sheet) -> float:
    """How many times as large its figures would be at the next round scale."""
    scales = [figure.scale.value for figure in figures_of(name, sheet)]
    return min(scale / finer(scale) for scale in scales)


def hull(sheet: Sheet) -> float:
    """Share of the sheet, inside frame and strip, that the convex hull of all ink takes."""
    spots = [z for item in sheet.drawn for z in _corners(item)]
    area = shapely.convex_hull(shapely.multipoints(np.array([(z.real, z.imag) for z in spots]))).area
    return float(area / (sheet.room[0] * sheet.room[1]))


def _corners(item: object) -> tuple[complex, ...]:
    if isinstance(item, TextBox):
        box = item.rect
        return complex(box.x0, box.y0), complex(box.x1, box.y1), complex(box.x0, box.y1), complex(box.x1, box.y0)
    points: tuple[complex, ...] = getattr(item, "points", ())
    return points


@each(SHEETS)
def test_figures_whose_scale_is_free_take_three_fifths_of_their_sheet_or_meet_its_margins(name: str) -> None:
    for sheet in laid(name):
        if free(name, sheet):
            reach = max(span(sheet)) * step(name, sheet)
            assert share(sheet) >= FILLED or reach >= 1.0, [figure.extents for figure in sheet.figures]


@each((*SHEETS, "loop-wider-than-its-page"))
def test_all_pages_of_a_problem_are_turned_one_way(name: str) -> None:
    assert len({sheet.landscape for sheet in laid(name) if not sheet.plate}) <= 1


@each(SHEETS)
def test_a_plate_leaves_room_for_text_on_its_page_and_is_no_wider_than_the_text(name: str) -> None:
    """Behind a page it is lower."""
    first = True
    for sheet in laid(name):
        assert not sheet.plate or (sheet.room[0] <= 170.0 and sheet.size[1] <= 240.0)
        assert not sheet.plate or first or (sheet.room[0] <= 170.0 and sheet.size[1] <= 200.0)
        first = first and sheet.plate


def test_as_a_rule_figures_take_three_quarters_of_their_sheet_and_their_hull_three_fifths() -> None:
    made = [sheet for name in MORE for sheet in laid(name)]
    assert median(map(share, made)) >= USUAL
    assert median(map(hull, made)) >= HULL
    assert sum(share(sheet) < FILLED for sheet in made) <= 0.05 * len(made)
