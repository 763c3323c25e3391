"""The vector equation of a step, with the small figure that it draws."""

from __future__ import annotations

from functools import cache

from ...board.construction import EquationTable, Step
from ...drawing.inset.inset import SHARE, Outline, inset
from ...foundation.slotted import replace
from ...solution import Solution
from ...words import Lang, Words
from ..flow.blocks import Drawing
from ..flow.equation import EquationFlow
from ..plates.shown import shown
from ..plates.sketch import block_of

_TITLE = Words("本方程的矢量多边形（示意）", "The polygon of this equation (sketch)")


def equation_of(step: Step, table: EquationTable, solution: Solution, lang: Lang) -> EquationTable | EquationFlow:
    """The equation of a step: where it draws a polygon, as a block that has it."""
    outline = Outline.of(solution.construction, step)
    if outline is None:
        return table

    @cache
    def drawn(width: float, height: float) -> Drawing | None:
        scene = inset(outline, lang, width, height)
        figure = replace(outline.figure, title=_TITLE, marks=(*outline.chain.vectors, *outline.points))
        return None if scene is None else block_of(scene, SHARE, shown(figure, lang, scaled=False))

    return EquationFlow(table, lang, inset=drawn)
