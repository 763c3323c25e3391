"""The question sheet as a PDF."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from typing import Any

from ...algebra.quantity import number
from ...board.construction import Figure
from ...drawing.backends.pdf import new_canvas
from ...report.flow.blocks import spoken
from ...tagging.tag import Role, Tag
from ...tagging.tree import artifact, marked
from ...words import Lang, Words, bare
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
    layout, target = layout_of(pages).hash, BytesIO()
    canvas = new_canvas(target, WIDTH, HEIGHT, lang)
    canvas.setTitle(f"{bare(title)} {sheet}")
    for one in pages:
        code = page_code(assignment, sheet, one.page.number, layout)
        with artifact(canvas):
            furniture(canvas, one.page.tags, code, lang)
            write(canvas, _PAGE.of(lang).format(one.page.number, len(pages)), (151.0, 283.5), TINY)
        _head(canvas, title, student, lang, first=one is pages[0])
        for placed in one.text:
            placed.draw(canvas)
        if one.page.frame is not None and one.figure is not None:
            with marked(canvas, Tag(Role.FIGURE, alt=_frame_said(one.figure, lang))):
                draw_frame(canvas, one.page.frame, one.figure.title.of(lang), _scale(one.figure), lang)
        for blank in one.page.blanks:
            with marked(canvas, Tag(Role.P)):
                draw_blank(canvas, blank, lang)
        canvas.showPage()
    canvas.save()
    return target.getvalue()


def _frame_said(figure: Figure, lang: Lang) -> str:
    """What is said for an empty frame."""
    said = Words("空白图框：{}，比例尺 {}", "Empty frame for: {}, scale {}").of(lang)
    return said.format(spoken(figure.title.of(lang)), spoken(_scale(figure)))


def _head(canvas: Any, title: str, student: Student, lang: Lang, *, first: bool) -> None:
    """Title and name; on later pages they have been read."""
    canvas.setFillColorRGB(0, 0, 0)
    with marked(canvas, Tag(Role.H1)) if first else artifact(canvas):
        write(canvas, title, (LEFT, 281.0), 4.2, bold=True)
    with marked(canvas, Tag(Role.P)) if first else artifact(canvas):
        _whose(canvas, student, lang)


def _whose(canvas: Any, student: Student, lang: Lang) -> None:
    parts = (("姓名", "Name", student.name), ("学号", "No.", student.number), ("班级", "Class", student.team))
    for i, (zh, en, value) in enumerate(parts):
        label = Words(f"{zh}：", f"{en}: ").of(lang)
        write(canvas, f"{label}{value or '________'}", (LEFT, 274.5 - 5.0 * i), SMALL)


def _scale(figure: Figure) -> str:
    both = (figure.scale, figure.scale.across)
    return ", ".join(f"${one.symbol}$ = {number(one.value)} {one.per_mm}" for one in both if one is not None)
