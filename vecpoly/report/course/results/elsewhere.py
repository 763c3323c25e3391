"""Steps that only another position needs: lengths on paper that no rule reads there, as to a centre off the sheet."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from ....algebra.formula import Node, plain
from ....board.construction import Step
from ....printed.told import EQUALS
from ....solution import Solution
from ....words import Lang, Words
from ...on_paper import on_paper
from ...steps.lines import displayed, with_results
from ...steps.pointing import pointed
from ..numbering import Press

_ON_PAPER, _WORKED = " mm", 3  # how a length on paper ends; signs of equality of one that was not read off


def own_steps(given: Solution, others: Iterable[tuple[str, Solution]], press: Press) -> list[dict[str, Any]]:
    """The steps of other positions (told, drawn) in which a length on paper is worked out that the given position
    reads, or does without: their words and formulas."""
    known = {_symbol(line) for step in given.construction.steps for line in step.formulas}
    return [
        {
            "words": _there(where, step, solution, press.lang),
            "formulas": [press.objects.add("f", pointed(line, press.lang)) for line in displayed(step, solution)],
        }
        for where, solution in others
        for step in _new(solution, known)
    ]


def _new(solution: Solution, known: set[str]) -> Iterator[Step]:
    """Each length once: in the step that works it out first."""
    told = set(known)
    for step in solution.construction.steps:
        if any(_is_worked(line) and _symbol(line) not in told for line in step.formulas):
            yield step
        told |= {_symbol(line) for line in step.formulas}


def _there(where: str, step: Step, solution: Solution, lang: Lang) -> str:
    words = with_results(on_paper(step.words.of(lang), solution), step, solution, lang)
    return Words(f"{where} 时，", f"At {where}: ").of(lang) + words


def _symbol(line: Node) -> str:
    return plain(line).split(EQUALS)[0]


def _is_worked(line: Node) -> bool:
    return plain(line).endswith(_ON_PAPER) and plain(line).count(EQUALS) == _WORKED
