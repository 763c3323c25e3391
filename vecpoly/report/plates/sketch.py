"""A figure that stands in the text: the sketch of a mechanism, a block diagram."""

from __future__ import annotations

from typing import Any

from ...drawing.backends.pdf import draw_pdf
from ...drawing.figure import draw_figure
from ...solution import Solution
from ...typeset.box import MM
from ...words import Lang
from ..flow.blocks import Drawing
from .shown import shown


def sketch_of(figure: Any, solution: Solution, lang: Lang, *, sketch: bool = False) -> Drawing:
    """A figure as a block of the text; sketch: one that is not to scale."""
    scene = draw_figure(figure, lang=lang, caption=False)
    e = scene.extents
    return Drawing(
        e.width,
        e.height,
        lambda canvas, x, y: draw_pdf(scene, canvas, x - e.x0 * MM, y - e.y0 * MM),
        shown(figure, lang, scaled=not sketch),
        figure.title.of(lang),
        sketch=sketch,
    )
