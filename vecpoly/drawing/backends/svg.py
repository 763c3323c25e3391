"""Backend: a scene as SVG in millimetres; the items of a step are grouped under data-step, layer by layer."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import groupby
from typing import assert_never

from ...typeset.outlines import outlined_group
from ...typeset.svg import svg_group
from ...words import bare
from ..scene import Fill, Item, Scene, Stroke, TextBox


def to_svg(scene: Scene, title: str = "", *, desc: str = "", outlined: bool = False) -> str:
    """The scene as a document of its own: its extents are the view box. title and desc: what it is and what it shows,
    for whoever cannot see it. outlined: letters as outlines, which need no font."""
    from xml.sax.saxutils import escape

    e = scene.extents
    size = f'width="{e.width:.3f}mm" height="{e.height:.3f}mm" viewBox="0 0 {e.width:.3f} {e.height:.3f}"'
    head = f'<svg xmlns="http://www.w3.org/2000/svg" {size} fill="none" stroke-linecap="round" stroke-linejoin="round">'
    told = "".join(f"<{tag}>{escape(text)}</{tag}>" for tag, text in (("title", bare(title)), ("desc", desc)) if text)
    return f"{head}{told}{''.join(_groups(scene, -e.x0, e.y1, outlined))}</svg>"


def _groups(scene: Scene, dx: float, top: float, outlined: bool) -> Iterable[str]:
    ordered = sorted(scene, key=lambda item: (item.layer, item.step))
    for (layer, step), items in groupby(ordered, key=lambda item: (item.layer, item.step)):
        body = "".join(_item(item, dx, top, outlined) for item in items)
        yield f'<g data-step="{step}" data-layer="{layer.name.lower()}">{body}</g>'


def _item(item: Item, dx: float, top: float, outlined: bool) -> str:
    match item:
        case Stroke(points=points, width=width, dash=dash, hue=hue):
            pattern = f' stroke-dasharray="{" ".join(map(str, dash.pattern))}"' if dash.pattern else ""
            end = "Z" if item.closed else ""
            return f'<path d="{_path(points, dx, top)}{end}" stroke="{hue.hex}" stroke-width="{width:.3g}"{pattern}/>'
        case Fill(points=points, hue=hue):
            return f'<path d="{_path(points, dx, top)}Z" fill="{hue.hex}"/>'
        case TextBox(box=box, hue=hue):
            return (outlined_group if outlined else svg_group)(box, item.x + dx, top - item.y, hue.hex)
    assert_never(item)


def _path(points: tuple[complex, ...], dx: float, top: float) -> str:
    return "M" + "L".join(f"{z.real + dx:.4f} {top - z.imag:.4f}" for z in points)
