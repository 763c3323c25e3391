"""The sheets of every problem of the library, laid out once, and how much of each its figures take."""

from __future__ import annotations

from functools import cache, lru_cache

from tests.drawn_library import drafted
from vecpoly.drawing import figure as figures
from vecpoly.drawing.figure import Drawing
from vecpoly.drawing.sheets.sheet import Sheet, sheets
from vecpoly.words import Lang

# the house keeps the drawings of one problem; here labels and sheets of the whole library are looked at in turn
KEPT = 1000
figures.drawing = lru_cache(maxsize=KEPT)(figures.drawing.__wrapped__)


@cache
def lettered(name: str) -> tuple[Drawing, ...]:
    """Every figure of this problem with its labels, drawn as its sheets draw it; none where no method draws it."""
    solution = drafted(name)
    asked = solution.construction.figures if solution else ()
    return tuple(figures.drawing(one, lang="zh", caption=True, frame=None) for one in asked)


@cache
def laid(name: str, lang: Lang = "zh", bands: bool = False) -> tuple[Sheet, ...]:
    """The sheets of this problem as its report has them; bands: as they are for results."""
    solution = drafted(name)
    assert solution is not None
    problem = solution.problem
    return sheets(solution.construction, lang=lang, title=problem.title, on=problem.paper, plates=True, bands=bands)


def span(sheet: Sheet) -> tuple[float, float]:
    """How much of the sheet's width and of its height the box about all ink of its figures takes."""
    boxes = [figure.extents for figure in sheet.figures]
    wide = max(box.x1 for box in boxes) - min(box.x0 for box in boxes)
    high = max(box.y1 for box in boxes) - min(box.y0 for box in boxes)
    return wide / sheet.room[0], high / sheet.room[1]


def share(sheet: Sheet) -> float:
    """What that box takes of the sheet's area inside frame and strip."""
    wide, high = span(sheet)
    return wide * high
