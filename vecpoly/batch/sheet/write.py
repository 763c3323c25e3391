"""The question sheet as a PDF."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from typing import Any

from ...algebra.quantity import number
from ...board.construction import Figure
from ...drawing.backends.pdf import new_canvas
from ...words import Lang, Words
from ..codes import page_code
from ..student import Student
from .blanks import draw_blank, draw_frame
from .compose import Composed, layout_of
from .layout import HEIGHT, LEFT, WIDTH
from .marks import SMALL, TINY, furniture, write

_PAGE = Words("第 {} 页，共 {} 页", "page {} of {}")


def sheet_bytes(
    pages: Sequence[Composed], *, title: str, assignment: str, sheet: str, student: Student, lang: Lang
) -> bytes:
    """The PDF of these pages; only its title line has the student's name."""
    layout, target = layout_of(pages), BytesIO()
    canvas = new_canvas(target, WIDTH, HEIGHT)
    canvas.setTitle(f"{title} {sheet}")
    for one in pages:
        code = page_code(assignment, sheet, one.page.number, layout.hash)
        furniture(canvas, one.page.tags, code, lang)
        _head(canvas, title, student, lang)
        write(canvas, _PAGE.of(lang).format(one.page.number, len(pages)), (151.0, 283.5), TINY)
        for placed in one.text:
            placed.draw(canvas)
        if one.page.frame is not None and one.figure is not None:
            draw_frame(canvas, one.page.frame, one.figure.title.of(lang), _scale(one.figure), lang)
        for blank in one.page.blanks:
            draw_blank(canvas, blank)
        canvas.showPage()
    canvas.save()
    return target.getvalue()


def _head(canvas: Any, title: str, student: Student, lang: Lang) -> None:
    canvas.setFillColorRGB(0, 0, 0)
    write(canvas, title, (LEFT, 281.0), 4.2, bold=True)
    parts = (("姓名", "Name", student.name), ("学号", "No.", student.number), ("班级", "Class", student.team))
    for i, (zh, en, value) in enumerate(parts):
        label = Words(f"{zh}：", f"{en}: ").of(lang)
        write(canvas, f"{label}{value or '________'}", (LEFT, 274.5 - 5.0 * i), SMALL)


def _scale(figure: Figure) -> str:
    both = (figure.scale, figure.scale.across)
    return ", ".join(f"${one.symbol}$ = {number(one.value)} {one.per_mm}" for one in both if one is not None)
