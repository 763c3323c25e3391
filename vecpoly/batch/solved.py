"""A student's solution: the report of all problems, with name, sheet and code on every page."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..drawing.sheets.boxes.titleblock import BAR_CELL
from ..drawing.sheets.space import FRAME, STRIP
from ..foundation.short import short
from ..report.document import report_bytes
from ..solution import Solution
from ..typeset.box import MM
from ..words import Lang
from .register import Register, Sheet
from .sheet.layout import Spot
from .sheet.marks import TINY, code_squares, write

QR_AT: Spot = (193.0, 3.0)
SIDE = 13.0
SMALLER, WHITE = 10.5, 13.0  # mm: the squares in the title strip of a drawing sheet, and the white about them


def _in_the_strip(canvas: Any, code: str) -> None:
    """In the title strip, beside the scale's bar: of a printed name and number nothing need be written there."""
    width = canvas._pagesize[0] / MM
    x, y = width - FRAME - BAR_CELL - WHITE - 0.4, FRAME + (STRIP - WHITE) / 2
    canvas.setFillColorRGB(1, 1, 1)
    canvas.rect(x * MM, y * MM, WHITE * MM, WHITE * MM, stroke=0, fill=1)
    quiet = (WHITE - SMALLER) / 2
    code_squares(canvas, code, (x + quiet, y + quiet), SMALLER)


def solution_bytes(solutions: Sequence[Solution], register: Register, whose: Sheet) -> bytes:
    """The PDF of a student's solutions."""
    lang: Lang = "zh" if register.lang == "zh" else "en"
    labels = ("班级", "姓名", "学号") if lang == "zh" else ("Class", "Name", "Student no.")
    fields = dict(zip(labels, (whose.student.team, whose.student.name, whose.student.number), strict=True))
    code = f"VP1-{short(register.assignment, 4)}-{whose.sheet}-S"
    said = f"{whose.student.name} {whose.student.number}  {code}"

    def stamp(canvas: Any, sheet: bool) -> None:
        canvas.saveState()
        canvas.setFillColorRGB(0, 0, 0)
        write(canvas, said, (20.0, 4.5), TINY)
        if sheet:
            _in_the_strip(canvas, code)
        else:
            code_squares(canvas, code, QR_AT, SIDE)
        canvas.restoreState()

    return report_bytes(solutions, lang=lang, fields=fields, title=register.title, stamp=stamp)
