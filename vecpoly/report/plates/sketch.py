"""A figure that stands in the text: the sketch of a mechanism, a block diagram."""

from __future__ import annotations

from typing import Any

from ...drawing.backends.pdf import draw_pdf
from ...drawing.figure import draw_figure
from ...drawing.scene import Scene
from ...solution import Solution
from ...typeset.box import MM
from ...words import Lang
from ..flow.blocks import Drawing
from .shown import shown

LETTERED = 0.85  # of its size on a sheet is a sketch in the text: so its letters are as large as those of the text


def sketch_of(figure: Any, solution: Solution, lang: Lang, *, sketch: bool = False) -> Drawing:
    """A figure as a block of the text; sketch: one that is not to scale."""
    scene = draw_figure(figure, lang=lang, caption=False)
    said = shown(figure, lang, scaled=not sketch)
    return block_of(scene, LETTERED if sketch else 1.0, said, figure.title.of(lang), sketch=sketch)


def block_of(scene: Scene, share: float, said: str, caption: str = "", *, sketch: bool = False) -> Drawing:
    """A scene as a block of the text, so many times as large; said: in words."""
    e = scene.extents

    def draw(canvas: Any, x: float, y: float) -> None:
        canvas.scale(share, share)
        draw_pdf(scene, canvas, x / share - e.x0 * MM, y / share - e.y0 * MM)

    return Drawing(share * e.width, share * e.height, draw, said, caption, sketch=sketch)
