"""The blank sheets of a question: frames that fill the sheet and tell nothing of what is to be drawn in them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from ...board.construction import Construction, Figure, View
from ...board.paper.extent import extent
from ...board.paper.marks import Mark, Role, Segment
from ...drawing.order import reading_order
from ...drawing.sheets.sheet import Hung
from ...drawing.sheets.space import CAPTION, CLEAR, room_inside
from ...drawing.sheets.titleblock import TO_BE_DRAWN
from ...foundation.stock import Format
from ...problem.problem import Problem
from ..picture import to_scale
from .blank import framed
from .known import stands

MARGIN = 8.0  # mm that stay free between a figure and its frame
MOST = 6  # frames on a sheet
NARROWEST = 55.0  # mm: a frame with its title under it
AMPLE = 1.2  # times the room that a figure needs
Size = tuple[float, float]


@dataclass(frozen=True, slots=True)
class _Sheet:
    """Frames in rows that fill a sheet: their sizes and the places of their tops; how much larger than need be the
    tightest of them is, as far as that matters; how many times as long as wide the slimmest."""

    landscape: bool
    sizes: tuple[Size, ...]
    tops: tuple[complex, ...]
    ease: float
    slim: float


def frames(construction: Construction, problem: Problem) -> tuple[Construction, tuple[Hung, ...]]:
    """The blank sheets: for each figure a frame with what is given in it (fixed pivots, guides, racks), its pole or
    its axes, and its place.

    All frames of a row have one size, all rows of a sheet one height, and together they fill the sheet: neither the
    proportions of a polygon nor where it lies can be told from them.
    """
    on = problem.paper
    figures = construction.figures
    asked = reading_order([f for f in figures if to_scale(f) or f.aside or f.view is View.BODY])
    needs = [_needed(figure) for figure in asked]
    made = [_best(needs, landscape, on.format) for landscape in on.ways]
    found = min(made, key=_tightness)
    sizes = [size for sheet in found for size in sheet.sizes]
    drawn = tuple(_frame(f, size, stands(construction, f, problem)) for f, size in zip(asked, sizes, strict=True))
    return replace(construction, figures=drawn, hand=TO_BE_DRAWN), tuple(
        Hung(sheet.landscape, sheet.tops) for sheet in found
    )


def _tightness(sheets: Sequence[_Sheet]) -> tuple[int, int, float, float]:
    """No figure without its white is best; then the fewer the sheets the better, no tight frame, no slim one."""
    bare = sum(sheet.ease < 1 for sheet in sheets)
    eases, slims = [sheet.ease for sheet in sheets], [sheet.slim for sheet in sheets]
    return bare, len(sheets), -min(eases, default=1.0), max(slims, default=1.0)


def _needed(figure: Figure) -> Size:
    """The room that a figure takes with the white that it should have round it."""
    wide, high = extent(figure.marks)
    return wide + 2 * MARGIN, high + 2 * MARGIN


def _best(needs: Sequence[Size], landscape: bool, of: Format) -> list[_Sheet]:
    """The fewest sheets, in order, with the most ease among these."""
    best: list[list[_Sheet]] = [[]]
    for end in range(1, len(needs) + 1):
        options = [
            [*best[start], sheet]
            for start in range(max(0, end - MOST), end)
            if (sheet := _sheet(needs[start:end], landscape, of)) is not None
        ]
        best.append(min(options, key=_tightness))
    return best[-1]


def _sheet(needs: Sequence[Size], landscape: bool, of: Format) -> _Sheet | None:
    """The rows in which these frames are least tight; None where they don't fit. One figure has a sheet to itself
    however little white that leaves round it."""
    across = int(room_inside(landscape, of)[0] / (NARROWEST + CLEAR))
    made = (_in_rows(needs, rows, landscape, of) for rows in _rows(len(needs)) if max(rows) <= across)
    fitting = (one for one in made if one.ease >= 1 or len(needs) == 1)
    return min(fitting, key=lambda one: _tightness([one]), default=None)


def _rows(count: int) -> Iterator[tuple[int, ...]]:
    """Every way to put so many frames in rows."""
    if not count:
        yield ()
    for first in range(1, count + 1):
        yield from ((first, *rest) for rest in _rows(count - first))


def _in_rows(needs: Sequence[Size], rows: tuple[int, ...], landscape: bool, of: Format) -> _Sheet:
    width, height = room_inside(landscape, of)
    down = (height - CLEAR) / len(rows)
    sizes, tops = list[Size](), list[complex]()
    for row, across in enumerate(rows):
        step = (width - CLEAR) / across
        for column in range(across):
            sizes.append((step - CLEAR, down - CLEAR - CAPTION))
            tops.append(complex(CLEAR / 2 + (column + 0.5) * step, height - CLEAR - row * down))
    ease = min(min(size[i] / need[i] for i in (0, 1)) for size, need in zip(sizes, needs, strict=True))
    slim = max(max(wide / high, high / wide) for wide, high in sizes)
    return _Sheet(landscape, tuple(sizes), tuple(tops), min(ease, AMPLE), slim)


def _frame(figure: Figure, size: Size, known: Sequence[Mark]) -> Figure:
    """The figure as a blank frame of this size."""
    (low, high), shown = framed(figure, size, known)
    box = (low, complex(high.real, low.imag), high, complex(low.real, high.imag))
    border = tuple(Segment(a=a, b=b, role=Role.DIRECTION, step=1) for a, b in zip(box, box[1:] + box[:1], strict=True))
    return replace(figure, marks=border + shown)
