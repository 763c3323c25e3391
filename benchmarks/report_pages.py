"""A warm solution report of 3-9 against the same pages drawn straight on a reportlab canvas, with no layout at all.

The floor has as many pages, the same strokes and fills of the same drawings, and on every page of text 30 lines of Chinese
in the same embedded face; it chooses no place, breaks no line, solves nothing.
"""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

from reportlab.pdfgen.canvas import Canvas

from vecpoly.drawing.figure import draw_figure
from vecpoly.drawing.scene import Fill, Stroke
from vecpoly.problem.load import load
from vecpoly.report.document import write_report
from vecpoly.solution import solve
from vecpoly.typeset.box import MM
from vecpoly.typeset.fonts import Face
from vecpoly.typeset.fonts import load as load_face

from .timing import best

LINE = "将机构位置图按比例画出，列出矢量方程并作速度多边形与加速度多边形，量取图上长度乘以比例尺。"


def run() -> str:
    """One line of the report."""
    import pdfplumber

    problem = load("3-9")
    with TemporaryDirectory() as folder:
        path, raw = Path(folder) / "report.pdf", Path(folder) / "raw.pdf"
        write_report([solve(problem)], path)
        with pdfplumber.open(path) as document:
            pages = len(document.pages)
        scenes = [draw_figure(f) for f in solve(problem).construction.figures]
        items = [item for scene in scenes for item in scene]
        solved = solve(problem)
        whole, layout, floor = best(lambda: write_report([solve(problem)], path), lambda: write_report([solved], path),
                                    lambda: _raw(raw, pages, items), runs=8)
    return (f"solution report of 3-9, warm, {pages} pages: {whole * 1e3:.0f} ms = {whole / floor:.2f} × the same pages drawn straight on a "
            f"canvas ({floor * 1e3:.0f} ms); without solving {layout / floor:.2f} ×; aim ≤ 4")


def _raw(path: Path, pages: int, items: list[object]) -> None:
    load_face(Face.SONG)
    canvas = Canvas(str(path), invariant=1, initialFontName=Face.SONG.value)
    for page in range(pages):
        canvas.setFont(Face.SONG.value, 10.5)
        for row in range(30):
            canvas.drawString(60, 770 - 22 * row, LINE[: 40])
        if page == pages - 1:
            _strokes(canvas, items)
        canvas.showPage()
    canvas.save()


def _strokes(canvas: Canvas, items: list[object]) -> None:
    for item in items:
        if isinstance(item, (Stroke, Fill)):
            path = canvas.beginPath()
            path.moveTo(item.points[0].real * MM, item.points[0].imag * MM)
            for z in item.points[1:]:
                path.lineTo(z.real * MM, z.imag * MM)
            canvas.drawPath(path, stroke=isinstance(item, Stroke), fill=isinstance(item, Fill))
