"""The box of answers of a problem: what was asked, one quantity a cell, as symbol = value (direction); then the
notes on them and what was concluded beside them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ...solution import Answer, Solution
from ...words import Lang
from ..flow.results.box import AnswerBox
from .alike import twins
from .line import answer_line
from .notes import notes_of
from .order import arranged, broken


def answer_box(
    solution: Solution, lang: Lang, said: Iterable[str] = (), answers: Iterable[Answer] | None = None
) -> AnswerBox:
    """Every asked quantity once, by solutions or kinds; said: conclusions that are no quantity."""
    parts = arranged(answers or solution.answers.values())
    idle = broken(solution)
    every = [one for part in parts for one in part.answers]
    notes = notes_of(every, lang)
    same = twins(every)
    lines = [
        answer_line(one, solution, lang, heading=part.heading(lang, idle), also=_also(one, same), read=False)
        for part in parts
        for one in part.answers
        if one.key not in same
    ]
    return AnswerBox(lines, tuple(said), lang, notes)


def _also(answer: Answer, same: Mapping[str, Answer]) -> tuple[str, ...]:
    """The keys of what is the same vector."""
    return tuple(key for key, first in same.items() if first is answer)
