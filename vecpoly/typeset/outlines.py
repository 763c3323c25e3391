"""Set type as SVG outlines: it looks alike in every viewer, with no font of the reader's machine."""

from __future__ import annotations

from functools import cache
from typing import Any

from .box import MM, Box, Item, Rule
from .fonts import MISSING, Face, glyph, missing_text, path


def outlined_group(box: Box, x_mm: float, y_mm: float, fill: str = "black") -> str:
    """The box as an SVG group of filled outlines in millimetres, its origin at (x, y), y downwards."""
    return f'<g fill="{fill}">{"".join(_element(item, x_mm, y_mm) for item in box.items)}</g>'


def _element(item: Item, x: float, y: float) -> str:
    if isinstance(item, Rule):
        corner = f'x="{x + item.x:.3f}" y="{y - item.y - item.height:.3f}"'
        return f'<rect {corner} width="{item.width:.3f}" height="{item.height:.3f}"/>'
    lost = item.font == MISSING
    face, text = (Face.STIX, "".join(map(missing_text, item.text))) if lost else (Face(item.font), item.text)
    em = item.size / MM / (2 if lost else 1)
    strokes, at = [], 0.0
    for char in text:
        if outline := _outline(face, char):
            strokes.append(
                f'<path transform="translate({x + item.x + at * em:.3f} {y - item.y:.3f}) '
                f'scale({em / 1000:.6f})" d="{outline}"/>'
            )
        at += glyph(char, face).width
    return "".join(strokes)


@cache
def _outline(face: Face, char: str) -> str:
    """The outline of one character, 1000 units an em, y downwards; empty for a blank."""
    from fontTools.pens.svgPathPen import SVGPathPen
    from fontTools.pens.transformPen import TransformPen

    font = _opened(face)
    shapes, name = font.getGlyphSet(), font.getBestCmap().get(ord(char))
    pen = SVGPathPen(shapes, ntos=lambda number: f"{number:.0f}")
    if name is not None:
        unit = 1000 / font["head"].unitsPerEm
        shapes[name].draw(TransformPen(pen, (unit, 0, 0, -unit, 0, 0)))
    return str(pen.getCommands())


@cache
def _opened(face: Face) -> Any:
    """The face as fontTools reads it."""
    from fontTools.ttLib import TTFont

    return TTFont(path(face), lazy=True)
