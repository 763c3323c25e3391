"""Letters placed on a figure, and eight figures placed on pages: CPU milliseconds."""

from __future__ import annotations

from collections.abc import Sequence

from vecpoly.board.construction import Figure
from vecpoly.drawing.figure import draw_figure, drawing, drawn_anew
from vecpoly.drawing.sheets.paging import Drawn, paged, reading_order
from vecpoly.problem.load import load
from vecpoly.solution import solve

from .timing import best


def run() -> str:
    """One line of the report."""
    figures = solve(load("4-3a"), repeats=0).construction.figures
    drawn = tuple(Drawn(f.view, f.name, draw_figure(f)) for f in reading_order(figures))
    lettered, placed = best(lambda: _lettered(figures), lambda: paged(drawn), runs=5)
    return (
        f"lettering of 4-3a: {lettered / len(figures) * 1e3:.0f} ms a figure (aim < 150), "
        f"its {len(figures)} figures placed on pages in {placed * 1e3:.0f} ms (aim < 200)"
    )


def _lettered(figures: Sequence[Figure]) -> None:
    """All of them, and no place that was found before."""
    drawn_anew()
    for figure in figures:
        drawing(figure)


if __name__ == "__main__":
    print(run())
