"""The box of answers of a problem: what was asked, one quantity a cell, then the notes on them and what was concluded
beside them."""

from __future__ import annotations

from collections.abc import Iterable

from ...solution import Answer, Solution
from ...words import Lang
from ..flow.results.box import AnswerBox
from .line import answer_line
from .notes import notes_of
from .order import arranged, broken


def answer_box(
    solution: Solution, lang: Lang, said: Iterable[str] = (), answers: Iterable[Answer] | None = None
) -> AnswerBox:
    """Every asked quantity once, by solutions or kinds; said: conclusions that are no quantity."""
    parts = arranged(answers or solution.answers.values())
    idle = broken(solution)
    notes = notes_of([one for part in parts for one in part.answers], lang)
    lines = [
        answer_line(one, solution, lang, heading=part.heading(lang, idle)) for part in parts for one in part.answers
    ]
    return AnswerBox(lines, tuple(said), lang, notes)
