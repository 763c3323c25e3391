"""Pictures for Jupyter: a problem shows its kinematic diagram, to scale, with nothing solved yet."""

from __future__ import annotations

from .board.construction import View
from .drawing.figure import draw_figure
from .drawing.svg import to_svg
from .problem.problem import Problem
from .report.picture import sketch
from .solution import solve

SIZE = (140.0, 100.0)  # mm


def problem_svg(problem: Problem) -> str:
    """The mechanism of a problem as SVG."""
    drawn = solve(problem, by="exact", repeats=0).construction
    assert drawn.figure(View.MECHANISM) is not None
    return to_svg(draw_figure(sketch(drawn, *SIZE), caption=False), problem.title.zh)
