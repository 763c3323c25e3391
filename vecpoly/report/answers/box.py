"""The box of answers of a problem: a line for each asked quantity, then what was concluded beside them."""

from __future__ import annotations

from collections.abc import Iterable

from ...solution import Answer, Solution
from ...words import Lang
from ..flow.results.box import AnswerBox
from .line import answer_line


def answer_box(
    solution: Solution, lang: Lang, said: Iterable[str] = (), answers: Iterable[Answer] | None = None
) -> AnswerBox:
    """Every asked quantity once, in the order in which it was asked; said: conclusions that are no quantity."""
    lines = [answer_line(one, solution.problem, lang) for one in answers or solution.answers.values()]
    return AnswerBox(lines, tuple(said), lang)
