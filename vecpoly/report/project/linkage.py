"""A chapter that finds a linkage: the construction, the solutions, the lengths as they are taken."""

from __future__ import annotations

from typing import Any

from ...project.part import Part
from ...words import Words
from ..content import cautions, conclusions, sections, statement
from ..course.numbering import SMALL
from ..flow.table import DataTable
from ..tables import readings_table
from .binder import Binder

_TAKEN = {"zh": ["尺寸", "量得 /mm", "取用 /mm"], "en": ["Length", "Read, mm", "Taken, mm"]}


def chapter(part: Part, binder: Binder) -> dict[str, Any]:
    """Given, asked, steps, results with their check."""
    press, lang = binder.press, binder.lang
    said = statement(part.solution, lang)
    steps = sections(part.solution, lang, press.objects)
    title = Words("量取结果与精确值", "Readings and exact values")
    return {
        **said,
        "sections": steps,
        "sheets": binder.numbers(part),
        "table": captioned(readings_table(part.solution, lang), title, binder),
        "conclusions": conclusions(part.solution, lang),
        "cautions": cautions(part.solution, lang),
        "taken": _taken(part, binder),
    }


def captioned(made: DataTable, title: Words, binder: Binder) -> str:
    """A table with its number."""
    return binder.press.table(title, made.header, made.rows, made.align, style=SMALL)


def _taken(part: Part, binder: Binder) -> str:
    """The lengths as read and as the mechanism that follows has them."""
    user = next((one for one in binder.project.parts if one.base is part), None)
    if user is None:
        return ""
    design = part.problem.design
    valid = [one for one in part.solution.construction.candidates if one.reason is None]
    read = valid[design.take - 1].values
    rows = [
        (f"${named.symbol}$", _mm(read[named.key]), _mm(user.taken[named.key]))
        for named in design.quantities()
        if named.key in read and design.is_length(named.key)
    ]
    title = Words("量得的尺寸与取用的尺寸", "Lengths as read and as taken")
    return binder.press.table(title, _TAKEN[binder.lang], rows, "lrr")


def _mm(value: float) -> str:
    return f"{value:.1f}".replace("-", "−")
