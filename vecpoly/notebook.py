"""Pictures for Jupyter: a problem shows its mechanism or device, with what acts on it and nothing solved yet."""

from __future__ import annotations

from .drawing.figure import draw_figure
from .drawing.svg import to_svg
from .problem.problem import Problem
from .report.picture import picture
from .solution import solve

SIZE = (140.0, 100.0)  # mm


def problem_svg(problem: Problem) -> str:
    """The sketch of a problem as SVG; where it has none, the first figure of its solution."""
    drawn = solve(problem, by="exact", repeats=0).construction
    return to_svg(draw_figure(picture(problem, drawn, *SIZE) or drawn.figures[0], caption=False), problem.title.zh)
