"""A warm solution report of 3-9 against the same pages drawn straight on a reportlab canvas, with no layout at all.

The floor draws what was read back from the finished report: every word at its place in its own embedded face, every
line and filled shape. It solves nothing, chooses no place, breaks no line.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from reportlab.pdfgen.canvas import Canvas

from vecpoly.drawing.figure import drawn_anew
from vecpoly.problem.load import load
from vecpoly.report.document import write_report
from vecpoly.solution import Solution, solve
from vecpoly.typeset.fonts import Face
from vecpoly.typeset.fonts import load as load_face

from .timing import best

Points = tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True)
class Page:
    """What stands on a page: words (face, size, x, y, text), strokes, filled shapes."""

    words: tuple[tuple[str, float, float, float, str], ...]
    strokes: tuple[Points, ...]
    fills: tuple[Points, ...]


def run() -> str:
    """One line of the report."""
    problem = load("3-9")
    with TemporaryDirectory() as folder:
        path, raw = Path(folder) / "report.pdf", Path(folder) / "raw.pdf"
        solved = solve(problem)
        write_report([solved], path)
        pages = _read(path)
        whole, layout, floor = best(
            lambda: _write(solve(problem), path), lambda: _write(solved, path), lambda: _raw(raw, pages), runs=8
        )
    return (
        f"solution report of 3-9, warm, {len(pages)} pages: {whole * 1e3:.0f} ms = {whole / floor:.2f} × the "
        f"same pages drawn straight on a canvas ({floor * 1e3:.0f} ms); without solving {layout / floor:.2f} ×; "
        "aim ≤ 2.5"
    )


def _write(solution: Solution, path: Path) -> None:
    """The report with every figure drawn anew."""
    drawn_anew()
    write_report([solution], path)


def _read(path: Path) -> tuple[Page, ...]:
    import pdfplumber

    names = {load_face(face).face.name.decode(): face.value for face in Face}
    with pdfplumber.open(path) as document:
        return tuple(
            Page(
                tuple(
                    (
                        names.get(w["fontname"].split("+")[-1], Face.SONG.value),
                        w["size"],
                        w["x0"],
                        float(page.height) - w["bottom"],
                        w["text"],
                    )
                    for w in page.extract_words(extra_attrs=["fontname", "size"])
                ),
                tuple(tuple(line["pts"]) for line in page.lines),
                tuple(tuple(curve["pts"]) for curve in (*page.curves, *page.rects)),
            )
            for page in document.pages
        )


def _raw(path: Path, pages: tuple[Page, ...]) -> None:
    canvas = Canvas(str(path), invariant=1, initialFontName=Face.SONG.value)
    for page in pages:
        for face, size, x, y, text in page.words:
            canvas.setFont(face, size)
            canvas.drawString(x, y, text)
        for points in page.strokes:
            canvas.line(*points[0], *points[-1])
        for points in page.fills:
            path_ = canvas.beginPath()
            path_.moveTo(*points[0])
            for point in points[1:]:
                path_.lineTo(*point)
            canvas.drawPath(path_, stroke=0, fill=1)
        canvas.showPage()
    canvas.save()


if __name__ == "__main__":
    print(run())
