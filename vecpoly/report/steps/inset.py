"""The vector equation of a step, with the small figure that it draws where that finds a place beside it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from ...algebra.formula import Node
from ...board.construction import EquationTable, Step
from ...drawing.inset.inset import SHARE, Outline, inset
from ...foundation.slotted import replace
from ...solution import Solution
from ...words import Lang, Words
from ..flow.base import Block
from ..flow.blocks import Drawing
from ..flow.equation import EquationFlow, Inset
from ..flow.formula import Formula, in_columns
from ..flow.results.illustrated import Beside, illustrated
from ..plates.shown import shown
from ..plates.sketch import block_of

_TITLE = Words("本方程的矢量多边形（示意）", "The polygon of this equation (sketch)")


def equation_of(
    step: Step, lines: Sequence[Node | Block], solution: Solution, lang: Lang
) -> EquationTable | EquationFlow | None:
    """The equation of a step, as a block where its figure stands beside it or beside the lines worked out under it."""
    outline = Outline.of(solution.construction, step)
    if step.equation is None or outline is None:
        return step.equation
    flow = EquationFlow(step.equation, lang, inset=_drawn(outline, lang))
    blocks = [flow, *(one if isinstance(one, Block) else Formula(one) for one in lines)]
    in_columns(blocks)
    return flow if any(isinstance(one, Beside) for one in illustrated(blocks)) else step.equation


def _drawn(outline: Outline, lang: Lang) -> Inset:
    """Draws the figure for a place of so many mm, once."""

    @cache
    def drawn(width: float, height: float) -> Drawing | None:
        scene = inset(outline, lang, width, height)
        figure = replace(outline.figure, title=_TITLE, marks=(*outline.chain.vectors, *outline.points))
        return None if scene is None else block_of(scene, SHARE, shown(figure, lang, scaled=False))

    return drawn
