"""The blank sheets of a question: frames that fill the sheet and tell nothing of what is to be drawn in them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ...board.construction import Construction, Figure, View
from ...board.paper.extent import extent
from ...board.paper.marks import Mark, Role, Segment
from ...drawing.order import begun_in, reading_order
from ...drawing.sheets.lettering import title_width
from ...drawing.sheets.sheet import Hung
from ...drawing.sheets.titleblock import TO_BE_DRAWN
from ...foundation.stock import Format
from ...problem.problem import Problem
from ..picture import to_scale
from .blank import framed
from .equations import band, head, numbers
from .grid import Grid, Need, Size, grid, tightness
from .known import stands

MARGIN = 8.0  # mm that stay free between a figure and its frame
MOST = 6  # frames on a sheet


def frames(construction: Construction, problem: Problem) -> tuple[Construction, tuple[Hung, ...]]:
    """The blank sheets: for each figure a frame with what is given in it (fixed pivots, guides, racks), its pole or
    its axes, the numbers of its vector equations, and its place.

    Frames are of a few fixed sizes and together fill the sheet: a large drawing has a large frame, but neither the
    proportions of a polygon nor where it lies can be told from it.
    """
    on = problem.paper
    figures = construction.figures
    asked = as_solved(reading_order([f for f in figures if to_scale(f) or f.aside or f.view is View.BODY]))
    told = [numbers(construction, figure) for figure in asked]
    needs = [_needed(figure, band(some)) for figure, some in zip(asked, told, strict=True)]
    found = min((_laid(needs, way, on.format) for way in on.ways), key=tightness)
    sizes = [size for sheet in found for size in sheet.sizes]
    drawn = tuple(
        _frame(figure, size, stands(construction, figure, problem), some)
        for figure, size, some in zip(asked, sizes, told, strict=True)
    )
    return replace(construction, figures=drawn, hand=TO_BE_DRAWN), tuple(
        Hung(sheet.landscape, sheet.tops) for sheet in found
    )


def as_solved(figures: Sequence[Figure]) -> list[Figure]:
    """The figures in the order in which they are begun; links that are set free, with their polygons, stay together."""
    bodies = {figure.name for figure in figures if figure.view is View.BODY}
    free = [f for f in figures if f.view is View.BODY or (f.view.beside is View.BODY and f.name in bodies)]
    together = min(map(begun_in, free), default=0)
    return sorted(figures, key=lambda figure: together if figure in free else begun_in(figure))


def _laid(needs: Sequence[Need], landscape: bool, of: Format) -> list[Grid]:
    """The fewest sheets that lie this way, in order, with the most ease among these."""
    best: list[list[Grid]] = [[]]
    for end in range(1, len(needs) + 1):
        options = [
            [*best[start], sheet]
            for start in range(max(0, end - MOST), end)
            if (sheet := grid(needs[start:end], landscape, of)) is not None
        ]
        best.append(min(options, key=tightness))
    return best[-1]


def _needed(figure: Figure, told: float) -> Need:
    """The room of a figure with the white that it should have round it, words over it and its title below it."""
    wide, high = extent(figure.marks)
    return Need(max(wide + 2 * MARGIN, title_width(figure)), high + 2 * MARGIN + told, figure.view.across is not None)


def _frame(figure: Figure, size: Size, known: Sequence[Mark], equations: Sequence[int]) -> Figure:
    """The figure as a blank frame of this size."""
    lined = band(equations)
    (low, high), shown = framed(figure, (size[0], size[1] - lined), known)
    high += 1j * lined
    box = (low, complex(high.real, low.imag), high, complex(low.real, high.imag))
    border = tuple(Segment(a=a, b=b, role=Role.DIRECTION, step=1) for a, b in zip(box, box[1:] + box[:1], strict=True))
    return replace(figure, marks=border + shown + tuple(head(equations, box[3])))
