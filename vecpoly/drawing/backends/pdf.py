"""Backend: a scene on a reportlab canvas as plain operators, true to a ten-thousandth of a millimetre."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path
from typing import Any

from ...typeset import canvas as type_canvas
from ...typeset.box import MM
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


def _pen(width: float, dash: Dash, hue: Hue) -> str:
    pattern = " ".join(f"{part * MM:.4f}" for part in dash.pattern)
    return f"{width * MM:.4f} w [{pattern}] 0 d {_rgb(hue)} RG"


def _rgb(hue: Hue) -> str:
    return "{:.3g} {:.3g} {:.3g}".format(*hue.value)


def _path(points: tuple[complex, ...], x: float, y: float) -> str:
    places = [f"{x + z.real * MM:.4f} {y + z.imag * MM:.4f}" for z in points]
    return f"{places[0]} m " + " ".join(f"{place} l" for place in places[1:])


def new_canvas(target: Any, width: float, height: float) -> Any:
    """A canvas of a page in mm whose only fonts are our own, the same bytes every time."""
    from reportlab.pdfgen.canvas import Canvas

    from ...typeset.fonts import Face, load

    load(Face.SONG)
    canvas = Canvas(
        target,
        pagesize=(width * MM, height * MM),
        invariant=1,
        initialFontName=Face.SONG.value,
        pageCompression=0,
        pdfVersion=(1, 7),
    )
    compress(canvas)
    return canvas


def compress(canvas: Any) -> None:
    """Compress every stream of this canvas, without Base 85 around it:
    as reportlab's global switch does, but for one document."""
    from reportlab.pdfbase.pdfdoc import PDFZCompress

    canvas._doc.defaultStreamFilters = [PDFZCompress]


def pages_to_pdf(pages: tuple[Scene, ...], target: Any) -> None:
    """A PDF of scenes, each a page of its own extents; `target`: a path or a binary file."""
    first = pages[0].extents
    canvas = new_canvas(str(target) if isinstance(target, Path) else target, first.width, first.height)
    for page in pages:
        e = page.extents
        canvas.setPageSize((e.width * MM, e.height * MM))
        draw_pdf(page, canvas, -e.x0 * MM, -e.y0 * MM)
        canvas.showPage()
    canvas.save()


def to_pdf(*pages: Scene) -> bytes:
    """The PDF of these pages in memory."""
    target = BytesIO()
    pages_to_pdf(pages, target)
    return target.getvalue()
