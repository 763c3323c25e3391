"""The box of answers of a problem: a line for each asked quantity, then what was concluded beside them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from ...solution import Answer, Solution
from ...words import Lang
from ..flow.results.box import AnswerBox
from ..statement.groups import by_groups, parted
from .line import AnswerLine, answer_line


def answer_box(
    solution: Solution, lang: Lang, said: Iterable[str] = (), answers: Iterable[Answer] | None = None
) -> AnswerBox:
    """Every asked quantity once, many of them by their kinds; said: conclusions that are no quantity."""
    lines = [answer_line(one, solution.problem, lang) for one in answers or solution.answers.values()]
    return AnswerBox(_by_kinds(lines), tuple(said), lang)


def _by_kinds(lines: list[AnswerLine]) -> list[AnswerLine]:
    """A long list by kinds: velocities, angular velocities, accelerations."""
    if not parted([one.key for one in lines]):
        return lines
    kinds = by_groups(lines, key=lambda one: one.key)
    return [replace(one, group=number) for number, (_, some) in enumerate(kinds) for one in some]
