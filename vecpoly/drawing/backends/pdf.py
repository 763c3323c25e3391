"""Backend: a scene on a reportlab canvas as plain operators, true to a ten-thousandth of a millimetre."""

from __future__ import annotations

from functools import cache
from io import BytesIO
from typing import Any

from ...tagging.tag import Role, Tag, boxed
from ...tagging.tree import marked
from ...typeset import canvas as type_canvas
from ...typeset.box import MM
from ...words import Lang, bare
from ..scene import Fill, Item, Scene, Stroke, TextBox
from ..style import Dash, Hue


def draw_pdf(scene: Scene, canvas: Any, x_pt: float = 0.0, y_pt: float = 0.0) -> None:
    """Draw a scene with its origin at (x, y) points; 1 mm of the scene is 1 mm of the page."""
    out = ["q 1 J 1 j"]
    state: tuple[object, ...] = ()
    for item in scene:
        state = _item(item, canvas, x_pt, y_pt, state, out)
    out.append("Q")
    canvas._code.append("\n".join(out))


def _item(item: Item, canvas: Any, x: float, y: float, state: tuple[object, ...], out: list[str]) -> tuple[object, ...]:
    match item:
        case Stroke():
            wanted: tuple[object, ...] = (item.width, item.dash, item.hue)
            if wanted != state:
                out.append(_pen(item.width, item.dash, item.hue))
            out.append(f"{_path(item.points, x, y)} {'s' if item.closed else 'S'}")
            return wanted
        case Fill(points=points, hue=hue):
            out.append(f"{_rgb(hue)} rg {_path(points, x, y)} f")
        case TextBox(box=box, hue=hue):
            out.append(f"{_rgb(hue)} rg")
            canvas._code.append("\n".join(out))
            out.clear()
            type_canvas.draw(canvas, box, x + item.x * MM, y + item.y * MM)
    return state


@cache
def _pen(width: float, dash: Dash, hue: Hue) -> str:
    pattern = " ".join(f"{part * MM:.4f}" for part in dash.pattern)
    return f"{width * MM:.4f} w [{pattern}] 0 d {_rgb(hue)} RG"


@cache
def _rgb(hue: Hue) -> str:
    return "{:.3g} {:.3g} {:.3g}".format(*hue.value)


def _path(points: tuple[complex, ...], x: float, y: float) -> str:
    places = [f"{x + z.real * MM:.4f} {y + z.imag * MM:.4f}" for z in points]
    places[0] += " m"
    return " l ".join(places).replace(" m l ", " m ", 1) + (" l" if len(places) > 1 else " ")


def new_canvas(target: Any, width: float, height: float, lang: Lang = "en") -> Any:
    """A canvas of a page in mm whose only fonts are our own, the same bytes every time; its structure is kept."""
    from ...tagging.canvas import TaggedCanvas
    from ...typeset.fonts import Face, load

    load(Face.SONG)
    canvas = TaggedCanvas(
        target, font=Face.SONG.value, pagesize=(width * MM, height * MM), lang="zh-CN" if lang == "zh" else "en-GB"
    )
    canvas.setAuthor("")
    canvas.setSubject("")
    canvas.setCreator("vecpoly")
    canvas.setProducer("vecpoly")
    return canvas


def to_pdf(*pages: Scene, title: str = "vecpoly", lang: Lang = "en") -> bytes:
    """The PDF of these scenes, each a page of its own extents and a figure with this title."""
    target, first = BytesIO(), pages[0].extents
    canvas = new_canvas(target, first.width, first.height, lang)
    title = bare(title)
    canvas.setTitle(title)
    for page in pages:
        e = page.extents
        canvas.setPageSize((e.width * MM, e.height * MM))
        with marked(canvas, boxed(Tag(Role.FIGURE, alt=title), 0.0, 0.0, e.width * MM, e.height * MM)):
            draw_pdf(page, canvas, -e.x0 * MM, -e.y0 * MM)
        canvas.showPage()
    canvas.save()
    return target.getvalue()
