"""Backend: a scene as a matplotlib figure of its true size (matplotlib is imported when asked for, never before)."""

from __future__ import annotations

from typing import Any

from ...typeset.box import MM, Glyphs, Rule
from ...typeset.fonts import MISSING, Face, missing_text, path
from ..scene import Fill, Scene, Stroke, TextBox


def to_mpl(scene: Scene) -> Any:
    """A matplotlib Figure: axes fill it, one data unit is 1 mm."""
    from matplotlib.figure import Figure as MplFigure

    e = scene.extents
    figure = MplFigure(figsize=(e.width / 25.4, e.height / 25.4))
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set(xlim=(e.x0, e.x1), ylim=(e.y0, e.y1))
    for order, item in enumerate(scene):
        match item:
            case Stroke():
                _stroke(axes, item, order)
            case Fill(points=points, hue=hue):
                axes.fill([z.real for z in points], [z.imag for z in points], color=hue.value, lw=0, zorder=order)
            case TextBox():
                _text(axes, item, order)
    return figure


def _stroke(axes: Any, item: Stroke, order: int) -> None:
    points = item.points + item.points[:1] if item.closed else item.points
    (line,) = axes.plot(
        [z.real for z in points],
        [z.imag for z in points],
        color=item.hue.value,
        zorder=order,
        lw=item.width * MM,
        solid_capstyle="round",
        solid_joinstyle="round",
    )
    if item.dash.pattern:  # matplotlib counts dashes in line widths
        line.set_linestyle((0, tuple(part / item.width for part in item.dash.pattern)))


def _text(axes: Any, item: TextBox, order: int) -> None:
    from matplotlib.font_manager import FontProperties
    from matplotlib.patches import Rectangle

    for part in item.box.items:
        match part:
            case Rule(x, y, width, height):
                axes.add_patch(
                    Rectangle((item.x + x, item.y + y), width, height, fc=item.hue.value, lw=0, zorder=order)
                )
            case Glyphs(font, size, x, y, text):
                lost = font == MISSING
                shown = "".join(map(missing_text, text)) if lost else text
                face = FontProperties(
                    fname=str(path(Face.STIX if lost else Face(font))), size=size / 2 if lost else size
                )
                axes.text(
                    item.x + x,
                    item.y + y,
                    shown,
                    fontproperties=face,
                    color=item.hue.value,
                    ha="left",
                    va="baseline",
                    zorder=order,
                    parse_math=False,
                )
