"""A chapter that finds a linkage: the construction, the solutions, the lengths as they are taken."""

from __future__ import annotations

from typing import Any

from ...found import taken
from ...printed.digits import drawn_number
from ...project.part import Part
from ...words import Words
from ..answers.box import answer_box, explained_by
from ..content import cautions, conclusions, statement
from ..steps.sections import sections
from .binder import Binder

_TAKEN = {"zh": ["尺寸", "量得 /mm", "取用 /mm"], "en": ["Length", "Read, mm", "Taken, mm"]}


def chapter(part: Part, binder: Binder) -> dict[str, Any]:
    """Given, asked, steps, the answer with its check."""
    return {**told(part, binder), "sheets": binder.numbers(part), "taken": _taken(part, binder)}


def told(part: Part, binder: Binder) -> dict[str, Any]:
    """What a linkage that is found and a device have in common: given, asked, steps, the answer."""
    press, lang, solution = binder.press, binder.lang, part.solution
    explained = explained_by(press.objects.named.values())
    answer = answer_box(solution, lang, conclusions(solution, lang), explained=explained)
    return {
        **statement(solution, lang),
        "sections": sections(solution, lang, press.objects),
        "answer": press.objects.add("ans", answer),
        "cautions": cautions(solution, lang),
    }


def _taken(part: Part, binder: Binder) -> str:
    """The lengths as read and as the mechanism that follows has them."""
    user = next((one for one in binder.project.parts if one.base is part), None)
    if user is None:
        return ""
    design, one = part.problem.design, taken(part.problem, part.solution.construction.candidates)
    assert one is not None  # else nothing could use it
    read, answers = one.values, part.solution.answers
    as_read = {key: drawn_number(answers[key]) if key in answers else _mm(value) for key, value in read.items()}
    rows = [
        (f"${named.symbol}$", as_read[named.key], _mm(user.taken[named.key]))
        for named in design.quantities()
        if named.key in read and design.is_length(named.key)
    ]
    title = Words("量得的尺寸与取用的尺寸", "Lengths as read and as taken")
    return binder.press.table(title, _TAKEN[binder.lang], rows, "lrr")


def _mm(value: float) -> str:
    return f"{value:.1f}".replace("-", "−")
