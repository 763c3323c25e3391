"""A student's solution: the report of all problems, with name, sheet and code on every page."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..report.document import report_bytes
from ..solution import Solution
from ..words import Lang
from .codes import short
from .register import Register, Sheet
from .sheet.layout import Spot
from .sheet.marks import TINY, code_squares, write

QR_AT: Spot = (193.0, 3.0)
SIDE = 13.0


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
        if not sheet:  # its frame leaves no room
            code_squares(canvas, code, QR_AT, SIDE)
        canvas.restoreState()

    return report_bytes(solutions, lang=lang, fields=fields, title=register.title, stamp=stamp)
